// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SideJunctions.h"

#include "BoxTree.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

BoxTree MakeVertexTree(const NormalForm& form, const std::vector<BorderPiece>& pieces)
{
  std::vector<int> vertices;
  for (const BorderPiece& piece : pieces)
  {
    vertices.push_back(piece.From);
    vertices.push_back(piece.To);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<std::pair<int, Box>> items;
  items.reserve(vertices.size());
  for (const int vertex : vertices)
  {
    items.emplace_back(vertex, BoxOf(form.Mesh.Points[vertex]));
  }
  return BoxTree(std::move(items));
}

enum class Place
{
  Off,
  Near,
  On
};

/** Where a point lies from the open side a b; `position` is 0 at a and 1 at b. */
Place FindPlace(
  const Point2& a, const Point2& b, const Point2& point, double distance, double& position)
{
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double length = std::hypot(x, y);
  position = ((point.x - a.x) * (x / length) + (point.y - a.y) * (y / length)) / length;
  const auto isLess = [](const Point2& p, const Point2& q)
  { return p.x < q.x || (p.x == q.x && p.y < q.y); };
  const auto [low, high] = std::minmax(a, b, isLess);
  if (isLess(low, point) && isLess(point, high) && Orientation(a, b, point) == 0)
  {
    return Place::On;
  }
  const double height = std::abs((x / length) * (point.y - a.y) - (y / length) * (point.x - a.x));
  const bool isNearEnd = std::hypot(point.x - a.x, point.y - a.y) <= distance ||
    std::hypot(point.x - b.x, point.y - b.y) <= distance;
  return height <= distance && position > 0.0 && position < 1.0 && !isNearEnd ? Place::Near
                                                                              : Place::Off;
}

bool HasVertex(const NormalForm& form, int element, int vertex)
{
  const std::span<const int> vertices = form.Mesh.Element(element);
  return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
}

} // namespace

std::vector<Junction> FindJunctions(
  const NormalForm& form, const std::vector<BorderPiece>& pieces, double distance)
{
  const BoxTree tree = MakeVertexTree(form, pieces);
  std::vector<Junction> junctions;
  std::vector<std::pair<double, Junction>> ofPiece;
  for (const BorderPiece& piece : pieces)
  {
    const Point2& a = form.Mesh.Points[piece.From];
    const Point2& b = form.Mesh.Points[piece.To];
    ofPiece.clear();
    tree.Query(Inflated(BoxOf(a, b), distance),
      [&](int vertex)
      {
        double position = 0.0;
        const Place place = vertex == piece.From || vertex == piece.To
          ? Place::Off
          : FindPlace(a, b, form.Mesh.Points[vertex], distance, position);
        if (place != Place::Off && !HasVertex(form, piece.Element, vertex))
        {
          ofPiece.push_back(
            { position, { piece.Element, piece.From, piece.To, vertex, place == Place::On } });
        }
        return true;
      });
    std::sort(ofPiece.begin(), ofPiece.end(),
      [](const auto& p, const auto& q)
      { return p.first < q.first || (p.first == q.first && p.second.Vertex < q.second.Vertex); });
    for (const auto& [position, junction] : ofPiece)
    {
      junctions.push_back(junction);
    }
  }
  return junctions;
}

} // namespace pemesh

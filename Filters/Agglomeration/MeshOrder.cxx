// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshOrder.h"

#include "HilbertCurve.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pemesh
{

namespace
{

/** Where a double in [0, 1] falls in 2^31 cells. */
std::uint32_t CellOf(double fraction)
{
  return static_cast<std::uint32_t>(std::clamp(fraction, 0.0, 1.0) * 2147483647.0);
}

std::vector<int> SortElements(const PolygonMesh& mesh)
{
  Point2 low = mesh.Points[mesh.Vertices[0]];
  Point2 high = low;
  for (const int vertex : mesh.Vertices)
  {
    const Point2& point = mesh.Points[vertex];
    low = { std::min(low.x, point.x), std::min(low.y, point.y) };
    high = { std::max(high.x, point.x), std::max(high.y, point.y) };
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(static_cast<std::size_t>(mesh.NumberOfElements()));
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    mesh.GetVertices(element, vertices);
    const Point2 center = Centroid(vertices);
    keys.emplace_back(
      HilbertKey(CellOf((center.x - low.x) / size), CellOf((center.y - low.y) / size)), element);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [key, element] : keys)
  {
    order.push_back(element);
  }
  return order;
}

} // namespace

OrderedMesh OrderAlongCurve(const PolygonMesh& mesh, const MeshAdjacency& adjacency)
{
  OrderedMesh ordered;
  ordered.OldElement = SortElements(mesh);
  std::vector<int> newPoint(mesh.Points.size(), -1);
  std::vector<int> newSide(mesh.Vertices.size());
  ordered.Mesh.Offsets.reserve(mesh.Offsets.size());
  ordered.Mesh.Vertices.reserve(mesh.Vertices.size());
  for (const int old : ordered.OldElement)
  {
    for (int side = mesh.Offsets[old]; side < mesh.Offsets[old + 1]; ++side)
    {
      int& point = newPoint[mesh.Vertices[side]];
      if (point < 0)
      {
        point = static_cast<int>(ordered.OldPoint.size());
        ordered.OldPoint.push_back(mesh.Vertices[side]);
        ordered.Mesh.Points.push_back(mesh.Points[mesh.Vertices[side]]);
      }
      newSide[side] = ordered.Mesh.NumberOfSides();
      ordered.Mesh.Vertices.push_back(point);
    }
    ordered.Mesh.Offsets.push_back(ordered.Mesh.NumberOfSides());
  }
  ordered.Adjacency.Twin.resize(mesh.Vertices.size());
  ordered.Adjacency.Element.resize(mesh.Vertices.size());
  int side = 0;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    for (int old = mesh.Offsets[ordered.OldElement[element]];
         side < ordered.Mesh.Offsets[element + 1]; ++old, ++side)
    {
      const int twin = adjacency.Twin[old];
      ordered.Adjacency.Twin[side] = twin < 0 ? twin : newSide[twin];
      ordered.Adjacency.Element[side] = element;
    }
  }
  return ordered;
}

} // namespace pemesh

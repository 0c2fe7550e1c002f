// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The checks of points: equal, nearly equal, unused.
 */
#include "BoxTree.h"
#include "CheckFunctions.h"
#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

std::string NameOf(int vertex)
{
  return "Vertex " + std::to_string(vertex);
}

bool AreJoined(const NormalForm& form, const std::vector<int>& elements, int a, int b)
{
  for (const int element : elements)
  {
    const std::span<const int> vertices = form.Mesh.Element(element);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const int from = vertices[i];
      const int to = vertices[(i + 1) % vertices.size()];
      if ((from == a && to == b) || (from == b && to == a))
      {
        return true;
      }
    }
  }
  return false;
}

/** Pairs (larger, smaller) of vertices at most that far apart, sorted. */
std::vector<std::pair<int, int>> FindNearPairs(const NormalForm& form, double distance)
{
  // More are counted for no vertex: where many are as near as rounding, all are beside the point.
  constexpr int MostOfOne = 16;
  std::vector<std::pair<int, Box>> items;
  for (std::size_t i = 0; i < form.Original.size(); ++i)
  {
    if (form.Original[i] == static_cast<int>(i))
    {
      items.emplace_back(static_cast<int>(i), BoxOf(form.Mesh.Points[i]));
    }
  }
  const std::vector<std::pair<int, Box>> vertices = items;
  const BoxTree tree(std::move(items));
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [vertex, box] : vertices)
  {
    int found = 0;
    tree.Query(Inflated(box, distance),
      [&, vertex = vertex](int other)
      {
        const Point2& a = form.Mesh.Points[vertex];
        const Point2& b = form.Mesh.Points[other];
        if (other < vertex && std::hypot(a.x - b.x, a.y - b.y) <= distance)
        {
          pairs.emplace_back(vertex, other);
          ++found;
        }
        return found < MostOfOne;
      });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace

void CheckDuplicateVertices(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  const std::size_t points = form.Original.size();
  std::vector<unsigned char> isCopy(points, 0);
  for (std::size_t i = 0; i < points; ++i)
  {
    isCopy[i] = form.Original[i] >= 0 && form.Original[i] != static_cast<int>(i);
  }
  if (std::find(isCopy.begin(), isCopy.end(), 1) == isCopy.end())
  {
    return;
  }
  const ElementsAround around(mesh.GetMesh(), isCopy);
  for (int vertex = 0; vertex < static_cast<int>(points); ++vertex)
  {
    if (isCopy[vertex])
    {
      const int original = form.Original[vertex];
      const int both[2] = { original, vertex };
      findings.Add(around.Get(vertex), both, form.Mesh.Points[vertex],
        [&] {
          return NameOf(vertex) + " is at the place of vertex " + std::to_string(original) + ".";
        });
    }
  }
}

void CheckNearVertices(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  const double distance = mesh.GetOptions().Tolerance * form.Diagonal;
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    return;
  }
  const std::vector<std::pair<int, int>> pairs = FindNearPairs(form, distance);
  if (pairs.empty())
  {
    return;
  }
  std::vector<unsigned char> isNear(form.Original.size(), 0);
  for (const auto& [vertex, other] : pairs)
  {
    isNear[vertex] = 1;
  }
  const ElementsAround around(form.Mesh, isNear);
  for (const auto& [vertex, other] : pairs)
  {
    const std::vector<int> elements = around.Get(vertex);
    const int both[2] = { other, vertex };
    const Point2& a = form.Mesh.Points[vertex];
    const Point2& b = form.Mesh.Points[other];
    findings.Add(elements, both, a,
      [&, vertex = vertex, other = other]
      {
        return NameOf(vertex) + " is at a distance of " +
          FormatNumber(std::hypot(a.x - b.x, a.y - b.y)) + " from vertex " + std::to_string(other) +
          (AreJoined(form, elements, vertex, other) ? ", at the other end of a side."
                                                    : ", and no side joins them.");
      });
  }
}

void CheckUnusedPoints(MeshUnderCheck& mesh, FindingList& findings)
{
  std::vector<unsigned char> isUsed(mesh.GetMesh().Points.size(), 0);
  for (const int vertex : mesh.GetMesh().Vertices)
  {
    if (mesh.IsInRange(vertex))
    {
      isUsed[vertex] = 1;
    }
  }
  for (int point = 0; point < static_cast<int>(isUsed.size()); ++point)
  {
    if (!isUsed[point])
    {
      findings.Add({}, { point }, mesh.GetMesh().Points[point],
        [&] { return "Point " + std::to_string(point) + " is in no element."; });
    }
  }
}

} // namespace pemesh

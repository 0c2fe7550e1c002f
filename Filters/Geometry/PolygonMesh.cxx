// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonMesh.h"

#include <algorithm>
#include <utility>

namespace pemesh
{

namespace
{

std::pair<int, int> EndsOf(const PolygonMesh& mesh, const MeshAdjacency& adjacency, int side)
{
  return { mesh.Vertices[side], mesh.Vertices[NextSide(mesh, adjacency.Element[side], side)] };
}

/** The sides of a group run between the same two vertices. */
void MatchGroup(const PolygonMesh& mesh, const std::vector<int>& group, MeshAdjacency& adjacency)
{
  if (group.size() == 1)
  {
    adjacency.Twin[group[0]] = MeshAdjacency::Border;
    return;
  }
  const bool isPair = group.size() == 2 && mesh.Vertices[group[0]] != mesh.Vertices[group[1]];
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    adjacency.Twin[group[i]] = isPair ? group[1 - i] : MeshAdjacency::Conflict;
  }
}

} // namespace

MeshAdjacency FindAdjacency(const PolygonMesh& mesh)
{
  MeshAdjacency adjacency;
  adjacency.Twin.assign(mesh.Vertices.size(), MeshAdjacency::Border);
  adjacency.Element.resize(mesh.Vertices.size());
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    std::fill(adjacency.Element.begin() + mesh.Offsets[element],
      adjacency.Element.begin() + mesh.Offsets[element + 1], element);
  }
  // Sides are sorted by the smaller of their ends by counting, then compared a vertex at a time.
  std::vector<int> first(mesh.Points.size() + 1, 0);
  const auto smallerEnd = [&](int side)
  {
    const auto [from, to] = EndsOf(mesh, adjacency, side);
    return std::min(from, to);
  };
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    ++first[smallerEnd(side) + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    first[i] += first[i - 1];
  }
  std::vector<int> sorted(mesh.Vertices.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    sorted[next[smallerEnd(side)]++] = side;
  }
  std::vector<std::pair<int, int>> ends; // the larger end, the side
  std::vector<int> group;
  for (std::size_t vertex = 0; vertex + 1 < first.size(); ++vertex)
  {
    ends.clear();
    for (int i = first[vertex]; i < first[vertex + 1]; ++i)
    {
      const auto [from, to] = EndsOf(mesh, adjacency, sorted[i]);
      ends.emplace_back(std::max(from, to), sorted[i]);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size();)
    {
      group.clear();
      const int end = ends[i].first;
      for (; i < ends.size() && ends[i].first == end; ++i)
      {
        group.push_back(ends[i].second);
      }
      MatchGroup(mesh, group, adjacency);
    }
  }
  return adjacency;
}

std::vector<int> RemoveUnusedPoints(PolygonMesh& mesh)
{
  std::vector<int> number(mesh.Points.size(), -1);
  for (const int vertex : mesh.Vertices)
  {
    number[vertex] = 0;
  }
  int kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    if (number[i] == 0)
    {
      mesh.Points[kept] = mesh.Points[i];
      number[i] = kept++;
    }
  }
  mesh.Points.resize(kept);
  for (int& vertex : mesh.Vertices)
  {
    vertex = number[vertex];
  }
  return number;
}

} // namespace pemesh

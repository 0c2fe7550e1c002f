// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationInput.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pemesh
{

namespace
{

/** What a loop of the border is compared by. */
struct BorderLoop
{
  std::vector<int> Vertices;
  std::vector<Point2> Points;
  Point2 Low;
  Point2 High;
};

std::string NameOf(const Point2& point)
{
  return "(" + std::to_string(point.x) + ", " + std::to_string(point.y) + ")";
}

/** Turns left everywhere and goes round once: simple without asking about pairs of edges. */
bool IsStrictlyConvex(PolygonView polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (Orientation(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0)
    {
      return false;
    }
  }
  return n == 3 || IsConvex(polygon);
}

std::string WhyElementsUnusable(const PolygonMesh& mesh)
{
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    mesh.GetVertices(element, vertices);
    const std::string name = "Element " + std::to_string(element) + " ";
    if (vertices.size() < 3 || !AreFinite(vertices))
    {
      return name + "has fewer than three vertices or a coordinate that is not finite.";
    }
    if (IsStrictlyConvex(vertices))
    {
      continue;
    }
    const std::string why = WhyNotSimple(vertices);
    if (!why.empty())
    {
      return name + why + ".";
    }
    if (PolygonOrientation(vertices) <= 0)
    {
      return name + "is clockwise; reverse its vertices.";
    }
  }
  return {};
}

std::string WhySidesDoNotMatch(const PolygonMesh& mesh, const MeshAdjacency& adjacency)
{
  const auto conflict =
    std::find(adjacency.Twin.begin(), adjacency.Twin.end(), MeshAdjacency::Conflict);
  if (conflict == adjacency.Twin.end())
  {
    return {};
  }
  const auto side = static_cast<std::size_t>(conflict - adjacency.Twin.begin());
  return "A side of element " + std::to_string(adjacency.Element[side]) + " at vertex " +
    std::to_string(mesh.Vertices[side]) +
    " belongs to more than two elements, or to two that overlap.";
}

/** The loops of the border; a sentence if two of them have a vertex in common. */
std::string FindBorderLoops(
  const PolygonMesh& mesh, const MeshAdjacency& adjacency, std::vector<BorderLoop>& loops)
{
  std::vector<int> next(mesh.Points.size(), -1);
  std::vector<int> starts;
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    if (adjacency.Twin[side] != MeshAdjacency::Border)
    {
      continue;
    }
    const int vertex = mesh.Vertices[side];
    if (next[vertex] >= 0)
    {
      return "The mesh is not conforming: its border touches itself at vertex " +
        std::to_string(vertex) + ".";
    }
    next[vertex] = mesh.Vertices[NextSide(mesh, adjacency.Element[side], side)];
    starts.push_back(vertex);
  }
  for (const int start : starts)
  {
    BorderLoop loop;
    for (int vertex = start; next[vertex] >= 0;)
    {
      loop.Vertices.push_back(vertex);
      loop.Points.push_back(mesh.Points[vertex]);
      const int after = next[vertex];
      next[vertex] = -1;
      vertex = after;
    }
    if (loop.Vertices.empty())
    {
      continue;
    }
    loop.Low = loop.High = loop.Points.front();
    for (const Point2& point : loop.Points)
    {
      loop.Low = { std::min(loop.Low.x, point.x), std::min(loop.Low.y, point.y) };
      loop.High = { std::max(loop.High.x, point.x), std::max(loop.High.y, point.y) };
    }
    loops.push_back(std::move(loop));
  }
  return {};
}

std::string WhyLoopsMeet(std::vector<BorderLoop>& loops)
{
  for (const BorderLoop& loop : loops)
  {
    if (const auto crossing = FindSelfCrossing(loop.Points))
    {
      return "The mesh is not conforming: the border crosses or touches itself near " +
        NameOf(loop.Points[crossing->First]) + ", where vertices of one element lie on a side " +
        "of another, or elements overlap.";
    }
  }
  std::sort(loops.begin(), loops.end(),
    [](const BorderLoop& a, const BorderLoop& b)
    { return a.Low.x != b.Low.x ? a.Low.x < b.Low.x : a.Vertices[0] < b.Vertices[0]; });
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (std::size_t j = i + 1; j < loops.size() && loops[j].Low.x <= loops[i].High.x; ++j)
    {
      const bool apart = loops[j].High.y < loops[i].Low.y || loops[i].High.y < loops[j].Low.y;
      if (!apart && DoBoundariesMeet(loops[i].Points, loops[j].Points))
      {
        return "The mesh is not conforming: two loops of its border meet near " +
          NameOf(loops[j].Points[0]) + ".";
      }
    }
  }
  return {};
}

/** Further turns of the elements about vertices, summed over the mesh. */
long CountExtraTurns(
  const PolygonMesh& mesh, const MeshAdjacency& adjacency, const std::vector<BorderLoop>& loops)
{
  std::vector<bool> used(mesh.Points.size(), false);
  for (const int vertex : mesh.Vertices)
  {
    used[vertex] = true;
  }
  const auto border =
    std::count(adjacency.Twin.begin(), adjacency.Twin.end(), MeshAdjacency::Border);
  const long vertices = static_cast<long>(std::count(used.begin(), used.end(), true));
  const long edges = (mesh.NumberOfSides() + static_cast<long>(border)) / 2;
  long turns = 0;
  for (const BorderLoop& loop : loops)
  {
    turns += PolygonOrientation(loop.Points);
  }
  return turns - (vertices - edges + mesh.NumberOfElements());
}

} // namespace

std::string WhyNotAgglomerable(const PolygonMesh& mesh, const MeshAdjacency& adjacency)
{
  if (mesh.NumberOfElements() == 0)
  {
    return "The mesh has no elements.";
  }
  std::string why = WhyElementsUnusable(mesh);
  if (why.empty())
  {
    why = WhySidesDoNotMatch(mesh, adjacency);
  }
  std::vector<BorderLoop> loops;
  if (why.empty())
  {
    why = FindBorderLoops(mesh, adjacency, loops);
  }
  if (why.empty())
  {
    why = WhyLoopsMeet(loops);
  }
  if (why.empty() && CountExtraTurns(mesh, adjacency, loops) != 0)
  {
    why = "The mesh overlaps itself: elements wind more than once about a vertex.";
  }
  return why;
}

} // namespace pemesh

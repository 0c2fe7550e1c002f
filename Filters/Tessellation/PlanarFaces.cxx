// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlanarFaces.h"

#include "Predicates.h"

#include <algorithm>
#include <tuple>

namespace pemesh
{

namespace
{

bool ComesBefore(const HalfEdge& a, const HalfEdge& b)
{
  return std::tie(a.From, a.To) < std::tie(b.From, b.To);
}

/** Directions from an origin in counter-clockwise order, starting from the east. */
class AroundOrigin
{
public:
  explicit AroundOrigin(const Point2& origin)
    : Origin(origin)
  {
  }
  bool operator()(const Point2& a, const Point2& b) const
  {
    const bool aIsUpper = this->IsUpper(a);
    const bool bIsUpper = this->IsUpper(b);
    return aIsUpper != bIsUpper ? aIsUpper : Orientation(this->Origin, a, b) > 0;
  }

private:
  bool IsUpper(const Point2& point) const
  {
    return point.y > this->Origin.y || (point.y == this->Origin.y && point.x > this->Origin.x);
  }
  Point2 Origin;
};

int FindEdge(const std::vector<HalfEdge>& edges, int from, int to)
{
  const HalfEdge wanted = { from, to, {} };
  return static_cast<int>(
    std::lower_bound(edges.begin(), edges.end(), wanted, ComesBefore) - edges.begin());
}

/** The edge that follows each in its face: the next one clockwise from the way back. */
std::vector<int> FindSuccessors(
  const std::vector<Point2>& points, const std::vector<HalfEdge>& edges)
{
  std::vector<int> next(edges.size());
  std::vector<int> around;
  for (std::size_t first = 0; first < edges.size();)
  {
    const int vertex = edges[first].From;
    around.clear();
    for (; first < edges.size() && edges[first].From == vertex; ++first)
    {
      around.push_back(static_cast<int>(first));
    }
    const AroundOrigin isBefore(points[vertex]);
    std::stable_sort(around.begin(), around.end(),
      [&](int a, int b) { return isBefore(points[edges[a].To], points[edges[b].To]); });
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      const int back = FindEdge(edges, edges[around[i]].To, vertex);
      next[back] = around[(i + around.size() - 1) % around.size()];
    }
  }
  return next;
}

} // namespace

void LeftSide::Merge(const LeftSide& other)
{
  this->Cell = std::max(this->Cell, other.Cell);
  this->InDomain = this->InDomain || other.InDomain;
  this->OffDomain = this->OffDomain || other.OffDomain;
}

void MergeRepetitions(std::vector<HalfEdge>& edges)
{
  std::stable_sort(edges.begin(), edges.end(), ComesBefore);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (kept > 0 && edges[kept - 1].From == edges[i].From && edges[kept - 1].To == edges[i].To)
    {
      edges[kept - 1].Left.Merge(edges[i].Left);
    }
    else
    {
      edges[kept++] = edges[i];
    }
  }
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(kept), edges.end());
}

std::vector<PlanarFace> FindPlanarFaces(
  const std::vector<Point2>& points, std::vector<HalfEdge> edges)
{
  MergeRepetitions(edges);
  const std::vector<int> next = FindSuccessors(points, edges);
  std::vector<bool> done(edges.size(), false);
  std::vector<PlanarFace> faces;
  for (std::size_t first = 0; first < edges.size(); ++first)
  {
    if (done[first])
    {
      continue;
    }
    PlanarFace face;
    for (int edge = static_cast<int>(first); !done[edge]; edge = next[edge])
    {
      done[edge] = true;
      face.Vertices.push_back(edges[edge].From);
      face.Left.Merge(edges[edge].Left);
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

} // namespace pemesh

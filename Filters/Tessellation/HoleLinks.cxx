// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HoleLinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace pemesh
{

namespace
{

constexpr double Unbounded = std::numeric_limits<double>::infinity();

/** How often each loop meets edges of cells. */
std::vector<int> CountContacts(const BoundaryContacts& contacts)
{
  std::vector<int> counts(static_cast<std::size_t>(contacts.DomainEdges.back().Loop) + 1, 0);
  for (std::size_t edge = 0; edge < contacts.HasContact.size(); ++edge)
  {
    counts[contacts.DomainEdges[edge].Loop] += contacts.HasContact[edge] ? 1 : 0;
  }
  for (const auto& [edge, points] : contacts.OnDomainEdges)
  {
    counts[contacts.DomainEdges[edge].Loop] += static_cast<int>(points.size());
  }
  return counts;
}

/** Where an edge is at a height between its ends: at both ends if it is horizontal. */
std::array<double, 2> CrossingsAt(double y, const Point2& a, const Point2& b)
{
  if (a.y == b.y)
  {
    return { a.x, b.x };
  }
  const double share = (y - a.y) / (b.y - a.y);
  const double x = y == b.y ? b.x : a.x + share * (b.x - a.x);
  return { x, x };
}

double Distance(const Point2& a, const Point2& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

/** Splits edges, given from the smaller to the greater number, and their way back. */
void SplitEdges(PointsOnEdges& points, std::vector<HalfEdge>& edges)
{
  std::vector<HalfEdge> pieces;
  const auto split = [&pieces](const HalfEdge& edge, const std::vector<PointOnEdge>& inside)
  {
    int from = edge.From;
    for (const PointOnEdge& point : inside)
    {
      pieces.push_back({ from, point.Point, edge.Left });
      from = point.Point;
    }
    pieces.push_back({ from, edge.To, edge.Left });
  };
  std::map<std::pair<int, int>, int> numberOf;
  for (auto& [edge, inside] : points)
  {
    std::sort(inside.begin(), inside.end(),
      [](const PointOnEdge& a, const PointOnEdge& b) { return a.Position < b.Position; });
    numberOf[{ edges[edge].From, edges[edge].To }] = edge;
  }
  for (const HalfEdge& edge : edges)
  {
    const auto found = numberOf.find(std::minmax(edge.From, edge.To));
    if (found == numberOf.end())
    {
      pieces.push_back(edge);
      continue;
    }
    std::vector<PointOnEdge> inside = points[found->second];
    if (edge.From > edge.To)
    {
      std::reverse(inside.begin(), inside.end());
    }
    split(edge, inside);
  }
  edges.swap(pieces);
}

} // namespace

HoleLinks::HoleLinks(const BoundaryContacts& contacts)
{
  const std::vector<Point2>& points = contacts.Cells.Points;
  const auto isLess = [&points](int a, int b)
  { return std::tie(points[a].x, points[a].y) < std::tie(points[b].x, points[b].y); };
  const std::vector<DomainEdge>& edges = contacts.DomainEdges;
  const std::vector<int> contactsOfLoop = CountContacts(contacts);
  std::vector<std::pair<int, int>> extremes(contactsOfLoop.size(), { -1, -1 }); // edges
  for (int edge = 0; edge < static_cast<int>(edges.size()); ++edge)
  {
    auto& [least, greatest] = extremes[edges[edge].Loop];
    least = least < 0 || isLess(edges[edge].From, edges[least].From) ? edge : least;
    greatest = greatest < 0 || isLess(edges[greatest].From, edges[edge].From) ? edge : greatest;
  }
  const auto add = [&](int edge, double direction)
  {
    if (!contacts.HasContact[edge]) // else the vertex is joined to a cell as it is
    {
      Ray& ray = this->Rays.emplace_back();
      ray.Vertex = edges[edge].From;
      ray.Origin = points[ray.Vertex];
      ray.Direction = direction;
    }
  };
  for (std::size_t loop = 1; loop < extremes.size(); ++loop)
  {
    if (contactsOfLoop[loop] < 2)
    {
      add(extremes[loop].first, -1.0);
      add(extremes[loop].second, 1.0);
    }
  }
  std::sort(this->Rays.begin(), this->Rays.end(),
    [](const Ray& a, const Ray& b)
    { return std::tie(a.Origin.y, a.Vertex) < std::tie(b.Origin.y, b.Vertex); });
}

void HoleLinks::Reset()
{
  for (Ray& ray : this->Rays)
  {
    ray.Length = Unbounded;
    ray.Edge = -1;
  }
}

/** Shortens the rays that an edge stops. */
void HoleLinks::Meet(const std::vector<Point2>& points, int from, int to, int edge)
{
  const Point2& a = points[from];
  const Point2& b = points[to];
  const auto [low, high] = std::minmax(a.y, b.y);
  auto ray = std::lower_bound(this->Rays.begin(), this->Rays.end(), low,
    [](const Ray& candidate, double y) { return candidate.Origin.y < y; });
  for (; ray != this->Rays.end() && ray->Origin.y <= high; ++ray)
  {
    if (ray->Vertex == from || ray->Vertex == to)
    {
      continue;
    }
    for (const double x : CrossingsAt(ray->Origin.y, a, b))
    {
      const double length = (x - ray->Origin.x) * ray->Direction;
      if (length > 0.0 && length < ray->Length)
      {
        ray->Length = length;
        ray->Landing = { x, ray->Origin.y };
        ray->Edge = edge;
      }
    }
  }
}

void HoleLinks::MarkCells(const BoundaryContacts& contacts, std::vector<bool>& isCut)
{
  if (this->Rays.empty())
  {
    return;
  }
  this->Reset();
  for (int side = 0; side < contacts.Cells.NumberOfSides(); ++side)
  {
    if (contacts.EdgeOf(side) == side)
    {
      this->Meet(contacts.Cells.Points, contacts.Cells.Vertices[side], contacts.EndOf(side), side);
    }
  }
  for (const Ray& ray : this->Rays)
  {
    if (ray.Edge >= 0)
    {
      isCut[contacts.Adjacency.Element[ray.Edge]] = true;
      const int twin = contacts.Adjacency.Twin[ray.Edge];
      if (twin >= 0)
      {
        isCut[contacts.Adjacency.Element[twin]] = true;
      }
    }
  }
}

void HoleLinks::AddTo(double tolerance, std::vector<Point2>& points, std::vector<HalfEdge>& edges)
{
  if (this->Rays.empty())
  {
    return;
  }
  this->Reset();
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (edges[edge].From < edges[edge].To)
    {
      this->Meet(points, edges[edge].From, edges[edge].To, static_cast<int>(edge));
    }
  }
  PointsOnEdges landings;
  for (const Ray& ray : this->Rays)
  {
    if (ray.Edge < 0)
    {
      continue;
    }
    const HalfEdge edge = edges[ray.Edge];
    std::vector<PointOnEdge> candidates = { { 0.0, edge.From }, { 1.0, edge.To } };
    std::vector<PointOnEdge>& onEdge = landings[ray.Edge];
    candidates.insert(candidates.end(), onEdge.begin(), onEdge.end());
    const auto near = std::find_if(candidates.begin(), candidates.end(),
      [&](const PointOnEdge& candidate)
      { return Distance(points[candidate.Point], ray.Landing) < tolerance; });
    const int end = near != candidates.end() ? near->Point : static_cast<int>(points.size());
    if (near == candidates.end())
    {
      points.push_back(ray.Landing);
      onEdge.push_back({ Distance(points[edge.From], ray.Landing), end });
    }
    edges.push_back({ ray.Vertex, end, {} });
    edges.push_back({ end, ray.Vertex, {} });
  }
  SplitEdges(landings, edges);
}

} // namespace pemesh

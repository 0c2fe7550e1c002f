// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryContacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace pemesh
{

namespace
{

/** A horizontal line from a vertex of a hole to the first edge it meets. */
struct Ray
{
  Point2 Origin;
  int Vertex = -1;
  double Direction = 1.0; ///< 1 to the right, -1 to the left
  double Length = std::numeric_limits<double>::infinity();
  Point2 Landing;
  int Edge = -1;
  bool IsDomainEdge = false;
};

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

/** From the leftmost vertex of a hole to the left, from the rightmost one to the right. */
std::vector<Ray> MakeRays(const BoundaryContacts& contacts)
{
  const std::vector<int> contactsOfLoop = CountContacts(contacts);
  const std::vector<Point2>& points = contacts.Cells.Points;
  const auto isLess = [&points](int a, int b)
  { return std::tie(points[a].x, points[a].y) < std::tie(points[b].x, points[b].y); };
  const std::vector<DomainEdge>& edges = contacts.DomainEdges;
  std::vector<std::pair<int, int>> extremes(contactsOfLoop.size(), { -1, -1 }); // of the edges
  for (int edge = 0; edge < static_cast<int>(edges.size()); ++edge)
  {
    auto& [least, greatest] = extremes[edges[edge].Loop];
    least = least < 0 || isLess(edges[edge].From, edges[least].From) ? edge : least;
    greatest = greatest < 0 || isLess(edges[greatest].From, edges[edge].From) ? edge : greatest;
  }
  std::vector<Ray> rays;
  const auto add = [&](int edge, double direction)
  {
    if (!contacts.HasContact[edge]) // else the vertex is joined to a cell as it is
    {
      Ray& ray = rays.emplace_back();
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
  std::sort(rays.begin(), rays.end(),
    [](const Ray& a, const Ray& b)
    { return std::tie(a.Origin.y, a.Vertex) < std::tie(b.Origin.y, b.Vertex); });
  return rays;
}

class RayShooter
{
public:
  explicit RayShooter(std::vector<Ray>& rays)
    : Rays(rays)
  {
  }

  /** Shortens the rays that an edge stops. */
  void Meet(const BoundaryContacts& contacts, int from, int to, int edge, bool isDomainEdge)
  {
    const Point2& a = contacts.Cells.Points[from];
    const Point2& b = contacts.Cells.Points[to];
    const auto [low, high] = std::minmax(a.y, b.y);
    auto ray = std::lower_bound(this->Rays.begin(), this->Rays.end(), low,
      [](const Ray& candidate, double y) { return candidate.Origin.y < y; });
    for (; ray != this->Rays.end() && ray->Origin.y <= high; ++ray)
    {
      if (ray->Vertex == from || ray->Vertex == to)
      {
        continue;
      }
      for (const double x : Crossings(a, b, ray->Origin.y))
      {
        const double length = (x - ray->Origin.x) * ray->Direction;
        if (length > 0.0 && length < ray->Length)
        {
          ray->Length = length;
          ray->Landing = { x, ray->Origin.y };
          ray->Edge = edge;
          ray->IsDomainEdge = isDomainEdge;
        }
      }
    }
  }

private:
  /** Where an edge is at a height between its ends: at both ends if it is horizontal. */
  static std::array<double, 2> Crossings(const Point2& a, const Point2& b, double y)
  {
    if (a.y == b.y)
    {
      return { a.x, b.x };
    }
    const double share = (y - a.y) / (b.y - a.y);
    const double x = y == b.y ? b.x : a.x + share * (b.x - a.x);
    return { x, x };
  }

  std::vector<Ray>& Rays;
};

/** The point in which a ray ends, new on its edge if there is none yet. */
int LandRay(const Ray& ray, double tolerance, BoundaryContacts& contacts)
{
  const int edge = ray.Edge;
  const int from =
    ray.IsDomainEdge ? contacts.DomainEdges[edge].From : contacts.Cells.Vertices[edge];
  const int to = ray.IsDomainEdge ? contacts.DomainEdges[edge].To : contacts.EndOf(edge);
  std::vector<PointOnEdge>& onEdge =
    (ray.IsDomainEdge ? contacts.OnDomainEdges : contacts.OnCellEdges)[edge];
  const std::vector<Point2>& points = contacts.Cells.Points;
  const auto isNear = [&](int point)
  {
    return std::hypot(points[point].x - ray.Landing.x, points[point].y - ray.Landing.y) < tolerance;
  };
  for (const int end : { from, to })
  {
    if (isNear(end))
    {
      contacts.IsTouched[end] = true;
      return end;
    }
  }
  for (const PointOnEdge& candidate : onEdge)
  {
    if (isNear(candidate.Point))
    {
      return candidate.Point;
    }
  }
  const Point2 a = points[from];
  const Point2 b = points[to];
  const double whole = std::hypot(b.x - a.x, b.y - a.y);
  const int landing = static_cast<int>(points.size());
  contacts.Cells.Points.push_back(ray.Landing);
  contacts.IsTouched.push_back(true);
  onEdge.push_back({ std::hypot(ray.Landing.x - a.x, ray.Landing.y - a.y) / whole, landing });
  return landing;
}

} // namespace

void LinkIsolatedHoles(double tolerance, BoundaryContacts& contacts)
{
  std::vector<Ray> rays = MakeRays(contacts);
  if (rays.empty())
  {
    return;
  }
  RayShooter shooter(rays);
  for (int side = 0; side < contacts.Cells.NumberOfSides(); ++side)
  {
    if (contacts.EdgeOf(side) == side)
    {
      shooter.Meet(contacts, contacts.Cells.Vertices[side], contacts.EndOf(side), side, false);
    }
  }
  for (std::size_t edge = 0; edge < contacts.DomainEdges.size(); ++edge)
  {
    const DomainEdge& domainEdge = contacts.DomainEdges[edge];
    shooter.Meet(contacts, domainEdge.From, domainEdge.To, static_cast<int>(edge), true);
  }
  for (const Ray& ray : rays)
  {
    if (ray.Edge >= 0)
    {
      contacts.Links.emplace_back(ray.Vertex, LandRay(ray, tolerance, contacts));
    }
  }
}

} // namespace pemesh

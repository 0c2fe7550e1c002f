// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TessellationInvariants.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Polygon = CGAL::Polygon_2<Kernel>;
using pemesh::Domain;
using pemesh::Point2;
using pemesh::PolygonMesh;

Polygon Exact(const std::vector<Point2>& points)
{
  Polygon polygon;
  for (const Point2& point : points)
  {
    polygon.push_back({ Rational(point.x), Rational(point.y) });
  }
  return polygon;
}

std::vector<std::pair<Point2, Point2>> EdgesOf(const Domain& domain)
{
  std::vector<std::pair<Point2, Point2>> edges;
  const auto add = [&edges](const std::vector<Point2>& loop)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      edges.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    }
  };
  add(domain.Outer);
  std::for_each(domain.Holes.begin(), domain.Holes.end(), add);
  return edges;
}

bool IsAxisParallel(const std::pair<Point2, Point2>& edge)
{
  return edge.first.x == edge.second.x || edge.first.y == edge.second.y;
}

/** Exactly on axis-parallel edges, up to rounding on others. */
bool IsOnEdge(const std::pair<Point2, Point2>& edge, const Point2& point, double scale)
{
  const auto& [a, b] = edge;
  const double rounding = IsAxisParallel(edge) ? 0.0 : 1e-14 * scale;
  const bool isInBox = point.x >= std::min(a.x, b.x) - rounding &&
    point.x <= std::max(a.x, b.x) + rounding && point.y >= std::min(a.y, b.y) - rounding &&
    point.y <= std::max(a.y, b.y) + rounding;
  const double cross = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
  return isInBox && std::abs(cross) <= rounding * std::hypot(b.x - a.x, b.y - a.y);
}

std::string CheckElements(const Domain& domain, const PolygonMesh& mesh)
{
  Rational area = Exact(domain.Outer).area();
  for (const std::vector<Point2>& hole : domain.Holes)
  {
    area -= Exact(hole).area();
  }
  Rational sum = 0;
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    mesh.GetVertices(element, vertices);
    const Polygon polygon = Exact(vertices);
    if (vertices.size() < 3 || !polygon.is_simple() || polygon.area() <= 0)
    {
      return "element " + std::to_string(element) + " is not simple and counter-clockwise";
    }
    sum += polygon.area();
  }
  const auto edges = EdgesOf(domain);
  if (std::all_of(edges.begin(), edges.end(), IsAxisParallel)
      ? sum != area
      : CGAL::abs(sum - area) > area * Rational(1e-12))
  {
    return "the areas add up to " + std::to_string(CGAL::to_double(sum)) + " instead of " +
      std::to_string(CGAL::to_double(area));
  }
  return {};
}

std::string CheckPoints(const Domain& domain, const PolygonMesh& mesh)
{
  const std::set<int> used(mesh.Vertices.begin(), mesh.Vertices.end());
  std::set<std::pair<double, double>> places;
  for (const Point2& point : mesh.Points)
  {
    places.insert({ point.x, point.y });
  }
  if (used.size() != mesh.Points.size() || places.size() != mesh.Points.size())
  {
    return "points are not used, or there twice";
  }
  for (const auto& [vertex, next] : EdgesOf(domain))
  {
    if (places.count({ vertex.x, vertex.y }) == 0)
    {
      return "a vertex of the domain is no vertex of the mesh";
    }
  }
  return {};
}

std::string CheckSides(const Domain& domain, const PolygonMesh& mesh)
{
  std::set<std::pair<int, int>> sides;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const std::span<const int> vertices = mesh.Element(element);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (!sides.insert({ vertices[i], vertices[(i + 1) % vertices.size()] }).second)
      {
        return "element " + std::to_string(element) + " has the side of another one";
      }
    }
  }
  const auto edges = EdgesOf(domain);
  double scale = 0.0;
  for (const Point2& point : mesh.Points)
  {
    scale = std::max({ scale, std::abs(point.x), std::abs(point.y) });
  }
  for (const auto& [from, to] : sides)
  {
    if (sides.count({ to, from }) > 0)
    {
      continue;
    }
    const bool isOnBoundary = std::any_of(edges.begin(), edges.end(),
      [&, a = mesh.Points[from], b = mesh.Points[to]](const auto& edge)
      { return IsOnEdge(edge, a, scale) && IsOnEdge(edge, b, scale); });
    if (!isOnBoundary)
    {
      return "side " + std::to_string(from) + "-" + std::to_string(to) +
        " has no neighbour, but is not on the boundary";
    }
  }
  return {};
}

} // namespace

std::string WhyNotAMeshOf(const Domain& domain, const PolygonMesh& mesh)
{
  for (const auto check : { &CheckElements, &CheckPoints, &CheckSides })
  {
    std::string why = check(domain, mesh);
    if (!why.empty())
    {
      return why;
    }
  }
  return {};
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationChecks.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace pemesh
{

namespace
{

using Rational = CGAL::Exact_rational;

Rational TwiceArea(PolygonView polygon)
{
  Rational twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    twice += Rational(a.x) * Rational(b.y) - Rational(b.x) * Rational(a.y);
  }
  return twice;
}

Rational TwiceArea(const PolygonMesh& mesh, int element)
{
  std::vector<Point2> vertices;
  mesh.GetVertices(element, vertices);
  return TwiceArea(vertices);
}

/** The sides of the border by the coordinates of their ends, sorted. */
std::vector<std::tuple<double, double, double, double>> BorderOf(
  const PolygonMesh& mesh, const MeshAdjacency& adjacency)
{
  std::vector<std::tuple<double, double, double, double>> border;
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    if (adjacency.Twin[side] == MeshAdjacency::Border)
    {
      const Point2& from = mesh.Points[mesh.Vertices[side]];
      const Point2& to = mesh.Points[mesh.Vertices[NextSide(mesh, adjacency.Element[side], side)]];
      border.emplace_back(from.x, from.y, to.x, to.y);
    }
  }
  std::sort(border.begin(), border.end());
  return border;
}

std::string WhyElementsAreWrong(const PolygonMesh& before, const AgglomerationResult& after)
{
  std::vector<Rational> areas(static_cast<std::size_t>(after.Mesh.NumberOfElements()), 0);
  for (int element = 0; element < before.NumberOfElements(); ++element)
  {
    areas.at(static_cast<std::size_t>(after.Group.at(static_cast<std::size_t>(element)))) +=
      TwiceArea(before, element);
  }
  std::vector<Point2> vertices;
  for (int element = 0; element < after.Mesh.NumberOfElements(); ++element)
  {
    after.Mesh.GetVertices(element, vertices);
    if (!IsSimpleAndCounterClockwise(vertices))
    {
      return "element " + std::to_string(element) + " is not simple and counter-clockwise";
    }
    if (TwiceArea(vertices) != areas[static_cast<std::size_t>(element)])
    {
      return "element " + std::to_string(element) + " has another area than its parts";
    }
  }
  return {};
}

} // namespace

bool IsSimpleAndCounterClockwise(PolygonView polygon)
{
  using Kernel = CGAL::Simple_cartesian<Rational>;
  CGAL::Polygon_2<Kernel> exact;
  for (const Point2& point : polygon)
  {
    exact.push_back({ Rational(point.x), Rational(point.y) });
  }
  return exact.size() >= 3 && exact.is_simple() && exact.area() > 0;
}

std::string ExactArea(const PolygonMesh& mesh)
{
  Rational sum = 0;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    sum += TwiceArea(mesh, element);
  }
  std::ostringstream text;
  text << sum / 2;
  return text.str();
}

int EulerCharacteristic(const PolygonMesh& mesh)
{
  const MeshAdjacency adjacency = FindAdjacency(mesh);
  std::vector<int> used = mesh.Vertices;
  std::sort(used.begin(), used.end());
  const auto vertices = std::unique(used.begin(), used.end()) - used.begin();
  const auto border =
    std::count(adjacency.Twin.begin(), adjacency.Twin.end(), MeshAdjacency::Border);
  return static_cast<int>(vertices - (mesh.NumberOfSides() + border) / 2) + mesh.NumberOfElements();
}

std::string WhyNotAnAgglomeration(const PolygonMesh& before, const AgglomerationResult& after)
{
  if (after.Status != AgglomerationStatus::Done || !after.Message.empty())
  {
    return "not done: " + after.Message;
  }
  const std::string elements = WhyElementsAreWrong(before, after);
  if (!elements.empty())
  {
    return elements;
  }
  const MeshAdjacency adjacency = FindAdjacency(after.Mesh);
  if (std::count(adjacency.Twin.begin(), adjacency.Twin.end(), MeshAdjacency::Conflict) > 0)
  {
    return "a side belongs to more than two elements";
  }
  if (BorderOf(after.Mesh, adjacency) != BorderOf(before, FindAdjacency(before)))
  {
    return "the border has changed";
  }
  PolygonMesh copy = after.Mesh;
  RemoveUnusedPoints(copy);
  if (copy.Points.size() != after.Mesh.Points.size())
  {
    return "some points are not used";
  }
  return EulerCharacteristic(before) == EulerCharacteristic(after.Mesh)
    ? std::string()
    : "the Euler characteristic has changed";
}

bool IsUnionSimple(const PolygonMesh& mesh, int a, int b)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Polygon_2<Kernel> polygons[2];
  for (int i = 0; i < 2; ++i)
  {
    for (const int vertex : mesh.Element(i == 0 ? a : b))
    {
      polygons[i].push_back({ mesh.Points[vertex].x, mesh.Points[vertex].y });
    }
  }
  CGAL::Polygon_with_holes_2<Kernel> joined;
  return CGAL::join(polygons[0], polygons[1], joined) && joined.number_of_holes() == 0 &&
    joined.outer_boundary().is_simple();
}

} // namespace pemesh

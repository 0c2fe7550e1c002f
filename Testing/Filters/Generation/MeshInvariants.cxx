// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshInvariants.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace
{

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using pemesh::Point2;

Kernel::Point_2 Exact(const Point2& point)
{
  return { Rational(point.x), Rational(point.y) };
}

CGAL::Polygon_2<Kernel> Exact(const PolygonVertices& polygon)
{
  CGAL::Polygon_2<Kernel> exact;
  for (const Point2& point : polygon)
  {
    exact.push_back(Exact(point));
  }
  return exact;
}

std::vector<vtkIdType> IdsOf(vtkPolyData* mesh, int cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  return { ids->begin(), ids->end() };
}

Point2 PointOf(vtkPolyData* mesh, vtkIdType id)
{
  double point[3];
  mesh->GetPoint(id, point);
  return { point[0], point[1] };
}

/** Each directed edge, with the cell on its left and the vertex after it in that cell. */
struct EdgeUse
{
  int Cell;
  vtkIdType Apex;
};
using EdgeMap = std::map<std::pair<vtkIdType, vtkIdType>, EdgeUse>;

/** A sentence if an edge is used twice in one direction. */
std::string CollectEdges(vtkPolyData* mesh, EdgeMap& edges)
{
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const std::vector<vtkIdType> ids = IdsOf(mesh, cell);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const vtkIdType to = ids[(i + 1) % ids.size()];
      if (!edges.insert({ { ids[i], to }, { cell, ids[(i + 2) % ids.size()] } }).second)
      {
        return "edge " + std::to_string(ids[i]) + "-" + std::to_string(to) + " is used twice";
      }
    }
  }
  return {};
}

/** Whether the point is on the edge: exactly if it is upright or level, else as near as doubles. */
bool IsOnEdge(const Point2& point, const Point2& from, const Point2& to)
{
  if (from.x == to.x || from.y == to.y)
  {
    return from.x == to.x ? point.x == from.x : point.y == from.y;
  }
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double cross = (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
  const double size =
    std::max({ std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y) });
  return std::abs(cross) / length <= 1e-15 * size;
}

/** Follows the border of the mesh along a loop of the domain, in that direction. */
std::string WhyNotAlong(vtkPolyData* mesh, const PolygonVertices& loop,
  std::map<vtkIdType, vtkIdType>& border, PolygonVertices& found)
{
  vtkIdType vertex = -1;
  for (const auto& [from, to] : border)
  {
    const Point2 point = PointOf(mesh, from);
    vertex = point == loop[0] ? from : vertex;
  }
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& from = loop[i];
    const Point2& to = loop[(i + 1) % loop.size()];
    double place = 0.0;
    do
    {
      const auto step = border.find(vertex);
      if (step == border.end())
      {
        return "the border of the mesh leaves a loop of the domain after its vertex " +
          std::to_string(i);
      }
      found.push_back(PointOf(mesh, vertex));
      vertex = step->second;
      border.erase(step);
      const Point2 next = PointOf(mesh, vertex);
      const double along =
        (next.x - from.x) * (to.x - from.x) + (next.y - from.y) * (to.y - from.y);
      if (!IsOnEdge(next, from, to) || along <= place)
      {
        return "point " + std::to_string(vertex) + " on the border is not on the domain's edge";
      }
      place = along;
    } while (!(PointOf(mesh, vertex) == to));
  }
  return {};
}

/** The border must be the loops of the domain, and the elements must fill it exactly. */
std::string WhyNotTheDomain(vtkPolyData* mesh, const EdgeMap& edges, const pemesh::Domain& domain,
  const Rational& areaOfElements)
{
  std::map<vtkIdType, vtkIdType> border;
  for (const auto& [edge, use] : edges)
  {
    if (!edges.count({ edge.second, edge.first }) &&
      !border.insert({ edge.first, edge.second }).second)
    {
      return "the border passes point " + std::to_string(edge.first) + " twice";
    }
  }
  std::vector<PolygonVertices> loops = domain.Holes;
  for (PolygonVertices& hole : loops)
  {
    std::reverse(hole.begin(), hole.end());
  }
  loops.push_back(domain.Outer);
  Rational area = 0;
  for (const PolygonVertices& loop : loops)
  {
    PolygonVertices found;
    const std::string why = WhyNotAlong(mesh, loop, border, found);
    if (!why.empty())
    {
      return why;
    }
    area += Exact(found).area();
  }
  if (!border.empty())
  {
    return "edge " + std::to_string(border.begin()->first) + "-" +
      std::to_string(border.begin()->second) + " has an element on one side only";
  }
  return area == areaOfElements ? "" : "the areas do not add up to exactly that of the border";
}

int PolygonIdOf(vtkPolyData* mesh, int cell)
{
  return static_cast<int>(mesh->GetCellData()->GetArray("PolygonId")->GetTuple1(cell));
}

std::string WhyArraysAreWrong(vtkPolyData* mesh)
{
  auto* ids = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("PolygonId"));
  auto* families = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("ElementFamily"));
  if (!ids || !families || ids->GetNumberOfTuples() != mesh->GetNumberOfCells() ||
    families->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    return "PolygonId or ElementFamily is missing";
  }
  bool fillers = false;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const bool filler = ids->GetValue(cell) == -1;
    if (filler && (mesh->GetCell(cell)->GetNumberOfPoints() != 3 || families->GetValue(cell) != -1))
    {
      return "filler " + std::to_string(cell) + " is not a triangle of no family";
    }
    if (!filler && fillers)
    {
      return "placed polygon " + std::to_string(cell) + " comes after a filler";
    }
    fillers = fillers || filler;
  }
  return {};
}

} // namespace

double SignedArea(const PolygonVertices& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& next = polygon[(i + 1) % polygon.size()];
    twice += polygon[i].x * next.y - next.x * polygon[i].y;
  }
  return 0.5 * twice;
}

bool IsSimpleAndCounterClockwise(const PolygonVertices& polygon)
{
  if (polygon.size() == 3)
  {
    return CGAL::left_turn(Exact(polygon[0]), Exact(polygon[1]), Exact(polygon[2]));
  }
  const CGAL::Polygon_2<Kernel> exact = Exact(polygon);
  return exact.is_simple() && exact.area() > 0;
}

PolygonVertices VerticesOf(vtkPolyData* mesh, int cell)
{
  PolygonVertices vertices;
  for (const vtkIdType id : IdsOf(mesh, cell))
  {
    vertices.push_back(PointOf(mesh, id));
  }
  return vertices;
}

std::string WhyNotPolygons(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfCells() == 0 || mesh->GetPoints()->GetDataType() != VTK_DOUBLE)
  {
    return "the mesh is empty, or its points are not doubles";
  }
  if (mesh->GetNumberOfCells() != mesh->GetNumberOfPolys())
  {
    return "some cells are not polygons";
  }
  std::vector<bool> used(mesh->GetNumberOfPoints(), false);
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (!IsSimpleAndCounterClockwise(VerticesOf(mesh, cell)))
    {
      return "element " + std::to_string(cell) + " is not simple and counter-clockwise";
    }
    for (const vtkIdType id : IdsOf(mesh, cell))
    {
      used[id] = true;
    }
  }
  std::set<std::pair<double, double>> places;
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    const Point2 point = PointOf(mesh, id);
    if (!used[id] || mesh->GetPoint(id)[2] != 0.0 || !places.insert({ point.x, point.y }).second)
    {
      return "point " + std::to_string(id) + " is unused, not in the plane, or there twice";
    }
  }
  EdgeMap edges;
  return CollectEdges(mesh, edges);
}

std::string WhyNotACover(vtkPolyData* mesh, const pemesh::Domain& domain)
{
  const std::string why = WhyNotPolygons(mesh);
  if (!why.empty())
  {
    return why;
  }
  Rational sum = 0;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    sum += Exact(VerticesOf(mesh, cell)).area();
  }
  EdgeMap edges;
  CollectEdges(mesh, edges);
  return WhyNotTheDomain(mesh, edges, domain, sum);
}

std::string WhyNotAMesh(vtkPolyData* mesh, const pemesh::Domain& domain)
{
  const std::string why = WhyNotACover(mesh, domain);
  return why.empty() ? WhyArraysAreWrong(mesh) : why;
}

std::string WhyNotConstrainedDelaunay(vtkPolyData* mesh)
{
  EdgeMap edges;
  CollectEdges(mesh, edges);
  for (const auto& [edge, use] : edges)
  {
    const auto back = edges.find({ edge.second, edge.first });
    if (back == edges.end() || PolygonIdOf(mesh, use.Cell) >= 0 ||
      PolygonIdOf(mesh, back->second.Cell) >= 0)
    {
      continue;
    }
    if (CGAL::side_of_oriented_circle(Exact(PointOf(mesh, edge.first)),
          Exact(PointOf(mesh, edge.second)), Exact(PointOf(mesh, use.Apex)),
          Exact(PointOf(mesh, back->second.Apex))) == CGAL::ON_POSITIVE_SIDE)
    {
      return "elements " + std::to_string(use.Cell) + " and " + std::to_string(back->second.Cell) +
        " are not Delaunay";
    }
  }
  return {};
}

std::string WhyNotConforming(vtkPolyData* mesh)
{
  EdgeMap edges;
  CollectEdges(mesh, edges);
  for (const auto& [edge, use] : edges)
  {
    const auto back = edges.find({ edge.second, edge.first });
    const bool fixed = back == edges.end() || PolygonIdOf(mesh, back->second.Cell) >= 0;
    if (fixed && PolygonIdOf(mesh, use.Cell) < 0)
    {
      const double largest = AnglesOf(
        { PointOf(mesh, edge.first), PointOf(mesh, use.Apex), PointOf(mesh, edge.second) })[2];
      const double length = std::hypot(PointOf(mesh, edge.first).x - PointOf(mesh, edge.second).x,
        PointOf(mesh, edge.first).y - PointOf(mesh, edge.second).y);
      const Point2 apex = PointOf(mesh, use.Apex);
      const Point2 from = PointOf(mesh, edge.first);
      const Point2 to = PointOf(mesh, edge.second);
      const double dot = (from.x - apex.x) * (to.x - apex.x) + (from.y - apex.y) * (to.y - apex.y);
      if (dot < -1e-12 * length * length)
      {
        return "edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second) +
          " has a vertex in its circle (angle " + std::to_string(largest) + ")";
      }
    }
  }
  return {};
}

std::vector<double> AnglesOf(const PolygonVertices& triangle)
{
  std::array<double, 3> side;
  for (int i = 0; i < 3; ++i)
  {
    const Point2& a = triangle[(i + 1) % 3];
    const Point2& b = triangle[(i + 2) % 3];
    side[i] = std::hypot(a.x - b.x, a.y - b.y);
  }
  std::vector<double> angles;
  for (int i = 0; i < 3; ++i)
  {
    const double a = side[i], b = side[(i + 1) % 3], c = side[(i + 2) % 3];
    // tan(alpha / 2) in Kahan's order would be stabler; sides of test meshes are never so
    // needlelike
    const double cosine = std::clamp((b * b + c * c - a * a) / (2.0 * b * c), -1.0, 1.0);
    angles.push_back(std::acos(cosine) * 180.0 / std::numbers::pi);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

double SmallestOuterAngle(const PolygonVertices& polygon)
{
  double smallest = 360.0;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2& before = polygon[(i + n - 1) % n];
    const Point2& after = polygon[(i + 1) % n];
    const double in = std::atan2(polygon[i].y - before.y, polygon[i].x - before.x);
    const double out = std::atan2(after.y - polygon[i].y, after.x - polygon[i].x);
    const double turn = std::remainder(out - in, 2.0 * std::numbers::pi); // to the left
    smallest = std::min(smallest, 180.0 + turn * 180.0 / std::numbers::pi);
  }
  return smallest;
}

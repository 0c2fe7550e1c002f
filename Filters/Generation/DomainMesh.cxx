// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainMesh.h"

#include "DelaunayRefinement.h"
#include "DomainTriangulation.h"
#include "NumberText.h"
#include "PlaneVectors.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

const std::vector<Point2> UnitSquare = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };

std::string TooManyElements(const DomainMeshOptions& options, double expected)
{
  std::string message =
    "The mesh would have more than " + std::to_string(options.MaximumElements) + " elements";
  if (expected > 0.0)
  {
    message += " (at least " + FormatNumber(std::ceil(expected)) + ", for no triangle may exceed " +
      FormatNumber(options.MaximumArea) + " in area)";
  }
  return message + "; choose a larger maximum area, a smaller minimum angle or a higher limit.";
}

/** Least number of triangles that the area bound asks for. */
double LeastNumberOfTriangles(const std::vector<std::vector<Point2>>& polygons, double maximumArea)
{
  double area = 1.0;
  for (const std::vector<Point2>& polygon : polygons)
  {
    area -= SignedArea(polygon);
  }
  return area / maximumArea;
}

double SmallestAngle(const Point2& a, const Point2& b, const Point2& c)
{
  const auto angle = [](const Point2& apex, const Point2& from, const Point2& to)
  { return std::atan2(Cross(from - apex, to - apex), Dot(from - apex, to - apex)); };
  const double smallest = std::min({ angle(a, b, c), angle(b, c, a), angle(c, a, b) });
  return std::max(0.0, smallest) * 180.0 / std::numbers::pi;
}

/** The polygons as loops of vertices: along the segments, which have the polygon on their right. */
void CollectPolygons(const RefinableTriangulation& triangulation,
  const std::vector<std::vector<Point2>>& polygons, DomainMesh& mesh)
{
  std::vector<int> before(mesh.Points.size(), -1);
  for (int i = 0; i < triangulation.NumberOfSegments(); ++i)
  {
    const RefinableTriangulation::Triangle& triangle =
      triangulation.GetTriangle(triangulation.GetSegment(i).Triangle);
    const int edge = triangulation.EdgeOfSegment(i);
    before[triangle.Vertex[(edge + 2) % 3]] = triangle.Vertex[(edge + 1) % 3];
  }
  int first = 0;
  for (const std::vector<Point2>& polygon : polygons)
  {
    std::vector<int> loop = { first };
    for (int vertex = before[first]; vertex != first; vertex = before[vertex])
    {
      loop.push_back(vertex);
    }
    mesh.Polygons.push_back(std::move(loop));
    first += static_cast<int>(polygon.size());
  }
}

/**
 * Added vertices are as near to the polygon's edges as doubles can be, but not exactly on them:
 * polygons a few units in the last place thin could cross themselves. Empty if none does.
 */
std::string FindSpoiltPolygon(
  const DomainMesh& mesh, const std::vector<std::vector<Point2>>& polygons)
{
  std::vector<Point2> vertices;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    const std::vector<int>& loop = mesh.Polygons[i];
    if (loop.size() == polygons[i].size())
    {
      continue;
    }
    vertices.clear();
    std::transform(loop.begin(), loop.end(), std::back_inserter(vertices),
      [&mesh](int vertex) { return mesh.Points[vertex]; });
    if (!IsSimple(vertices) || PolygonOrientation(vertices) <= 0)
    {
      return "Polygon " + std::to_string(i + 1) +
        " is too thin for its edges to be split in double precision; preserve the polygons.";
    }
  }
  return {};
}

} // namespace

DomainMesh MeshDomain(
  const std::vector<std::vector<Point2>>& polygons, const DomainMeshOptions& options)
{
  DomainMesh mesh;
  const double least = LeastNumberOfTriangles(polygons, options.MaximumArea);
  if (least > options.MaximumElements)
  {
    mesh.Message = TooManyElements(options, least);
    return mesh;
  }
  const DomainBoundary boundary = MakeDomainBoundary(UnitSquare, polygons);
  RefinableTriangulation triangulation = TriangulateDomain(boundary);

  RefinementOptions refinement;
  refinement.MinimumAngle = options.MinimumAngle;
  refinement.MaximumArea = options.MaximumArea;
  refinement.MaximumTriangles = options.MaximumElements;
  refinement.Progress = options.Progress;
  refinement.Preserved.assign(boundary.Segments.size(), options.PreservePolygons);
  std::fill(refinement.Preserved.end() - UnitSquare.size(), refinement.Preserved.end(), false);
  switch (RefineTriangulation(triangulation, boundary, refinement))
  {
    case RefinementOutcome::Done:
      break;
    case RefinementOutcome::TooManyTriangles:
      mesh.Message = TooManyElements(options, 0.0);
      return mesh;
    case RefinementOutcome::Stopped:
      mesh.Status = DomainMeshStatus::Stopped;
      return mesh;
  }

  mesh.Points = triangulation.GetPoints();
  CollectPolygons(triangulation, polygons, mesh);
  mesh.Message = FindSpoiltPolygon(mesh, polygons);
  if (!mesh.Message.empty())
  {
    return mesh;
  }
  mesh.AttainedMinimumAngle = 60.0;
  mesh.Triangles.reserve(triangulation.NumberOfTriangles());
  for (const RefinableTriangulation::Triangle& triangle : triangulation.GetTriangles())
  {
    const int* vertex = triangle.Vertex;
    mesh.Triangles.push_back({ vertex[0], vertex[1], vertex[2] });
    mesh.AttainedMinimumAngle = std::min(mesh.AttainedMinimumAngle,
      SmallestAngle(mesh.Points[vertex[0]], mesh.Points[vertex[1]], mesh.Points[vertex[2]]));
  }
  mesh.Status = DomainMeshStatus::Done;
  return mesh;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainMesh.h"

#include "DelaunayRefinement.h"
#include "DomainTriangulation.h"
#include "NarrowGaps.h"
#include "NumberText.h"
#include "PlaneVectors.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

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

/** What messages call a loop: polygons come first. */
std::string NameOfLoop(
  std::size_t loop, std::size_t numberOfPolygons, const DomainMeshOptions& options)
{
  if (loop >= numberOfPolygons)
  {
    return "the border of the domain";
  }
  return loop < options.PolygonNames.size() ? options.PolygonNames[loop]
                                            : "polygon " + std::to_string(loop + 1);
}

/** The loop that a vertex or segment of the boundary belongs to, if it is one of a polygon. */
std::size_t LoopOf(int segment, const std::vector<std::vector<Point2>>& polygons)
{
  std::size_t loop = 0;
  for (int first = 0; loop < polygons.size(); ++loop)
  {
    first += static_cast<int>(polygons[loop].size());
    if (segment < first)
    {
      break;
    }
  }
  return loop;
}

/** Two significant digits. */
std::string About(double value)
{
  char text[32];
  const auto end =
    std::to_chars(text, text + sizeof(text), value, std::chars_format::general, 2).ptr;
  return { text, end };
}

std::string TooNarrow(const NarrowGaps& gaps, const std::vector<std::vector<Point2>>& polygons,
  const DomainMeshOptions& options)
{
  const std::size_t loops[2] = { LoopOf(gaps.Segments[0], polygons),
    LoopOf(gaps.Segments[1], polygons) };
  const std::string first = NameOfLoop(loops[0], polygons.size(), options);
  const std::string second = NameOfLoop(loops[1], polygons.size(), options);
  const std::string where =
    loops[0] == loops[1] ? "between two edges of " + first : "between " + first + " and " + second;
  return "A gap " + where + " is only " + About(gaps.Width) + " wide and would take about " +
    About(gaps.MostTriangles) + " triangles, more than the limit of " +
    std::to_string(options.MaximumElements) + " elements allows; widen it, or preserve the edges.";
}

/** Least number of triangles that the area bound asks for. */
double LeastNumberOfTriangles(
  const Domain& domain, const std::vector<std::vector<Point2>>& polygons, double maximumArea)
{
  double area = DomainArea(domain);
  for (const std::vector<Point2>& polygon : polygons)
  {
    area -= SignedArea(polygon);
  }
  return area / maximumArea;
}

/** The smallest angle of all triangles in degrees; each one's is opposite to its shortest edge. */
double SmallestAngle(const RefinableTriangulation& triangulation)
{
  double least = 0.75; // squared sine of 60 degrees
  double angle = 60.0;
  for (const RefinableTriangulation::Triangle& triangle : triangulation.GetTriangles())
  {
    const Point2* corner[3];
    double squared[3];
    for (int i = 0; i < 3; ++i)
    {
      corner[i] = &triangulation.GetPoint(triangle.Vertex[i]);
      squared[i] = SquaredDistance(triangulation.GetPoint(triangle.Vertex[(i + 1) % 3]),
        triangulation.GetPoint(triangle.Vertex[(i + 2) % 3]));
    }
    const auto apex = static_cast<std::size_t>(std::min_element(squared, squared + 3) - squared);
    const Point2 from = *corner[(apex + 1) % 3] - *corner[apex];
    const Point2 to = *corner[(apex + 2) % 3] - *corner[apex];
    const double cross = std::max(0.0, Cross(from, to)); // below 0 by rounding only
    const double squaredSine = cross * cross / (squared[(apex + 1) % 3] * squared[(apex + 2) % 3]);
    if (squaredSine < least)
    {
      least = squaredSine;
      angle = std::atan2(cross, Dot(from, to)) * 180.0 / std::numbers::pi;
    }
  }
  return angle;
}

/** In the order of the boundary's vertices. */
std::vector<const std::vector<Point2>*> AllLoops(
  const Domain& domain, const std::vector<std::vector<Point2>>& polygons)
{
  std::vector<const std::vector<Point2>*> loops;
  for (const std::vector<std::vector<Point2>>* list : { &polygons, &domain.Holes })
  {
    for (const std::vector<Point2>& loop : *list)
    {
      loops.push_back(&loop);
    }
  }
  loops.push_back(&domain.Outer);
  return loops;
}

using Loops = std::vector<std::vector<int>>;

/**
 * The given loops with the vertices that were added, counter-clockwise: polygons, holes, outer
 * loop. Segments have the domain on their left, so around all but the last they run clockwise.
 */
Loops CollectLoops(
  const RefinableTriangulation& triangulation, const std::vector<const std::vector<Point2>*>& given)
{
  std::vector<int> next(triangulation.GetPoints().size(), -1);
  for (int i = 0; i < triangulation.NumberOfSegments(); ++i)
  {
    const RefinableTriangulation::Triangle& triangle =
      triangulation.GetTriangle(triangulation.GetSegment(i).Triangle);
    const int edge = triangulation.EdgeOfSegment(i);
    next[triangle.Vertex[(edge + 1) % 3]] = triangle.Vertex[(edge + 2) % 3];
  }
  Loops loops;
  int first = 0;
  for (const std::vector<Point2>* loop : given)
  {
    std::vector<int> vertices = { first };
    for (int vertex = next[first]; vertex != first; vertex = next[vertex])
    {
      vertices.push_back(vertex);
    }
    if (loops.size() + 1 < given.size())
    {
      std::reverse(vertices.begin() + 1, vertices.end());
    }
    loops.push_back(std::move(vertices));
    first += static_cast<int>(loop->size());
  }
  return loops;
}

bool HasUprightAndLevelEdgesOnly(const std::vector<Point2>& loop)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& next = loop[(i + 1) % loop.size()];
    if (loop[i].x != next.x && loop[i].y != next.y)
    {
      return false;
    }
  }
  return true;
}

/**
 * Added vertices are as near to the given edges as doubles can be, but not exactly on them unless
 * these are upright or level: loops a few units in the last place thin could cross themselves.
 * The number of the first that does, or -1.
 */
int FindSpoiltLoop(const std::vector<Point2>& points, const Loops& loops,
  const std::vector<const std::vector<Point2>*>& given)
{
  std::vector<Point2> vertices;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (loops[i].size() == given[i]->size() || HasUprightAndLevelEdgesOnly(*given[i]))
    {
      continue;
    }
    vertices.clear();
    std::transform(loops[i].begin(), loops[i].end(), std::back_inserter(vertices),
      [&points](int vertex) { return points[vertex]; });
    if (!IsSimple(vertices) || PolygonOrientation(vertices) <= 0)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void FillElements(const RefinableTriangulation& triangulation, const Loops& loops,
  std::size_t numberOfPolygons, DomainMesh& mesh)
{
  PolygonMesh& elements = mesh.Elements;
  elements.Points = triangulation.GetPoints();
  const std::size_t triangles = triangulation.GetTriangles().size();
  elements.Offsets.reserve(numberOfPolygons + triangles + 1);
  std::size_t sides = 3 * triangles;
  for (std::size_t i = 0; i < numberOfPolygons; ++i)
  {
    sides += loops[i].size();
  }
  elements.Vertices.reserve(sides);
  for (std::size_t i = 0; i < numberOfPolygons; ++i)
  {
    elements.AddElement(loops[i]);
  }
  for (const RefinableTriangulation::Triangle& triangle : triangulation.GetTriangles())
  {
    elements.AddElement({ triangle.Vertex, 3 });
  }
  mesh.AttainedMinimumAngle = SmallestAngle(triangulation);
}

RefinementOptions MakeRefinementOptions(
  const DomainBoundary& boundary, const DomainMeshOptions& options)
{
  RefinementOptions refinement;
  refinement.MinimumAngle = options.MinimumAngle;
  refinement.MaximumArea = options.MaximumArea;
  refinement.Gradation = options.Gradation;
  refinement.SizeAtPolygons = options.SizeAtPolygons;
  refinement.MaximumTriangles = options.MaximumElements;
  refinement.Progress = options.Progress;
  refinement.Preserved.assign(boundary.Segments.size(), options.PreserveDomain);
  std::fill_n(
    refinement.Preserved.begin(), boundary.NumberOfPolygonSegments, options.PreservePolygons);
  return refinement;
}

} // namespace

DomainMesh MeshDomain(const Domain& domain, const std::vector<std::vector<Point2>>& polygons,
  const DomainMeshOptions& options)
{
  DomainMesh mesh;
  const double least = LeastNumberOfTriangles(domain, polygons, options.MaximumArea);
  mesh.MaximumArea = options.MaximumArea;
  if (least > options.MaximumElements)
  {
    mesh.Status = DomainMeshStatus::TooManyElements;
    mesh.Message = TooManyElements(options, least);
    return mesh;
  }
  const DomainBoundary boundary = MakeDomainBoundary(domain, polygons);
  DomainTriangulation domainTriangulation = TriangulateDomain(boundary);
  const RefinableTriangulation& triangulation = domainTriangulation.Inside;

  const RefinementOptions refinement = MakeRefinementOptions(boundary, options);
  const NarrowGaps gaps = FindNarrowGaps(triangulation, refinement.Preserved, options.MinimumAngle);
  if (gaps.Triangles > options.MaximumElements)
  {
    mesh.Status = DomainMeshStatus::TooManyElements;
    mesh.Message = TooNarrow(gaps, polygons, options);
    return mesh;
  }
  switch (RefineTriangulation(domainTriangulation, boundary, refinement))
  {
    case RefinementOutcome::Done:
      break;
    case RefinementOutcome::TooManyTriangles:
      mesh.Status = DomainMeshStatus::TooManyElements;
      mesh.Message = TooManyElements(options, 0.0);
      return mesh;
    case RefinementOutcome::Stopped:
      mesh.Status = DomainMeshStatus::Stopped;
      return mesh;
  }

  const std::vector<const std::vector<Point2>*> given = AllLoops(domain, polygons);
  const Loops loops = CollectLoops(triangulation, given);
  const int spoilt = FindSpoiltLoop(triangulation.GetPoints(), loops, given);
  if (spoilt >= 0)
  {
    mesh.Message = "The mesh cannot be made: " +
      NameOfLoop(static_cast<std::size_t>(spoilt), polygons.size(), options) +
      " is too thin for its edges to be split in double precision; preserve them.";
    return mesh;
  }
  FillElements(triangulation, loops, polygons.size(), mesh);
  mesh.Status = DomainMeshStatus::Done;
  return mesh;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RefinableTriangulation.h"

#include "Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>
#include <utility>

namespace pemesh
{

namespace
{

int Next(int edge)
{
  return edge == 2 ? 0 : edge + 1;
}

int Previous(int edge)
{
  return edge == 0 ? 2 : edge - 1;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 ToKernel(const Point2& point)
{
  return { point.x, point.y };
}

/**
 * Whether d lies strictly in the circumcircle of the counter-clockwise a, b, c. The error bound of
 * the floating-point stage is bound A of Shewchuk (1997), see Predicates.h; CGAL decides the rest.
 */
bool IsInCircumcircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double bxcy = bx * cy, cxby = cx * by;
  const double cxay = cx * ay, axcy = ax * cy;
  const double axby = ax * by, bxay = bx * ay;
  const double aLift = ax * ax + ay * ay;
  const double bLift = bx * bx + by * by;
  const double cLift = cx * cx + cy * cy;
  const double determinant = aLift * (bxcy - cxby) + bLift * (cxay - axcy) + cLift * (axby - bxay);
  const double permanent = (std::abs(bxcy) + std::abs(cxby)) * aLift +
    (std::abs(cxay) + std::abs(axcy)) * bLift + (std::abs(axby) + std::abs(bxay)) * cLift;
  constexpr double ErrorBound = 1.1102230246251577e-15; // (10 + 96 u) u, u = 2^-53
  const double error = ErrorBound * permanent;
  // The second term makes underflow fall through to the exact stage.
  if (determinant > error && determinant > 1e-280)
  {
    return true;
  }
  if (determinant < -error && determinant < -1e-280)
  {
    return false;
  }
  return CGAL::side_of_oriented_circle(ToKernel(a), ToKernel(b), ToKernel(c), ToKernel(d)) ==
    CGAL::ON_POSITIVE_SIDE;
}

} // namespace

RefinableTriangulation::RefinableTriangulation(
  std::vector<Point2> points, std::vector<Triangle> triangles, std::vector<Segment> segments)
  : Points(std::move(points))
  , Triangles(std::move(triangles))
  , Segments(std::move(segments))
  , Stamps(this->Triangles.size(), 0)
  , Marks(this->Triangles.size(), 0)
  , StartingAt(this->Points.size(), -1)
{
}

void RefinableTriangulation::Reserve(std::size_t points)
{
  this->Points.reserve(this->Points.size() + points);
  this->StartingAt.reserve(this->Points.size() + points);
  const std::size_t triangles = this->Triangles.size() + 2 * points; // by Euler's formula
  this->Triangles.reserve(triangles);
  this->Stamps.reserve(triangles);
  this->Marks.reserve(triangles);
}

int RefinableTriangulation::EdgeOfSegment(int segment) const
{
  const Triangle& triangle = this->Triangles[this->Segments[segment].Triangle];
  return triangle.Neighbor[0] == ~segment ? 0 : triangle.Neighbor[1] == ~segment ? 1 : 2;
}

bool RefinableTriangulation::IsInCircle(int triangle, const Point2& point) const
{
  const int* vertex = this->Triangles[triangle].Vertex;
  return IsInCircumcircle(
    this->Points[vertex[0]], this->Points[vertex[1]], this->Points[vertex[2]], point);
}

// --- Flipping ------------------------------------------------------------------------------------

void RefinableTriangulation::SetNeighbor(int neighbor, int from, int to, int triangle)
{
  if (neighbor < 0)
  {
    this->Segments[~neighbor].Triangle = triangle;
    return;
  }
  Triangle& other = this->Triangles[neighbor];
  for (int edge = 0; edge < 3; ++edge)
  {
    if (other.Vertex[Next(edge)] == to && other.Vertex[Previous(edge)] == from)
    {
      other.Neighbor[edge] = triangle;
    }
  }
}

bool RefinableTriangulation::FlipIfNeeded(int triangle, int edge)
{
  const int neighbor = this->Triangles[triangle].Neighbor[edge];
  if (neighbor < 0)
  {
    return false;
  }
  const Triangle one = this->Triangles[triangle];
  const Triangle two = this->Triangles[neighbor];
  int back = 0;
  while (two.Neighbor[back] != triangle || two.Vertex[Next(back)] != one.Vertex[Previous(edge)])
  {
    ++back;
  }
  const int apex = one.Vertex[edge];
  const int opposite = two.Vertex[back];
  if (!this->IsInCircle(triangle, this->Points[opposite]))
  {
    return false;
  }
  // Edge from-to becomes apex-opposite; the quadrilateral is convex where the circle test fails.
  const int from = one.Vertex[Next(edge)];
  const int to = one.Vertex[Previous(edge)];
  const int fromApex = one.Neighbor[Previous(edge)];
  const int toApex = one.Neighbor[Next(edge)];
  const int fromOpposite = two.Neighbor[Next(back)];
  const int toOpposite = two.Neighbor[Previous(back)];
  this->Triangles[triangle] = { { apex, from, opposite }, { fromOpposite, neighbor, fromApex } };
  this->Triangles[neighbor] = { { apex, opposite, to }, { toOpposite, toApex, triangle } };
  this->SetNeighbor(fromOpposite, from, opposite, triangle);
  this->SetNeighbor(fromApex, apex, from, triangle);
  this->SetNeighbor(toOpposite, opposite, to, neighbor);
  this->SetNeighbor(toApex, to, apex, neighbor);
  ++this->Stamps[triangle];
  ++this->Stamps[neighbor];
  return true;
}

void RefinableTriangulation::MakeDelaunay()
{
  // Each flip may spoil the four outer edges only, so a stack of triangles to look at ends empty.
  std::vector<int> waiting(this->Triangles.size());
  for (int i = 0; i < this->NumberOfTriangles(); ++i)
  {
    waiting[i] = this->NumberOfTriangles() - 1 - i;
  }
  while (!waiting.empty())
  {
    const int triangle = waiting.back();
    waiting.pop_back();
    for (int edge = 0; edge < 3; ++edge)
    {
      const int neighbor = this->Triangles[triangle].Neighbor[edge];
      if (this->FlipIfNeeded(triangle, edge))
      {
        waiting.push_back(neighbor);
        waiting.push_back(triangle);
        break;
      }
    }
  }
}

// --- Zones ---------------------------------------------------------------------------------------

void RefinableTriangulation::GrowZone(int start, const Point2& point, int skippedSegment)
{
  ++this->Mark;
  this->Zone.assign(1, start);
  this->ZoneEdges.clear();
  this->Marks[start] = this->Mark;
  for (std::size_t i = 0; i < this->Zone.size(); ++i)
  {
    const Triangle& triangle = this->Triangles[this->Zone[i]];
    for (int edge = 0; edge < 3; ++edge)
    {
      const int neighbor = triangle.Neighbor[edge];
      if (neighbor >= 0 && this->Marks[neighbor] == this->Mark)
      {
        continue;
      }
      if (neighbor >= 0 && this->IsInCircle(neighbor, point))
      {
        this->Marks[neighbor] = this->Mark;
        this->Zone.push_back(neighbor);
      }
      else if (neighbor != ~skippedSegment || skippedSegment < 0)
      {
        this->ZoneEdges.push_back(
          { triangle.Vertex[Next(edge)], triangle.Vertex[Previous(edge)], neighbor });
      }
    }
  }
}

void RefinableTriangulation::FindZone(int triangle, const Point2& point)
{
  if (this->IsInCircle(triangle, point))
  {
    this->GrowZone(triangle, point, -1);
  }
  else
  {
    this->Zone.clear();
    this->ZoneEdges.clear();
  }
}

void RefinableTriangulation::FindZoneOfSegment(int segment, const Point2& point)
{
  this->GrowZone(this->Segments[segment].Triangle, point, segment);
}

bool RefinableTriangulation::ZoneContains(const Point2& point) const
{
  for (const int triangle : this->Zone)
  {
    const int* vertex = this->Triangles[triangle].Vertex;
    const Point2& a = this->Points[vertex[0]];
    const Point2& b = this->Points[vertex[1]];
    const Point2& c = this->Points[vertex[2]];
    if (Orientation(a, b, point) >= 0 && Orientation(b, c, point) >= 0 &&
      Orientation(c, a, point) >= 0)
    {
      return true;
    }
  }
  return false;
}

bool RefinableTriangulation::IsZoneVisible(const Point2& point) const
{
  for (const ZoneEdge& edge : this->ZoneEdges)
  {
    if (Orientation(this->Points[edge.From], this->Points[edge.To], point) <= 0)
    {
      return false;
    }
  }
  return !this->ZoneEdges.empty();
}

/**
 * Makes the triangle (edge, point) of every zone edge. Where the zone was opened at a segment
 * from-to, the star's free edges are to-point and point-from: `newNeighborTo`, `newNeighborFrom`.
 */
int RefinableTriangulation::MakeStar(
  const Point2& point, int newNeighborFrom, int newNeighborTo, int from, int to)
{
  const int vertex = static_cast<int>(this->Points.size());
  this->Points.push_back(point);
  this->StartingAt.push_back(-1);
  this->Star.clear();
  for (std::size_t i = 0; i < this->ZoneEdges.size(); ++i)
  {
    int triangle = this->NumberOfTriangles();
    if (i < this->Zone.size())
    {
      triangle = this->Zone[i];
      ++this->Stamps[triangle];
    }
    else
    {
      this->Triangles.emplace_back();
      this->Stamps.push_back(0);
      this->Marks.push_back(0);
    }
    const ZoneEdge& edge = this->ZoneEdges[i];
    this->Triangles[triangle] = { { edge.From, edge.To, vertex }, { 0, 0, edge.Outside } };
    this->StartingAt[edge.From] = triangle;
    this->Star.push_back(triangle);
  }
  for (std::size_t i = 0; i < this->ZoneEdges.size(); ++i)
  {
    const ZoneEdge& edge = this->ZoneEdges[i];
    const int triangle = this->Star[i];
    this->SetNeighbor(edge.Outside, edge.From, edge.To, triangle);
    if (edge.To == from)
    {
      this->Triangles[triangle].Neighbor[0] = newNeighborFrom;
    }
    else
    {
      const int next = this->StartingAt[edge.To];
      this->Triangles[triangle].Neighbor[0] = next;
      this->Triangles[next].Neighbor[1] = triangle;
    }
    if (edge.From == to)
    {
      this->Triangles[triangle].Neighbor[1] = newNeighborTo;
    }
  }
  return vertex;
}

int RefinableTriangulation::InsertInZone(const Point2& point)
{
  return this->IsZoneVisible(point) ? this->MakeStar(point, 0, 0, -1, -1) : -1;
}

int RefinableTriangulation::SplitSegment(int segment, const Point2& point)
{
  if (!this->IsZoneVisible(point))
  {
    return -1;
  }
  const Triangle& triangle = this->Triangles[this->Segments[segment].Triangle];
  const int edge = this->EdgeOfSegment(segment);
  const int from = triangle.Vertex[Next(edge)];
  const int to = triangle.Vertex[Previous(edge)];
  const int second = this->NumberOfSegments();
  this->Segments.push_back({ -1, this->Segments[segment].Input });
  const int vertex = this->MakeStar(point, ~segment, ~second, from, to);
  this->Segments[segment].Triangle = -1;
  for (const int star : this->Star)
  {
    for (const int neighbor : this->Triangles[star].Neighbor)
    {
      if (neighbor == ~segment || neighbor == ~second)
      {
        this->Segments[~neighbor].Triangle = star;
      }
    }
  }
  return vertex;
}

} // namespace pemesh

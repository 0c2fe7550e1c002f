// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DelaunayRefinement.h"

#include "BoundarySplitter.h"
#include "LatticePoints.h"
#include "PlaneVectors.h"
#include "Predicates.h"
#include "SizeField.h"
#include "TriangulationWalk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>

namespace pemesh
{

namespace
{

/** Off-centres lie this little nearer than the angle needs, so that rounding cannot spoil it. */
constexpr double OffCenterFactor = 0.95;

/** Areas keep this little below their bound, so that rounding in whoever measures finds no more. */
constexpr double RoundingShare = 1.0 - 1e-12;

/** What is known of a triangle: its shortest edge, and why it has to go. */
struct Shape
{
  Point2 From; ///< the shortest edge, triangle on the left
  Point2 To;
  Point2 Apex;
  double SquaredShortest;
  double Area;
  bool TooLarge;
  bool TooFlat;
};

Point2 Centroid(const Shape& shape)
{
  return { (shape.From.x + shape.To.x + shape.Apex.x) / 3.0,
    (shape.From.y + shape.To.y + shape.Apex.y) / 3.0 };
}

struct BadTriangle
{
  double Badness;
  std::uint64_t Order; ///< earlier first among equals: the same sequence on every run
  int Triangle;
  std::uint32_t Stamp;

  bool operator<(const BadTriangle& other) const
  {
    return this->Badness < other.Badness ||
      (this->Badness == other.Badness && this->Order > other.Order);
  }
};

enum class Attempt
{
  Inserted,
  SplitFirst, ///< segments were found that have to be split before
  Refused
};

/** What a point is for: how much it must respect. */
enum class Purpose
{
  Angle,       ///< anything that another triangle would suffer from speaks against the point
  AngleInside, ///< the same, but flat triangles at preserved segments are accepted
  Area,        ///< small corners are split, but preserved segments near by refuse the point
  AreaInside   ///< nothing speaks against the point
};

class Refinement
{
public:
  Refinement(DomainTriangulation& triangulation, const DomainBoundary& boundary,
    const RefinementOptions& options);

  RefinementOutcome Run();

private:
  bool InsertLattice();
  Shape Measure(int triangle) const;
  void Judge(int triangle);
  void LookAtStar();
  bool TouchesPreserved(int triangle) const;
  double CenterHeight(const Shape& shape) const;
  bool IsNearPreserved(const Point2& point, const Point2& a, const Point2& b) const;
  Attempt TryPoint(int triangle, const Point2& point, Purpose purpose, double squaredSpacing,
    double squaredShortest);
  Attempt RefineLarge(int triangle, const Shape& shape);
  Attempt RefineFlat(int triangle, const Shape& shape);
  bool Continue();

  RefinableTriangulation& Mesh;
  const OutsideTriangles& Outside;
  const DomainBoundary& Boundary;
  const RefinementOptions& Options;
  BoundarySplitter Splitter;
  SizeField Size;
  double SquaredSine;   ///< of the minimum angle
  double CotangentHalf; ///< of half of it
  double CosineTwice;   ///< of twice of it
  std::priority_queue<BadTriangle> Bad;
  std::uint64_t NextOrder = 0;
  std::size_t PointsWaiting = 0;
  std::uint64_t Steps = 0;
  double Fraction = 0.0;
  RefinementOutcome Outcome = RefinementOutcome::Done;
};

Refinement::Refinement(DomainTriangulation& triangulation, const DomainBoundary& boundary,
  const RefinementOptions& options)
  : Mesh(triangulation.Inside)
  , Outside(triangulation.Outside)
  , Boundary(boundary)
  , Options(options)
  , Splitter(triangulation.Inside, boundary, options.Preserved, [this] { this->LookAtStar(); })
  , Size(boundary,
      { options.MaximumArea, options.Gradation, options.SizeAtPolygons, options.Preserved })
{
  const double angle = options.MinimumAngle * std::numbers::pi / 180.0;
  // A little more than asked for, so that rounding in whoever measures finds no less.
  this->SquaredSine = std::sin(angle) * std::sin(angle) * (1.0 + 1e-10);
  this->CotangentHalf = 1.0 / std::tan(0.5 * angle);
  this->CosineTwice = std::cos(2.0 * angle);
}

Shape Refinement::Measure(int triangle) const
{
  const int* vertex = this->Mesh.GetTriangle(triangle).Vertex;
  double squared[3];
  for (int edge = 0; edge < 3; ++edge)
  {
    squared[edge] = SquaredDistance(
      this->Mesh.GetPoint(vertex[(edge + 1) % 3]), this->Mesh.GetPoint(vertex[(edge + 2) % 3]));
  }
  const int edge = static_cast<int>(std::min_element(squared, squared + 3) - squared);
  Shape shape;
  shape.From = this->Mesh.GetPoint(vertex[(edge + 1) % 3]);
  shape.To = this->Mesh.GetPoint(vertex[(edge + 2) % 3]);
  shape.Apex = this->Mesh.GetPoint(vertex[edge]);
  shape.SquaredShortest = squared[edge];
  shape.Area = 0.5 * Cross(shape.From - shape.Apex, shape.To - shape.Apex);
  // The smallest angle is at the apex, and its sine is twice the area over the two long sides.
  const double sides = squared[(edge + 1) % 3] * squared[(edge + 2) % 3];
  shape.TooFlat = 4.0 * shape.Area * shape.Area < this->SquaredSine * sides;
  shape.TooLarge = shape.Area > this->Size.GetLeastBound() * RoundingShare;
  if (shape.TooLarge && !this->Size.IsUniform())
  {
    shape.TooLarge = this->Size.IsTooLarge(shape.Area / RoundingShare, Centroid(shape));
  }
  return shape;
}

/** Puts a triangle among those to refine: large ones first, then flat ones, the worst first. */
void Refinement::Judge(int triangle)
{
  const Shape shape = this->Measure(triangle);
  if (!shape.TooLarge && !shape.TooFlat)
  {
    return;
  }
  double badness = 2.0 + shape.Area / this->Size.GetLeastBound();
  if (!shape.TooLarge)
  {
    const Point2 from = shape.From - shape.Apex;
    const Point2 to = shape.To - shape.Apex;
    const double squaredSine = 4.0 * shape.Area * shape.Area / (Dot(from, from) * Dot(to, to));
    badness = 1.0 - squaredSine / this->SquaredSine;
  }
  this->Bad.push({ badness, this->NextOrder++, triangle, this->Mesh.GetStamp(triangle) });
}

/** After an insertion: the new triangles may be bad, the segments in them encroached. */
void Refinement::LookAtStar()
{
  for (const int triangle : this->Mesh.GetStar())
  {
    this->Judge(triangle);
    for (const int neighbor : this->Mesh.GetTriangle(triangle).Neighbor)
    {
      if (neighbor < 0 && this->Splitter.CanSplit(~neighbor) &&
        this->Splitter.IsEncroached(~neighbor))
      {
        this->Splitter.Enqueue(~neighbor, false);
      }
    }
  }
}

/** How far the point for a triangle lies from its shortest edge: circumcentre or off-centre. */
double Refinement::CenterHeight(const Shape& shape) const
{
  const double half = 0.5 * std::sqrt(shape.SquaredShortest);
  const double dot = Dot(shape.From - shape.Apex, shape.To - shape.Apex);
  const double limit = OffCenterFactor * this->CotangentHalf;
  if (shape.Area <= 0.0) // by rounding: the circumcentre is too far away to be computed
  {
    return half * limit;
  }
  const double cotangent = dot / (2.0 * shape.Area); // of the angle at the apex
  return half * (shape.TooFlat ? std::min(cotangent, limit) : cotangent);
}

Point2 AboveEdge(const Shape& shape, double height)
{
  const Point2 edge = shape.To - shape.From;
  const double factor = height / std::sqrt(shape.SquaredShortest);
  return { 0.5 * (shape.From.x + shape.To.x) - factor * edge.y,
    0.5 * (shape.From.y + shape.To.y) + factor * edge.x };
}

bool Refinement::IsNearPreserved(const Point2& point, const Point2& a, const Point2& b) const
{
  const double dot = Dot(a - point, b - point);
  return dot < 0.0 &&
    dot * dot >
    this->CosineTwice * this->CosineTwice * SquaredDistance(a, point) * SquaredDistance(b, point);
}

bool Refinement::TouchesPreserved(int triangle) const
{
  const int* vertices = this->Mesh.GetTriangle(triangle).Vertex;
  return std::any_of(vertices, vertices + 3,
    [this](int vertex) { return this->Splitter.IsPreservedVertex(vertex); });
}

/**
 * Inserts a point that destroys the triangle, or finds what speaks against it: a segment in whose
 * circle it lies or behind which it is hidden, a small corner, a preserved segment near by, a
 * vertex nearer than the spacing.
 */
Attempt Refinement::TryPoint(
  int triangle, const Point2& point, Purpose purpose, double squaredSpacing, double squaredShortest)
{
  const bool isForArea = purpose == Purpose::Area || purpose == Purpose::AreaInside;
  const bool respectsPreserved = purpose == Purpose::Angle || purpose == Purpose::Area;
  this->Mesh.FindZone(triangle, point);
  const std::vector<RefinableTriangulation::ZoneEdge>& edges = this->Mesh.GetZoneEdges();
  if (edges.empty())
  {
    return Attempt::Refused;
  }
  const bool visible = this->Mesh.ZoneContains(point);
  const std::size_t waiting = this->Splitter.NumberWaiting();
  bool splitFirst = false;
  bool refused = !visible;
  for (const RefinableTriangulation::ZoneEdge& edge : edges)
  {
    const Point2& from = this->Mesh.GetPoint(edge.From);
    const Point2& to = this->Mesh.GetPoint(edge.To);
    refused = refused || SquaredDistance(from, point) < squaredSpacing;
    if (edge.Outside >= 0)
    {
      continue;
    }
    if (!this->Splitter.CanSplit(~edge.Outside))
    {
      refused = refused || (respectsPreserved && this->IsNearPreserved(point, from, to));
      continue;
    }
    const bool isCorner =
      this->Splitter.IsOpenCorner(edge.From) || this->Splitter.IsOpenCorner(edge.To);
    const bool isBehind = !visible && Orientation(from, to, point) <= 0;
    if (isCorner && !isForArea && !this->Splitter.CornerMayShrink(~edge.Outside, squaredShortest))
    {
      this->Splitter.ForgetSince(waiting);
      return Attempt::Refused;
    }
    if (isCorner || isBehind || Dot(from - point, to - point) < 0.0)
    {
      splitFirst = true;
      this->Splitter.Enqueue(~edge.Outside, true);
    }
  }
  if (splitFirst)
  {
    return Attempt::SplitFirst;
  }
  if (refused || this->Mesh.InsertInZone(point) < 0)
  {
    return Attempt::Refused;
  }
  this->LookAtStar();
  return Attempt::Inserted;
}

Attempt Refinement::RefineLarge(int triangle, const Shape& shape)
{
  const Point2 center = AboveEdge(shape, this->CenterHeight(shape));
  const Attempt attempt = this->TryPoint(triangle, center, Purpose::Area, 0.0, 0.0);
  if (attempt != Attempt::Refused || this->Size.HasLongPreservedSegments())
  {
    return attempt;
  }
  return this->TryPoint(triangle, Centroid(shape), Purpose::AreaInside, 0.0, 0.0);
}

Attempt Refinement::RefineFlat(int triangle, const Shape& shape)
{
  if (shape.SquaredShortest < this->Splitter.GetSquaredSmallestEdge())
  {
    return Attempt::Refused;
  }
  const double farthest = this->CenterHeight(shape);
  Attempt attempt = this->TryPoint(
    triangle, AboveEdge(shape, farthest), Purpose::Angle, 0.0, shape.SquaredShortest);
  // Down to the equilateral triangle on the shortest edge, never nearer to a vertex than that.
  const double nearest = 0.5 * std::numbers::sqrt3 * std::sqrt(shape.SquaredShortest);
  const double squaredSpacing = shape.SquaredShortest * (1.0 - 1e-9);
  constexpr int Tries = 3;
  for (const Purpose purpose : { Purpose::Angle, Purpose::AngleInside })
  {
    if (purpose == Purpose::AngleInside && this->TouchesPreserved(triangle))
    {
      break;
    }
    for (int i = 0; i <= Tries && attempt == Attempt::Refused && nearest < farthest; ++i)
    {
      const double height = farthest + (nearest - farthest) * i / Tries;
      attempt = this->TryPoint(
        triangle, AboveEdge(shape, height), purpose, squaredSpacing, shape.SquaredShortest);
    }
  }
  return attempt;
}

/** Inserts the lattice where the bound is as it is; false if the work has to stop. */
bool Refinement::InsertLattice()
{
  const std::vector<Point2> points = MakeLatticePoints(this->Boundary, this->Options.MaximumArea);
  this->Mesh.Reserve(points.size());
  TriangulationWalk walk(this->Mesh, this->Outside);
  int last = 0;
  this->PointsWaiting = points.size();
  for (const Point2& point : points)
  {
    --this->PointsWaiting;
    if (!this->Size.IsUniform() && this->Size.AreaBoundAt(point) != this->Options.MaximumArea)
    {
      continue;
    }
    const int triangle = walk.Find(point, last);
    if (triangle >= 0)
    {
      this->Mesh.FindZone(triangle, point);
      if (this->Mesh.InsertInZone(point) >= 0)
      {
        last = this->Mesh.GetStar().front();
      }
    }
    if (!this->Continue())
    {
      return false;
    }
  }
  return true;
}

/** Counts a step; false if the work has to stop. */
bool Refinement::Continue()
{
  if (this->Mesh.NumberOfTriangles() > this->Options.MaximumTriangles)
  {
    this->Outcome = RefinementOutcome::TooManyTriangles;
    return false;
  }
  ++this->Steps;
  if (this->Steps % 512 == 0 && this->Options.Progress)
  {
    const double done = static_cast<double>(this->Steps);
    const double waiting = static_cast<double>(this->Bad.size() + this->PointsWaiting);
    this->Fraction = std::max(this->Fraction, done / (done + waiting));
    if (!this->Options.Progress(this->Fraction))
    {
      this->Outcome = RefinementOutcome::Stopped;
      return false;
    }
  }
  return true;
}

RefinementOutcome Refinement::Run()
{
  const auto proceed = [this] { return this->Continue(); };
  if (std::isfinite(this->Options.MaximumArea) && !this->InsertLattice())
  {
    return this->Outcome;
  }
  for (int segment = 0; segment < this->Mesh.NumberOfSegments(); ++segment)
  {
    if (this->Splitter.CanSplit(segment) && this->Splitter.IsEncroached(segment))
    {
      this->Splitter.Enqueue(segment, false);
    }
  }
  if (!this->Splitter.SplitWaiting(proceed))
  {
    return this->Outcome;
  }
  this->Bad = {};
  for (int triangle = 0; triangle < this->Mesh.NumberOfTriangles(); ++triangle)
  {
    this->Judge(triangle);
  }
  while (!this->Bad.empty())
  {
    const BadTriangle bad = this->Bad.top();
    this->Bad.pop();
    if (bad.Stamp != this->Mesh.GetStamp(bad.Triangle))
    {
      continue;
    }
    const Shape shape = this->Measure(bad.Triangle);
    const Attempt attempt = shape.TooLarge ? this->RefineLarge(bad.Triangle, shape)
                                           : this->RefineFlat(bad.Triangle, shape);
    if (!this->Continue() || !this->Splitter.SplitWaiting(proceed))
    {
      return this->Outcome;
    }
    if (attempt == Attempt::SplitFirst && bad.Stamp == this->Mesh.GetStamp(bad.Triangle))
    {
      this->Judge(bad.Triangle);
    }
  }
  return this->Outcome;
}

} // namespace

RefinementOutcome RefineTriangulation(DomainTriangulation& triangulation,
  const DomainBoundary& boundary, const RefinementOptions& options)
{
  return Refinement(triangulation, boundary, options).Run();
}

} // namespace pemesh

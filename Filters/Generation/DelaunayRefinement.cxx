// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DelaunayRefinement.h"

#include "InputCorners.h"
#include "PlaneVectors.h"
#include "Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>

namespace pemesh
{

namespace
{

/** How far below the smallest feature of the input an edge may be shortened for an angle. */
constexpr double SmallestEdgeFactor = 1e-3;

/** Segments whose lengths differ by no more than this factor count as equally long. */
constexpr double EqualLengths = 1.001;

/** Off-centres lie this little nearer than the angle needs, so that rounding cannot spoil it. */
constexpr double OffCenterFactor = 0.95;

/** What is known of a triangle: its shortest edge, and why it has to go. */
struct Shape
{
  Point2 From; ///< the shortest edge, triangle on the left
  Point2 To;
  Point2 Apex;
  int FromVertex;
  int ToVertex;
  double SquaredShortest;
  double Area;
  bool TooLarge;
  bool TooFlat;
};

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

struct WaitingSegment
{
  int Segment;
  int From;
  int To;
  bool Forced; ///< to be split even if no vertex is in its circle (a refused point was)
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
  Refinement(
    RefinableTriangulation& mesh, const DomainBoundary& boundary, const RefinementOptions& options);

  RefinementOutcome Run();

private:
  // Segments
  std::array<int, 2> EndsOf(int segment) const;
  bool CanSplit(int segment) const;
  bool IsEncroached(int segment) const;
  int CornerOf(int segment) const;
  std::array<int, 2> CornerSegments(int corner) const;
  double LengthOf(int segment) const;
  void OpenCorner(int corner);
  void Enqueue(int segment, bool forced);
  void SplitSegment(int segment);
  void SplitCorner(int corner, double radius);
  void SplitAt(int segment, const Point2& point);
  bool SplitWaitingSegments();

  // Triangles
  Shape Measure(int triangle) const;
  void Judge(int triangle);
  void LookAtStar();
  bool TouchesPreserved(int triangle) const;
  double CenterHeight(const Shape& shape) const;
  bool IsNearPreserved(const Point2& point, const Point2& a, const Point2& b) const;
  Attempt TryPoint(int triangle, const Point2& point, Purpose purpose, double squaredSpacing);
  Point2 PointInside(int triangle, double area) const;
  Attempt RefineLarge(int triangle, const Shape& shape);
  Attempt RefineFlat(int triangle, const Shape& shape);
  bool Continue();

  bool IsInputVertex(int vertex) const { return vertex < static_cast<int>(this->EndingAt.size()); }
  /** Whether the domain's angle there is small and its segments may be split. */
  bool MayOpen(int vertex) const
  {
    return this->Corners.IsSmallCorner(vertex) && !this->Options.Preserved[vertex];
  }
  bool IsOpenCorner(int vertex) const
  {
    return this->IsInputVertex(vertex) && this->IsOpen[vertex];
  }

  RefinableTriangulation& Mesh;
  InputCorners Corners;
  const RefinementOptions& Options;
  double SquaredSine;   ///< of the minimum angle
  double CotangentHalf; ///< of half of it
  double CosineTwice;   ///< of twice of it
  double SquaredSmallestEdge = 0.0;
  std::vector<bool> IsOpen;      ///< an input vertex each: see OpenCorner
  std::vector<int> EndingAt;     ///< an input vertex each: the segment that ends there
  std::vector<bool> CannotSplit; ///< a segment each: too short for doubles
  std::vector<WaitingSegment> Waiting;
  std::priority_queue<BadTriangle> Bad;
  std::uint64_t NextOrder = 0;
  std::uint64_t Steps = 0;
  double Fraction = 0.0;
  RefinementOutcome Outcome = RefinementOutcome::Done;
};

Refinement::Refinement(
  RefinableTriangulation& mesh, const DomainBoundary& boundary, const RefinementOptions& options)
  : Mesh(mesh)
  , Corners(mesh, boundary)
  , Options(options)
  , IsOpen(boundary.Points.size(), false)
  , EndingAt(boundary.Before)
  , CannotSplit(boundary.Segments.size(), false)
{
  const double angle = options.MinimumAngle * std::numbers::pi / 180.0;
  // A little more than asked for, so that rounding in whoever measures finds no less.
  this->SquaredSine = std::sin(angle) * std::sin(angle) * (1.0 + 1e-10);
  this->CotangentHalf = 1.0 / std::tan(0.5 * angle);
  this->CosineTwice = std::cos(2.0 * angle);
  this->SquaredSmallestEdge =
    SmallestEdgeFactor * SmallestEdgeFactor * this->Corners.SquaredSmallestFeature();
}

// --- Segments ------------------------------------------------------------------------------------

std::array<int, 2> Refinement::EndsOf(int segment) const
{
  const RefinableTriangulation::Triangle& triangle =
    this->Mesh.GetTriangle(this->Mesh.GetSegment(segment).Triangle);
  const int edge = this->Mesh.EdgeOfSegment(segment);
  return { triangle.Vertex[(edge + 1) % 3], triangle.Vertex[(edge + 2) % 3] };
}

bool Refinement::CanSplit(int segment) const
{
  return !this->Options.Preserved[this->Mesh.GetSegment(segment).Input] &&
    !this->CannotSplit[segment];
}

/** The small corner that a segment starts or ends at, or -1. */
int Refinement::CornerOf(int segment) const
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  for (const int end : ends)
  {
    if (this->IsOpenCorner(end))
    {
      return end;
    }
  }
  return -1;
}

/** The two segments at a corner: the one that starts there (it keeps its number), then the other.
 */
std::array<int, 2> Refinement::CornerSegments(int corner) const
{
  return { corner, this->EndingAt[corner] };
}

double Refinement::LengthOf(int segment) const
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  return std::sqrt(SquaredDistance(this->Mesh.GetPoint(ends[0]), this->Mesh.GetPoint(ends[1])));
}

/**
 * Whether a vertex lies inside the diametral circle: the nearest is the apex of the triangle. At a
 * small corner, any vertex that parts the isosceles triangle of its two segments counts as well.
 */
bool Refinement::IsEncroached(int segment) const
{
  const RefinableTriangulation::Triangle& triangle =
    this->Mesh.GetTriangle(this->Mesh.GetSegment(segment).Triangle);
  const int edge = this->Mesh.EdgeOfSegment(segment);
  const Point2& apex = this->Mesh.GetPoint(triangle.Vertex[edge]);
  const Point2& from = this->Mesh.GetPoint(triangle.Vertex[(edge + 1) % 3]);
  const Point2& to = this->Mesh.GetPoint(triangle.Vertex[(edge + 2) % 3]);
  if (Dot(from - apex, to - apex) < 0.0)
  {
    return true;
  }
  const int corner = this->CornerOf(segment);
  if (corner < 0)
  {
    return false;
  }
  const std::array<int, 2> segments = this->CornerSegments(corner);
  return this->Mesh.GetSegment(segments[0]).Triangle != this->Mesh.GetSegment(segments[1]).Triangle;
}

void Refinement::Enqueue(int segment, bool forced)
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  this->Waiting.push_back({ segment, ends[0], ends[1], forced });
}

void Refinement::SplitAt(int segment, const Point2& point)
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  const Point2& from = this->Mesh.GetPoint(ends[0]);
  const Point2& to = this->Mesh.GetPoint(ends[1]);
  const double squaredLength = SquaredDistance(from, to);
  const bool between = Dot(point - from, to - from) > 0.0 && Dot(point - to, from - to) > 0.0;
  const bool possible = between && squaredLength >= 4.0 * this->SquaredSmallestEdge;
  if (possible)
  {
    this->Mesh.FindZoneOfSegment(segment, point);
  }
  if (!possible || this->Mesh.SplitSegment(segment, point) < 0)
  {
    this->CannotSplit[segment] = true;
    return;
  }
  this->CannotSplit.push_back(false);
  if (this->IsInputVertex(ends[1]) && this->EndingAt[ends[1]] == segment)
  {
    this->EndingAt[ends[1]] = this->Mesh.NumberOfSegments() - 1;
  }
  this->LookAtStar();
}

/** Splits both segments of a corner at the same distance. */
void Refinement::SplitCorner(int corner, double radius)
{
  for (const int segment : this->CornerSegments(corner))
  {
    const std::array<int, 2> ends = this->EndsOf(segment);
    const int other = ends[0] == corner ? ends[1] : ends[0];
    if (this->LengthOf(segment) > EqualLengths * radius)
    {
      this->SplitAt(segment, this->Corners.PointAt(radius, corner, other));
    }
  }
}

void Refinement::SplitSegment(int segment)
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  for (const int end : ends)
  {
    if (this->MayOpen(end) && !this->IsOpen[end])
    {
      this->OpenCorner(end); // which may be all that was needed
      return;
    }
  }
  const int corner = this->CornerOf(segment);
  if (corner >= 0)
  {
    this->SplitCorner(corner, InputCorners::ShellRadius(this->LengthOf(segment)));
    return;
  }
  this->SplitAt(segment, this->Corners.SplitPoint(ends[0], ends[1]));
}

/**
 * Makes the two segments of a small corner equally long. From now on they are split together, and
 * only for vertices that are there or for areas: to split them for angles would never end.
 */
void Refinement::OpenCorner(int corner)
{
  this->IsOpen[corner] = true;
  for (const int segment : this->CornerSegments(corner))
  {
    const std::array<int, 2> ends = this->EndsOf(segment);
    if (this->MayOpen(ends[0]) && this->MayOpen(ends[1]))
    {
      const double half = 0.5 * this->LengthOf(segment);
      this->SplitAt(segment, this->Corners.PointAt(half, ends[0], ends[1]));
    }
  }
  const std::array<int, 2> segments = this->CornerSegments(corner);
  const double first = this->LengthOf(segments[0]);
  const double second = this->LengthOf(segments[1]);
  const double shorter = std::min(first, second);
  const double ratio = std::max(first, second) / shorter;
  if (ratio > EqualLengths) // what is left of the longer one must not be much shorter than the rest
  {
    this->SplitCorner(corner, ratio > 1.5 ? shorter : InputCorners::ShellRadius(shorter));
  }
  for (const int segment : this->CornerSegments(corner))
  {
    this->Enqueue(segment, false);
  }
}

/** False if the work has to stop. */
bool Refinement::SplitWaitingSegments()
{
  for (std::size_t i = 0; i < this->Waiting.size(); ++i)
  {
    const WaitingSegment waiting = this->Waiting[i];
    const std::array<int, 2> ends = this->EndsOf(waiting.Segment);
    const bool unchanged = ends[0] == waiting.From && ends[1] == waiting.To;
    if (unchanged && this->CanSplit(waiting.Segment) &&
      (waiting.Forced || this->IsEncroached(waiting.Segment)))
    {
      this->SplitSegment(waiting.Segment);
      if (!this->Continue())
      {
        return false;
      }
    }
  }
  this->Waiting.clear();
  return true;
}

// --- Triangles -----------------------------------------------------------------------------------

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
  shape.FromVertex = vertex[(edge + 1) % 3];
  shape.ToVertex = vertex[(edge + 2) % 3];
  shape.From = this->Mesh.GetPoint(shape.FromVertex);
  shape.To = this->Mesh.GetPoint(shape.ToVertex);
  shape.Apex = this->Mesh.GetPoint(vertex[edge]);
  shape.SquaredShortest = squared[edge];
  shape.Area = 0.5 * Cross(shape.From - shape.Apex, shape.To - shape.Apex);
  // The smallest angle is at the apex, and its sine is twice the area over the two long sides.
  const double sides = squared[(edge + 1) % 3] * squared[(edge + 2) % 3];
  shape.TooFlat = 4.0 * shape.Area * shape.Area < this->SquaredSine * sides;
  shape.TooLarge = shape.Area > this->Options.MaximumArea * (1.0 - 1e-12);
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
  double badness = 2.0 + shape.Area / this->Options.MaximumArea;
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
      if (neighbor < 0 && this->CanSplit(~neighbor) && this->IsEncroached(~neighbor))
      {
        this->Enqueue(~neighbor, false);
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
    [this](int vertex) { return this->IsInputVertex(vertex) && this->Options.Preserved[vertex]; });
}

/**
 * Inserts a point that destroys the triangle, or finds what speaks against it: a segment in whose
 * circle it lies or behind which it is hidden, a small corner, a preserved segment near by, a
 * vertex nearer than the spacing.
 */
Attempt Refinement::TryPoint(
  int triangle, const Point2& point, Purpose purpose, double squaredSpacing)
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
  const auto waiting = static_cast<std::ptrdiff_t>(this->Waiting.size());
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
    if (!this->CanSplit(~edge.Outside))
    {
      const double cross=Cross(to-from,point-from);
      static const double K=getenv("KK")?atof(getenv("KK")):.5;
      refused = refused || (respectsPreserved && this->IsNearPreserved(point, from, to)) || cross*cross < K*K*squaredSpacing*SquaredDistance(from,to);
      continue;
    }
    const bool isCorner = this->IsOpenCorner(edge.From) || this->IsOpenCorner(edge.To);
    const bool isBehind = !visible && Orientation(from, to, point) <= 0;
    if (isCorner && !isForArea)
    {
      this->Waiting.erase(this->Waiting.begin() + waiting, this->Waiting.end());
      return Attempt::Refused;
    }
    if (isCorner || isBehind || Dot(from - point, to - point) < 0.0)
    {
      splitFirst = true;
      this->Enqueue(~edge.Outside, true);
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
  const Attempt attempt = this->TryPoint(triangle, center, Purpose::Area, 0.0);
  if (attempt != Attempt::Refused)
  {
    return attempt;
  }
  return this->TryPoint(
    triangle, this->PointInside(triangle, shape.Area), Purpose::AreaInside, 0.0);
}

/**
 * A point of a triangle that is too large. On a preserved edge, which keeps its length, the part
 * below the point gets the largest area allowed, so the angles there stay as large as they can.
 */
Point2 Refinement::PointInside(int triangle, double area) const
{
  const RefinableTriangulation::Triangle& corners = this->Mesh.GetTriangle(triangle);
  Point2 best;
  double longest = 0.0;
  for (int edge = 0; edge < 3; ++edge)
  {
    const int neighbor = corners.Neighbor[edge];
    const Point2& apex = this->Mesh.GetPoint(corners.Vertex[edge]);
    const Point2& from = this->Mesh.GetPoint(corners.Vertex[(edge + 1) % 3]);
    const Point2& to = this->Mesh.GetPoint(corners.Vertex[(edge + 2) % 3]);
    if (neighbor < 0 && !this->CanSplit(~neighbor) && SquaredDistance(from, to) > longest)
    {
      longest = SquaredDistance(from, to);
      const double fraction = std::min(0.5, 0.95 * this->Options.MaximumArea / area);
      const Point2 middle = { 0.5 * (from.x + to.x), 0.5 * (from.y + to.y) };
      best = { middle.x + fraction * (apex.x - middle.x),
        middle.y + fraction * (apex.y - middle.y) };
    }
  }
  if (longest > 0.0)
  {
    return best;
  }
  const Point2& a = this->Mesh.GetPoint(corners.Vertex[0]);
  const Point2& b = this->Mesh.GetPoint(corners.Vertex[1]);
  const Point2& c = this->Mesh.GetPoint(corners.Vertex[2]);
  return { (a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0 };
}

Attempt Refinement::RefineFlat(int triangle, const Shape& shape)
{
  if (shape.SquaredShortest < this->SquaredSmallestEdge)
  {
    return Attempt::Refused;
  }
  const double farthest = this->CenterHeight(shape);
  Attempt attempt = this->TryPoint(triangle, AboveEdge(shape, farthest), Purpose::Angle, 0.0);
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
      attempt = this->TryPoint(triangle, AboveEdge(shape, height), purpose, squaredSpacing);
    }
  }
  return attempt;
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
    const double waiting = static_cast<double>(this->Bad.size());
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
  for (int segment = 0; segment < this->Mesh.NumberOfSegments(); ++segment)
  {
    if (this->CanSplit(segment) && this->IsEncroached(segment))
    {
      this->Enqueue(segment, false);
    }
  }
  if (!this->SplitWaitingSegments())
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
    if (!this->Continue() || !this->SplitWaitingSegments())
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

RefinementOutcome RefineTriangulation(RefinableTriangulation& triangulation,
  const DomainBoundary& boundary, const RefinementOptions& options)
{
  return Refinement(triangulation, boundary, options).Run();
}

} // namespace pemesh

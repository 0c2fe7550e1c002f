// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundarySplitter.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

/** How far below the smallest feature of the input an edge may be shortened for an angle. */
constexpr double SmallestEdgeFactor = 1e-3;

/** Segments whose lengths differ by no more than this factor count as equally long. */
constexpr double EqualLengths = 1.001;

/** The power of two that is nearest (as a ratio) to half the length. */
double ShellRadius(double length)
{
  int exponent = 0;
  const double mantissa = std::frexp(0.5 * length, &exponent); // in [0.5, 1)
  return std::ldexp(1.0, mantissa * std::numbers::sqrt2 < 1.0 ? exponent - 1 : exponent);
}

} // namespace

BoundarySplitter::BoundarySplitter(RefinableTriangulation& mesh, const DomainBoundary& boundary,
  const std::vector<bool>& preserved, std::function<void()> afterInsertion)
  : Mesh(mesh)
  , Boundary(boundary)
  , Preserved(preserved)
  , AfterInsertion(std::move(afterInsertion))
  , IsAcute(boundary.Points.size(), false)
  , IsSmall(boundary.Points.size(), false)
  , IsOpen(boundary.Points.size(), false)
  , EndingAt(boundary.Before)
  , CannotSplit(boundary.Segments.size(), false)
{
  this->ClassifyCorners();
  this->SquaredSmallestEdge =
    SmallestEdgeFactor * SmallestEdgeFactor * this->SquaredSmallestFeature();
}

void BoundarySplitter::ClassifyCorners()
{
  const std::vector<Point2>& points = this->Boundary.Points;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2 next = points[this->Boundary.Segments[i].To] - points[i];
    const Point2 before =
      points[this->Boundary.Segments[this->Boundary.Before[i]].From] - points[i];
    // The domain is to the left, between `next` and `before` counter-clockwise.
    const bool convex = Cross(next, before) > 0.0;
    const double dot = Dot(next, before);
    this->IsAcute[i] = convex && dot > 0.0;
    this->IsSmall[i] =
      convex && dot > 0.0 && 4.0 * dot * dot > Dot(next, next) * Dot(before, before);
  }
}

/**
 * The square of the shortest distance between two vertices, or of a vertex from a segment, that see
 * each other in the triangulation as it is now.
 */
double BoundarySplitter::SquaredSmallestFeature() const
{
  double smallest = std::numeric_limits<double>::infinity();
  for (const RefinableTriangulation::Triangle& triangle : this->Mesh.GetTriangles())
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const Point2& apex = this->Mesh.GetPoint(triangle.Vertex[edge]);
      const Point2& from = this->Mesh.GetPoint(triangle.Vertex[(edge + 1) % 3]);
      const Point2& to = this->Mesh.GetPoint(triangle.Vertex[(edge + 2) % 3]);
      const double squaredLength = SquaredDistance(from, to);
      smallest = std::min(smallest, squaredLength);
      const bool footInside = Dot(apex - from, to - from) > 0.0 && Dot(apex - to, from - to) > 0.0;
      if (triangle.Neighbor[edge] < 0 && footInside)
      {
        const double cross = Cross(to - from, apex - from);
        smallest = std::min(smallest, cross * cross / squaredLength);
      }
    }
  }
  return smallest;
}

bool BoundarySplitter::CanSplit(int segment) const
{
  return !this->Preserved[this->Mesh.GetSegment(segment).Input] && !this->CannotSplit[segment];
}

bool BoundarySplitter::IsPreservedVertex(int vertex) const
{
  return this->IsInputVertex(vertex) && this->Preserved[vertex];
}

bool BoundarySplitter::IsAcuteCorner(int vertex) const
{
  return this->IsInputVertex(vertex) && this->IsAcute[vertex];
}

/** Whether the domain's angle there is small and its segments may be split. */
bool BoundarySplitter::MayOpen(int vertex) const
{
  return this->IsInputVertex(vertex) && this->IsSmall[vertex] && !this->Preserved[vertex];
}

bool BoundarySplitter::IsOpenCorner(int vertex) const
{
  return this->IsInputVertex(vertex) && this->IsOpen[vertex];
}

std::array<int, 2> BoundarySplitter::EndsOf(int segment) const
{
  const RefinableTriangulation::Triangle& triangle =
    this->Mesh.GetTriangle(this->Mesh.GetSegment(segment).Triangle);
  const int edge = this->Mesh.EdgeOfSegment(segment);
  return { triangle.Vertex[(edge + 1) % 3], triangle.Vertex[(edge + 2) % 3] };
}

/** The small corner that a segment starts or ends at, or -1. */
int BoundarySplitter::CornerOf(int segment) const
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
std::array<int, 2> BoundarySplitter::CornerSegments(int corner) const
{
  return { corner, this->EndingAt[corner] };
}

double BoundarySplitter::LengthOf(int segment) const
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  return std::sqrt(SquaredDistance(this->Mesh.GetPoint(ends[0]), this->Mesh.GetPoint(ends[1])));
}

/**
 * Whether a vertex lies inside the diametral circle: the nearest is the apex of the triangle. At a
 * small corner, any vertex that parts the isosceles triangle of its two segments counts as well.
 */
bool BoundarySplitter::IsEncroached(int segment) const
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

Point2 BoundarySplitter::PointAt(double distance, int end, int otherEnd) const
{
  const Point2& from = this->Mesh.GetPoint(end);
  const Point2& to = this->Mesh.GetPoint(otherEnd);
  const double fraction = distance / std::sqrt(SquaredDistance(from, to));
  // A coordinate that both ends share, such as 0 or 1 on the square, is kept exactly.
  return { from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y) };
}

void BoundarySplitter::SplitAt(int segment, const Point2& point)
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
  this->AfterInsertion();
}

/**
 * Whether the corner that a segment belongs to may be split for the sake of a flat triangle whose
 * shortest edge is given: no edge that the split makes may be shorter. Otherwise edges at the
 * corner would shrink without end, as the chord is ever shorter than the segments.
 */
bool BoundarySplitter::CornerMayShrink(int segment, double squaredShortest) const
{
  const int corner = this->CornerOf(segment);
  const std::array<int, 2> segments = this->CornerSegments(corner);
  const double length = this->LengthOf(segments[0]);
  const double radius = ShellRadius(length);
  const double chord = std::sqrt(SquaredDistance(this->Mesh.GetPoint(this->EndsOf(segments[0])[1]),
    this->Mesh.GetPoint(this->EndsOf(segments[1])[0])));
  const double least = std::min({ radius, length - radius, chord * radius / length });
  return least * least >= squaredShortest;
}

/** Splits both segments of a corner at the same distance. */
void BoundarySplitter::SplitCorner(int corner, double radius)
{
  for (const int segment : this->CornerSegments(corner))
  {
    const std::array<int, 2> ends = this->EndsOf(segment);
    const int other = ends[0] == corner ? ends[1] : ends[0];
    if (this->LengthOf(segment) > EqualLengths * radius)
    {
      this->SplitAt(segment, this->PointAt(radius, corner, other));
    }
  }
}

void BoundarySplitter::SplitSegment(int segment)
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
    this->SplitCorner(corner, ShellRadius(this->LengthOf(segment)));
    return;
  }
  const double length = this->LengthOf(segment);
  const bool fromAcute = this->IsAcuteCorner(ends[0]);
  const bool toAcute = this->IsAcuteCorner(ends[1]);
  const double distance = fromAcute == toAcute ? 0.5 * length : ShellRadius(length);
  const bool fromEnd = toAcute && !fromAcute;
  this->SplitAt(segment, this->PointAt(distance, ends[fromEnd ? 1 : 0], ends[fromEnd ? 0 : 1]));
}

/**
 * Makes the two segments of a small corner equally long. From now on they are split together, and
 * only for vertices that are there or for areas: to split them for angles would never end.
 */
void BoundarySplitter::OpenCorner(int corner)
{
  this->IsOpen[corner] = true;
  for (const int segment : this->CornerSegments(corner))
  {
    const std::array<int, 2> ends = this->EndsOf(segment);
    if (this->MayOpen(ends[0]) && this->MayOpen(ends[1]))
    {
      const double half = 0.5 * this->LengthOf(segment);
      this->SplitAt(segment, this->PointAt(half, ends[0], ends[1]));
    }
  }
  const std::array<int, 2> segments = this->CornerSegments(corner);
  const double first = this->LengthOf(segments[0]);
  const double second = this->LengthOf(segments[1]);
  const double shorter = std::min(first, second);
  const double ratio = std::max(first, second) / shorter;
  if (ratio > EqualLengths) // what is left of the longer one must not be much shorter than the rest
  {
    this->SplitCorner(corner, ratio > 1.5 ? shorter : ShellRadius(shorter));
  }
  for (const int segment : this->CornerSegments(corner))
  {
    this->Enqueue(segment, false);
  }
}

void BoundarySplitter::Enqueue(int segment, bool forced)
{
  const std::array<int, 2> ends = this->EndsOf(segment);
  this->Waiting.push_back({ segment, ends[0], ends[1], forced });
}

void BoundarySplitter::ForgetSince(std::size_t numberWaiting)
{
  this->Waiting.resize(numberWaiting);
}

bool BoundarySplitter::SplitWaiting(const std::function<bool()>& proceed)
{
  for (std::size_t i = 0; i < this->Waiting.size(); ++i) // which grows meanwhile
  {
    const WaitingSegment waiting = this->Waiting[i];
    const std::array<int, 2> ends = this->EndsOf(waiting.Segment);
    const bool unchanged = ends[0] == waiting.From && ends[1] == waiting.To;
    if (unchanged && this->CanSplit(waiting.Segment) &&
      (waiting.Forced || this->IsEncroached(waiting.Segment)))
    {
      this->SplitSegment(waiting.Segment);
      if (!proceed())
      {
        return false;
      }
    }
  }
  this->Waiting.clear();
  return true;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryCover.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

using Edge = BoundaryCover::Edge;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/** An interval of a parameter along a curve; empty as made. */
struct Bounds
{
  double Low = Infinity;
  double High = -Infinity;
};

/**
 * Where the line from `origin` along `direction` is within `radius` of an edge; not a number if
 * nowhere. At each end a point of the edge is at that distance: the foot of where the line enters
 * or leaves the strip around the line of the edge, or the end of the edge that this is beyond. What
 * rounding does to that point does not matter, for the bound is within the radius of it anyway.
 */
Bounds CutLine(const Point2& origin, const Point2& direction, const Edge& edge, double radius)
{
  const Point2 start = edge.Start - origin;
  const double height = Dot(start, LeftOf(direction));
  const double along = Dot(start, direction);
  const double sine = Dot(edge.Direction, LeftOf(direction));
  const double cosine = Dot(edge.Direction, direction);
  const double inverse = 1.0 / sine;
  const double half = std::abs(radius * inverse);
  const double middle = -cosine * height * inverse;
  const auto End = [&](double bound, double side)
  {
    // Of parallels the bound is infinite, or not a number; then max takes the start.
    const double foot = std::min(std::max(0.0, bound * cosine - sine * height), edge.Length);
    const double y = height + foot * sine;
    return along + foot * cosine + side * std::sqrt((radius - y) * (radius + y));
  };
  return { End(middle - half, -1.0), End(middle + half, 1.0) };
}

/** The tangent of half the angle from `axis` to a direction of length one; grows with the angle. */
double HalfTangent(const Point2& axis, const Point2& direction)
{
  return Dot(LeftOf(axis), direction) / (1.0 + Dot(axis, direction));
}

struct Arc // of directions, counter-clockwise
{
  bool IsEmpty = true;
  Point2 Low;
  Point2 High;
};

/**
 * The directions u for which center + radius u is within `radius` of an edge: those of discs
 * through the center that meet the edge. They make one arc, for the disc can roll along the edge.
 * At each end the disc passes through one point of the edge: where it touches the line of the edge,
 * or the end of the edge that this is beyond.
 */
Arc CutCircle(const Point2& center, const Edge& edge, double radius)
{
  const Point2 start = edge.Start - center;
  const Point2 left = LeftOf(edge.Direction);
  const double height = Dot(left, start);
  const double along = Dot(edge.Direction, start);
  const double beyond = std::max({ along, -(along + edge.Length), 0.0 });
  if (height * height + beyond * beyond >= 4.0 * radius * radius)
  {
    return {};
  }
  const double factor = 0.5 / radius;
  const double toSide = height < 0.0 ? -1.0 : 1.0;
  // Half of the chord that a disc through the center, touching the line, has along the line.
  const double reach = std::sqrt(std::abs(height) * std::max(0.0, 2.0 * radius - std::abs(height)));
  const auto End = [&](double side)
  {
    const double foot = std::min(std::max(0.0, -side * toSide * reach - along), edge.Length);
    const double x = along + foot;
    const double square = x * x + height * height;
    const double across = side * std::sqrt(std::max(0.0, 1.0 / square - factor * factor));
    const double u = factor * x - across * height; // in the frame of the edge
    const double v = factor * height + across * x;
    return Point2{ u * edge.Direction.x + v * left.x, u * edge.Direction.y + v * left.y };
  };
  return { false, End(-1.0), End(1.0) };
}

} // namespace

/** Points relative to the first vertex, directions from the vertices as given. */
void BoundaryCover::SetPolygon(PolygonView polygon)
{
  this->Edges.clear();
  this->NextCurve = 0;
  this->Scale = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 along = polygon[i + 1 == polygon.size() ? 0 : i + 1] - polygon[i];
    const double length = Length(along);
    if (length > 0.0)
    {
      const double inverse = 1.0 / length;
      this->Edges.push_back(
        { polygon[i] - polygon[0], { along.x * inverse, along.y * inverse }, length });
      this->Scale += 0.5 * length;
    }
  }
}

bool BoundaryCover::Contains(const Point2& point) const
{
  bool inside = false;
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    const Edge& edge = this->Edges[i];
    const Point2& end = this->Edges[i + 1 == this->Edges.size() ? 0 : i + 1].Start;
    if ((edge.Start.y > point.y) != (end.y > point.y))
    {
      const double side = Dot(LeftOf(edge.Direction), point - edge.Start);
      inside = inside != ((side > 0.0) == (end.y > edge.Start.y));
    }
  }
  return inside;
}

double BoundaryCover::DistanceFrom(const Point2& point) const
{
  double least = Infinity;
  for (const Edge& edge : this->Edges)
  {
    const Point2 offset = point - edge.Start;
    const double along = std::clamp(Dot(offset, edge.Direction), 0.0, edge.Length);
    least = std::min(
      least, Length({ offset.x - along * edge.Direction.x, offset.y - along * edge.Direction.y }));
  }
  return least;
}

/** Whether the polygon turns right at the start of an edge. */
bool BoundaryCover::IsReflex(std::size_t vertex) const
{
  const Edge& before = this->Edges[vertex == 0 ? this->Edges.size() - 1 : vertex - 1];
  return Dot(LeftOf(before.Direction), this->Edges[vertex].Direction) < 0.0;
}

bool BoundaryCover::FindFarther(double radius, double tolerance, Point2& point)
{
  this->Least = radius - tolerance;
  const std::size_t size = this->Edges.size();
  for (std::size_t i = 0; i < 2 * size; ++i)
  {
    const std::size_t edge = this->NextCurve / 2;
    const bool found = this->NextCurve % 2 == 0
      ? this->FindOnParallel(edge, radius, point)
      : this->IsReflex(edge) && this->FindOnArc(edge, radius, point);
    if (found)
    {
      return true;
    }
    this->NextCurve = this->NextCurve + 1 == 2 * size ? 0 : this->NextCurve + 1;
  }
  return false;
}

bool BoundaryCover::FindOnParallel(std::size_t index, double radius, Point2& point)
{
  const Edge& edge = this->Edges[index];
  const Point2 left = LeftOf(edge.Direction);
  const Point2 origin = { edge.Start.x + radius * left.x, edge.Start.y + radius * left.y };
  Curve curve = { 0.0, edge.Length, index, index };
  const auto Cut = [&](const Edge& other)
  {
    const Bounds bounds = CutLine(origin, edge.Direction, other, radius);
    this->Shrink(curve, { bounds.Low, bounds.High });
  };
  const auto Place = [&](double along) {
    return Point2{ origin.x + along * edge.Direction.x, origin.y + along * edge.Direction.y };
  };
  return !this->IsCovered(curve, Cut) && this->FindInGaps(curve, Place, point);
}

bool BoundaryCover::FindOnArc(std::size_t vertex, double radius, Point2& point)
{
  const std::size_t before = vertex == 0 ? this->Edges.size() - 1 : vertex - 1;
  const Point2& center = this->Edges[vertex].Start;
  const Point2 low = LeftOf(this->Edges[vertex].Direction);
  const Point2 high = LeftOf(this->Edges[before].Direction);
  Point2 axis = low + high;
  const double length = Length(axis);
  // An edge that goes back on itself leaves no middle direction but straight on.
  axis =
    length > 1e-12 ? Point2{ axis.x / length, axis.y / length } : this->Edges[before].Direction;
  Curve curve = { HalfTangent(axis, low), HalfTangent(axis, high), before, vertex };
  const auto Cut = [&](const Edge& other)
  {
    const Arc arc = CutCircle(center, other, radius);
    if (arc.IsEmpty)
    {
      return;
    }
    const double first = HalfTangent(axis, arc.Low);
    const double last = HalfTangent(axis, arc.High);
    if (first <= last)
    {
      this->Shrink(curve, { first, last });
      return;
    }
    this->Shrink(curve, { -Infinity, last }); // opposite to the axis it begins anew
    this->Shrink(curve, { first, Infinity });
  };
  const auto Place = [&](double tangent)
  {
    const double factor = radius / (1.0 + tangent * tangent);
    const double along = factor * (1.0 - tangent * tangent);
    const double across = factor * 2.0 * tangent;
    return Point2{ center.x + along * axis.x - across * axis.y,
      center.y + along * axis.y + across * axis.x };
  };
  return !this->IsCovered(curve, Cut) && this->FindInGaps(curve, Place, point);
}

/** Takes an interval off an end of the curve, or keeps it for later. */
void BoundaryCover::Shrink(Curve& curve, const Interval& interval)
{
  if (!(interval.High >= curve.Low) || !(interval.Low <= curve.High))
  {
    return;
  }
  if (interval.Low <= curve.Low)
  {
    curve.Low = interval.High;
  }
  else if (interval.High >= curve.High)
  {
    curve.High = interval.Low;
  }
  else
  {
    this->Intervals.push_back(interval);
  }
}

/** Cuts by the edges of the polygon, the nearest on the boundary first, until nothing is left. */
template <typename Cut>
bool BoundaryCover::IsCovered(Curve& curve, Cut&& cut)
{
  this->Intervals.clear();
  const std::size_t size = this->Edges.size();
  std::size_t previous = curve.First;
  std::size_t next = curve.Last;
  std::size_t left = size - (curve.First == curve.Last ? 1 : 2);
  while (left > 0 && curve.Low < curve.High)
  {
    previous = previous == 0 ? size - 1 : previous - 1;
    cut(this->Edges[previous]);
    if (--left > 0 && curve.Low < curve.High)
    {
      next = next + 1 == size ? 0 : next + 1;
      cut(this->Edges[next]);
      --left;
    }
  }
  return !(curve.Low < curve.High);
}

/** The middle of a part of the curve that no edge covers, if that is inside the polygon. */
template <typename Place>
bool BoundaryCover::FindInGaps(const Curve& curve, Place&& place, Point2& point)
{
  std::sort(this->Intervals.begin(), this->Intervals.end(),
    [](const Interval& a, const Interval& b) { return a.Low < b.Low; });
  this->Intervals.push_back({ curve.High, curve.High });
  double low = curve.Low;
  for (const Interval& interval : this->Intervals)
  {
    const double high = std::min(interval.Low, curve.High);
    if (low < high)
    {
      point = place(0.5 * (low + high));
      if (this->Contains(point) && this->DistanceFrom(point) > this->Least)
      {
        return true;
      }
    }
    low = std::max(low, interval.High);
  }
  return false;
}

} // namespace pemesh

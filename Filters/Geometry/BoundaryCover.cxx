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
    const double beside = bound * cosine - sine * height;
    const double foot = std::min(std::max(0.0, beside), edge.Length);
    const double y = height + foot * sine;
    const double square = (radius - y) * (radius + y);
    // Beside the edge it is negative by rounding alone, of almost parallels.
    return along + foot * cosine +
      side * std::sqrt(foot == beside ? std::max(0.0, square) : square);
  };
  return { End(middle - half, -1.0), End(middle + half, 1.0) };
}

/** The tangent of half the angle from `axis` to a direction of length one; grows with the angle. */
double HalfTangent(const Point2& axis, const Point2& direction)
{
  return Dot(LeftOf(axis), direction) / (1.0 + Dot(axis, direction));
}

double SquaredDistanceFrom(const Edge& edge, const Point2& point)
{
  const Point2 offset = point - edge.Start;
  const double along = std::clamp(Dot(offset, edge.Direction), 0.0, edge.Length);
  const Point2 away = { offset.x - along * edge.Direction.x, offset.y - along * edge.Direction.y };
  return Dot(away, away);
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
        { polygon[i] - polygon[0], { along.x * inverse, along.y * inverse }, length, 0.0, 0.0 });
      this->Scale += 0.5 * length;
    }
  }
  const Edge* before = this->Edges.empty() ? nullptr : &this->Edges.back();
  for (Edge& edge : this->Edges)
  {
    edge.Turn = Dot(LeftOf(before->Direction), edge.Direction);
    const double cosine = Dot(before->Direction, edge.Direction);
    edge.HalfTurn = cosine < 0.0 ? (1.0 - cosine) / edge.Turn : edge.Turn / (1.0 + cosine);
    before = &edge;
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
    least = std::min(least, SquaredDistanceFrom(edge, point));
  }
  return std::sqrt(least);
}

void BoundaryCover::FindEdgesAround(const Point2& common, double radius)
{
  this->Around.clear();
  this->IsAround.resize(this->Edges.size());
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    const bool isAround = SquaredDistanceFrom(this->Edges[i], common) <= radius * radius;
    this->IsAround[i] = isAround ? 1 : 0;
    if (isAround)
    {
      this->Around.push_back(i);
    }
  }
}

bool BoundaryCover::FindFarther(
  double radius, double tolerance, const Point2& common, Point2& point)
{
  if (this->Edges.size() < 3)
  {
    return false;
  }
  this->Least = radius - tolerance;
  this->FindEdgesAround(common, radius);
  const std::size_t size = this->Edges.size();
  const auto FindOnCurve = [&](std::size_t edge, bool isArc)
  {
    const std::size_t before = edge == 0 ? size - 1 : edge - 1;
    if (this->IsAround[edge] != 0 || (isArc && this->IsAround[before] != 0))
    {
      return false;
    }
    return isArc ? this->Edges[edge].Turn < 0.0 && this->FindOnArc(edge, radius, point)
                 : this->FindOnParallel(edge, radius, point);
  };
  for (std::size_t i = 0; i < 2 * size; ++i)
  {
    if (FindOnCurve(this->NextCurve / 2, this->NextCurve % 2 != 0))
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
  const auto Cut = [&](const Edge& other)
  {
    const Bounds bounds = CutLine(origin, edge.Direction, other, radius);
    this->Shrink({ bounds.Low, bounds.High });
  };
  // A neighbour at a reflex vertex ends where the curve begins. At another vertex, the curve and
  // its like of the neighbour meet where both are as far from the vertex, if both are that long.
  const std::size_t size = this->Edges.size();
  const std::size_t before = index == 0 ? size - 1 : index - 1;
  const std::size_t after = index + 1 == size ? 0 : index + 1;
  this->Rest = { 0.0, edge.Length };
  this->Intervals.clear();
  const auto MeetsAsFar = [radius](double turn, double halfTurn, double length)
  { return radius * std::max(turn, halfTurn) <= length; };
  const Edge& next = this->Edges[after];
  const bool closeToStart = MeetsAsFar(edge.Turn, edge.HalfTurn, this->Edges[before].Length);
  const bool closeToEnd = MeetsAsFar(next.Turn, next.HalfTurn, next.Length);
  this->Rest.Low = closeToStart ? std::max(0.0, radius * edge.HalfTurn) : 0.0;
  this->Rest.High -= closeToEnd ? std::max(0.0, radius * next.HalfTurn) : 0.0;
  if (!closeToStart && this->Rest.Low < this->Rest.High)
  {
    Cut(this->Edges[before]);
  }
  if (!closeToEnd && this->Rest.Low < this->Rest.High)
  {
    Cut(next);
  }
  const auto Place = [&](double along) {
    return Point2{ origin.x + along * edge.Direction.x, origin.y + along * edge.Direction.y };
  };
  return !this->IsCovered(before, after, size - 3, Cut) && this->FindInGaps(Place, point);
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
  this->Rest = { HalfTangent(axis, low), HalfTangent(axis, high) };
  this->Intervals.clear();
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
      this->Shrink({ first, last });
      return;
    }
    this->Shrink({ -Infinity, last }); // opposite to the axis it begins anew
    this->Shrink({ first, Infinity });
  };
  const auto Place = [&](double tangent)
  {
    const double factor = radius / (1.0 + tangent * tangent);
    const double along = factor * (1.0 - tangent * tangent);
    const double across = factor * 2.0 * tangent;
    return Point2{ center.x + along * axis.x - across * axis.y,
      center.y + along * axis.y + across * axis.x };
  };
  // An arc is mostly covered by what the circle found so far touches.
  for (std::size_t i = 0; i < this->Around.size() && this->Rest.Low < this->Rest.High; ++i)
  {
    Cut(this->Edges[this->Around[i]]);
  }
  return !this->IsCovered(before, vertex, this->Edges.size() - 2, Cut) &&
    this->FindInGaps(Place, point);
}

/** Takes an interval off an end of what is left of the curve, or keeps it for later. */
void BoundaryCover::Shrink(const Interval& interval)
{
  if (!(interval.High >= this->Rest.Low) || !(interval.Low <= this->Rest.High))
  {
    return;
  }
  if (interval.Low <= this->Rest.Low)
  {
    this->Rest.Low = interval.High;
  }
  else if (interval.High >= this->Rest.High)
  {
    this->Rest.High = interval.Low;
  }
  else
  {
    this->Intervals.push_back(interval);
  }
}

/** Cuts by `count` edges beyond two, the nearest on the boundary first, until nothing is left. */
template <typename Cut>
bool BoundaryCover::IsCovered(
  std::size_t previous, std::size_t next, std::size_t count, const Cut& cut)
{
  const std::size_t size = this->Edges.size();
  for (std::size_t i = 0; i < count && this->Rest.Low < this->Rest.High; ++i)
  {
    if (i % 2 == 0)
    {
      previous = previous == 0 ? size - 1 : previous - 1;
      cut(this->Edges[previous]);
    }
    else
    {
      next = next + 1 == size ? 0 : next + 1;
      cut(this->Edges[next]);
    }
  }
  return !(this->Rest.Low < this->Rest.High);
}

/** The middle of a part of the curve that no edge covers, if that is far enough inside. */
template <typename Place>
bool BoundaryCover::FindInGaps(const Place& place, Point2& point)
{
  std::sort(this->Intervals.begin(), this->Intervals.end(),
    [](const Interval& a, const Interval& b) { return a.Low < b.Low; });
  this->Intervals.push_back({ this->Rest.High, this->Rest.High });
  double low = this->Rest.Low;
  for (const Interval& interval : this->Intervals)
  {
    const double high = std::min(interval.Low, this->Rest.High);
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

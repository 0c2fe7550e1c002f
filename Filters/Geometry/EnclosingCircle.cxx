// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EnclosingCircle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

/** The points that carry the circle, at most three. */
struct Support
{
  std::array<Point2, 3> Points;
  int Count = 0;
};

double Distance(const Point2& a, const Point2& b)
{
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

Circle CircleOfTwo(const Point2& a, const Point2& b)
{
  return { { a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y) }, 0.5 * Distance(a, b) };
}

/** Relative to the first point, so that the distance from the origin costs no digits. */
bool CircleOfThree(const Point2& a, const Point2& b, const Point2& c, Circle& circle)
{
  const double bx = b.x - a.x;
  const double by = b.y - a.y;
  const double cx = c.x - a.x;
  const double cy = c.y - a.y;
  const double cross = bx * cy - by * cx;
  if (cross == 0.0)
  {
    return false;
  }
  const double bb = bx * bx + by * by;
  const double cc = cx * cx + cy * cy;
  const double x = (cy * bb - by * cc) / (2.0 * cross);
  const double y = (bx * cc - cx * bb) / (2.0 * cross);
  circle = { { a.x + x, a.y + y }, std::sqrt(x * x + y * y) };
  return std::isfinite(circle.Radius);
}

/** The smallest circle around the support and one more point that has that point on it. */
bool GrowSupport(Support& support, const Point2& point, Circle& circle)
{
  Circle best;
  best.Radius = std::numeric_limits<double>::infinity();
  Support bestSupport;
  const auto Try = [&](const Circle& candidate, std::array<Point2, 3> points, int count)
  {
    if (!(candidate.Radius < best.Radius))
    {
      return;
    }
    const double limit = candidate.Radius * (1.0 + 1e-14);
    for (int i = 0; i < support.Count; ++i)
    {
      if (Distance(candidate.Center, support.Points[static_cast<std::size_t>(i)]) > limit)
      {
        return;
      }
    }
    best = candidate;
    bestSupport = { points, count };
  };
  for (int i = 0; i < support.Count; ++i)
  {
    const Point2& a = support.Points[static_cast<std::size_t>(i)];
    Try(CircleOfTwo(a, point), { a, point, {} }, 2);
    for (int j = i + 1; j < support.Count; ++j)
    {
      const Point2& b = support.Points[static_cast<std::size_t>(j)];
      Circle candidate;
      if (CircleOfThree(point, a, b, candidate))
      {
        Try(candidate, { a, b, point }, 3);
      }
    }
  }
  // To rounding, the circle has to grow; if it does not there is nothing left to gain.
  if (!(best.Radius > circle.Radius) || !std::isfinite(best.Radius))
  {
    return false;
  }
  circle = best;
  support = bestSupport;
  return true;
}

} // namespace

Circle SmallestEnclosingCircle(PolygonView points)
{
  return SmallestEnclosingCircle(points, FarthestPair(points));
}

Circle SmallestEnclosingCircle(PolygonView points, const PointPair& farthest)
{
  if (points.empty())
  {
    return { {}, std::numeric_limits<double>::quiet_NaN() };
  }
  const Point2 origin = points[farthest.First];
  const auto Local = [origin](const Point2& p) { return Point2{ p.x - origin.x, p.y - origin.y }; };
  Support support;
  support.Points = { Point2{}, Local(points[farthest.Second]), Point2{} };
  support.Count = 2;
  Circle circle = CircleOfTwo(support.Points[0], support.Points[1]);
  for (;;)
  {
    double largest = 0.0;
    Point2 outside;
    for (const Point2& point : points)
    {
      const Point2 local = Local(point);
      const double distance = Distance(circle.Center, local);
      if (distance > largest)
      {
        largest = distance;
        outside = local;
      }
    }
    if (!(largest > circle.Radius * (1.0 + 1e-15)) || !GrowSupport(support, outside, circle))
    {
      break;
    }
  }
  return { { circle.Center.x + origin.x, circle.Center.y + origin.y }, circle.Radius };
}

} // namespace pemesh

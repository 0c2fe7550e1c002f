// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolylineSimplification.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pemesh
{

namespace
{

double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double along = length > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length : 0.0;
  const double s = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

/** Farthest from the segment between two points of a line, and how far. */
std::pair<std::size_t, double> FindFarthest(
  const std::vector<Point2>& points, std::size_t first, std::size_t last)
{
  std::pair<std::size_t, double> farthest(first, -1.0);
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double distance = DistanceToSegment(points[i], points[first], points[last]);
    if (distance > farthest.second)
    {
      farthest = { i, distance };
    }
  }
  return farthest;
}

std::vector<Point2> WithoutRepetition(const std::vector<Point2>& points)
{
  std::vector<Point2> kept;
  std::unique_copy(points.begin(), points.end(), std::back_inserter(kept));
  while (kept.size() > 1 && kept.front() == kept.back())
  {
    kept.pop_back();
  }
  return kept;
}

/** A closed line is simplified in two halves, from its first point to the farthest and back. */
std::vector<Point2> SimplifyLoop(const std::vector<Point2>& loop, double tolerance)
{
  if (loop.size() < 4)
  {
    return loop;
  }
  std::vector<Point2> closed = loop;
  closed.push_back(loop.front());
  const std::size_t far = FindFarthest(closed, 0, closed.size() - 1).first;
  const auto middle = closed.begin() + static_cast<std::ptrdiff_t>(far);
  std::vector<Point2> points = SimplifyPolyline({ closed.begin(), middle + 1 }, tolerance);
  const std::vector<Point2> back = SimplifyPolyline({ middle, closed.end() }, tolerance);
  points.insert(points.end(), back.begin() + 1, back.end() - 1);
  // Where the stroke began there need not be a corner.
  if (points.size() > 3 && DistanceToSegment(points.front(), points.back(), points[1]) <= tolerance)
  {
    points.erase(points.begin());
  }
  return points;
}

} // namespace

std::vector<Point2> SimplifyPolyline(const std::vector<Point2>& points, double tolerance)
{
  if (points.size() < 3)
  {
    return points;
  }
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, points.size() - 1 } };
  while (!open.empty())
  {
    const auto [first, last] = open.back();
    open.pop_back();
    const auto [farthest, distance] = FindFarthest(points, first, last);
    if (distance > tolerance)
    {
      kept[farthest] = true;
      open.emplace_back(first, farthest);
      open.emplace_back(farthest, last);
    }
  }
  std::vector<Point2> simplified;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (kept[i])
    {
      simplified.push_back(points[i]);
    }
  }
  return simplified;
}

std::vector<Point2> SnapToGrid(const std::vector<Point2>& points, double step)
{
  std::vector<Point2> snapped;
  for (const Point2& point : points)
  {
    snapped.push_back({ std::round(point.x / step) * step, std::round(point.y / step) * step });
  }
  return WithoutRepetition(snapped);
}

DrawnPolygon PolygonOfStroke(const std::vector<Point2>& stroke, double tolerance, double gridStep)
{
  const std::vector<Point2> loop = WithoutRepetition(stroke);
  constexpr int mostHalvings = 12;
  std::vector<Point2> points;
  for (int i = 0; i < mostHalvings; ++i, tolerance /= 2.0)
  {
    points = SimplifyLoop(loop, tolerance);
    points = gridStep > 0.0 ? SnapToGrid(points, gridStep) : points;
    if (IsSimple(points))
    {
      break;
    }
  }
  if (points.size() < 3)
  {
    return { {}, "A polygon needs three corners: draw a longer line around it." };
  }
  if (!IsSimple(points))
  {
    return { {}, "The line crosses itself: draw around the polygon once, without crossings." };
  }
  if (SignedArea(points) < 0.0)
  {
    std::reverse(points.begin() + 1, points.end());
  }
  return { std::move(points), {} };
}

} // namespace pemesh

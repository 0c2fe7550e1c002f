// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolylineSimplification.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pemesh;

namespace
{

double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length);
  const double s = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - s * (b.x - a.x), p.y - a.y - s * (b.y - a.y));
}

/** A circle of radius 1 with a ripple of that height, drawn clockwise. */
std::vector<Point2> Stroke(int points, double ripple)
{
  std::vector<Point2> stroke;
  for (int i = 0; i < points; ++i)
  {
    const double angle = -2.0 * std::numbers::pi * i / points;
    const double radius = 1.0 + ripple * (i % 2 == 0 ? 1.0 : -1.0);
    stroke.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return stroke;
}

} // namespace

TEST(PolylineSimplification, StraightLineIsItsEnds)
{
  std::vector<Point2> line;
  for (int i = 0; i <= 100; ++i)
  {
    line.push_back({ 0.5 * i, 0.25 * i });
  }
  const std::vector<Point2> expected{ line.front(), line.back() };
  EXPECT_EQ(SimplifyPolyline(line, 1e-9), expected);
}

TEST(PolylineSimplification, CornersStayAndNoPointIsFartherThanTheTolerance)
{
  std::vector<Point2> line;
  for (int i = 0; i <= 400; ++i)
  {
    const double x = i / 40.0;
    line.push_back({ x, std::sin(x) + (i % 2 == 0 ? 0.004 : -0.004) });
  }
  for (const double tolerance : { 0.01, 0.05, 0.3 })
  {
    const std::vector<Point2> simplified = SimplifyPolyline(line, tolerance);
    EXPECT_LT(simplified.size(), line.size() / 4);
    EXPECT_EQ(simplified.front(), line.front());
    EXPECT_EQ(simplified.back(), line.back());
    for (const Point2& point : line)
    {
      double least = INFINITY;
      for (std::size_t i = 0; i + 1 < simplified.size(); ++i)
      {
        least = std::min(least, DistanceToSegment(point, simplified[i], simplified[i + 1]));
      }
      EXPECT_LE(least, tolerance);
    }
  }
  EXPECT_EQ(SimplifyPolyline(line, 0.0).size(), line.size()) << "nothing is on a segment";
}

TEST(PolylineSimplification, AStrokeBecomesASimpleCounterClockwisePolygon)
{
  const DrawnPolygon drawn = PolygonOfStroke(Stroke(500, 0.002), 0.01, 0.0);
  EXPECT_EQ(drawn.Fault, "");
  EXPECT_TRUE(IsSimple(drawn.Points));
  EXPECT_LT(drawn.Points.size(), 60U);
  EXPECT_NEAR(SignedArea(drawn.Points), std::numbers::pi, 0.05);
}

TEST(PolylineSimplification, WhereSimplificationWouldCrossItIsFiner)
{
  // A notch so narrow that the tolerance is wider than it.
  std::vector<Point2> stroke{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.51, 1 }, { 0.5, 0.02 }, { 0.49, 1 },
    { 0, 1 } };
  const DrawnPolygon drawn = PolygonOfStroke(stroke, 0.03, 0.0);
  EXPECT_EQ(drawn.Fault, "");
  EXPECT_TRUE(IsSimple(drawn.Points));
}

TEST(PolylineSimplification, SnappedCornersAreOnTheGrid)
{
  const DrawnPolygon drawn = PolygonOfStroke(Stroke(300, 0.0), 0.02, 0.25);
  EXPECT_EQ(drawn.Fault, "");
  EXPECT_TRUE(IsSimple(drawn.Points));
  for (const Point2& point : drawn.Points)
  {
    EXPECT_EQ(point.x * 4.0, std::round(point.x * 4.0));
    EXPECT_EQ(point.y * 4.0, std::round(point.y * 4.0));
  }
}

TEST(PolylineSimplification, WhatIsNoPolygonIsTold)
{
  EXPECT_NE(PolygonOfStroke({}, 0.01, 0.0).Fault, "");
  EXPECT_NE(PolygonOfStroke({ { 0, 0 }, { 1, 1 }, { 0, 0 } }, 0.01, 0.0).Fault, "");
  const DrawnPolygon eight = PolygonOfStroke({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, 0.01, 0.0);
  EXPECT_NE(eight.Fault, "");
  EXPECT_TRUE(eight.Points.empty());
}

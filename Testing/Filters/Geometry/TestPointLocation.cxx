// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointLocation.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pemesh;
using namespace pemesh::test;

TEST(PointLocation, AVertexAtTheHeightOfThePointCountsOnce)
{
  const Polygon zigzag = { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 3, 1 }, { 2, 2 }, { 1, 1 }, { 0, 2 } };
  EXPECT_EQ(LocatePoint(zigzag, { 0.5, 1 }), PointLocation::Inside);
  EXPECT_EQ(LocatePoint(zigzag, { 1, 1 }), PointLocation::OnBoundary);
  EXPECT_EQ(LocatePoint(zigzag, { 2, 1 }), PointLocation::Inside);
  EXPECT_EQ(LocatePoint(zigzag, { -1, 1 }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(zigzag, { -1, 2 }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(zigzag, { 1, 2 }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(zigzag, { 5, 1 }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(zigzag, { -1, 0 }), PointLocation::Outside); // along the lowest edge
  EXPECT_EQ(LocatePoint(zigzag, { 2, 0 }), PointLocation::OnBoundary);
  EXPECT_EQ(LocatePoint(zigzag, { 5, 0 }), PointLocation::Outside);
}

TEST(PointLocation, OneUnitInTheLastPlaceDecides)
{
  const Polygon triangle = { { 0, 0 }, { 3, 1 }, { 0, 1 } };
  const double x = 1.5;
  const double y = 0.5;
  EXPECT_EQ(LocatePoint(triangle, { x, y }), PointLocation::OnBoundary);
  EXPECT_EQ(LocatePoint(triangle, { x, std::nextafter(y, 1.0) }), PointLocation::Inside);
  EXPECT_EQ(LocatePoint(triangle, { x, std::nextafter(y, 0.0) }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(triangle, { std::nextafter(x, 2.0), y }), PointLocation::Outside);
  EXPECT_EQ(LocatePoint(triangle, { std::nextafter(x, 1.0), y }), PointLocation::Inside);
}

TEST(PointLocation, AgreesWithTheDistanceInsideOfRandomPolygons)
{
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed + 77);
    const Polygon polygon = RandomPolygon(seed, 3, 40);
    const Polygon reversed(polygon.rbegin(), polygon.rend());
    for (int i = 0; i < 40; ++i)
    {
      const Point2 point = { random.Uniform(-1.2, 1.2), random.Uniform(-1.2, 1.2) };
      const bool expected = BruteDistanceInside(polygon, point) > 0.0;
      inside += expected ? 1 : 0;
      EXPECT_EQ(ContainsPoint(polygon, point), expected) << seed;
      EXPECT_EQ(ContainsPoint(reversed, point), expected) << seed;
    }
    for (const Point2& vertex : polygon)
    {
      EXPECT_EQ(LocatePoint(polygon, vertex), PointLocation::OnBoundary) << seed;
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(PointLocation, WhatIsNoPolygonOrNoPointIsOutside)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ContainsPoint({}, { 0, 0 }));
  const Polygon segment = { { 0, 0 }, { 1, 0 } };
  EXPECT_FALSE(ContainsPoint(segment, { 0.5, 0 }));
  const Polygon square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_FALSE(ContainsPoint(square, { nan, 0.5 }));
  EXPECT_FALSE(ContainsPoint(square, { 0.5, nan }));
  const Polygon repeated = { { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 1 } };
  EXPECT_TRUE(ContainsPoint(repeated, { 0.5, 0.5 }));
  EXPECT_FALSE(ContainsPoint(repeated, { -0.5, 1.0 }));
}

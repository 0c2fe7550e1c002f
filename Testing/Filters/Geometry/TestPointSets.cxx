// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EnclosingCircle.h"
#include "PointDistances.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

using namespace pemesh;
using namespace pemesh::test;

TEST(PointDistances, AgreeWithAllPairs)
{
  for (std::uint64_t seed = 0; seed < 120; ++seed)
  {
    // Small sets and large ones take different ways; half of them lie on their hull.
    const Polygon polygon = Transformed(
      RandomPolygon(seed, 3, 200), 1.0 + static_cast<double>(seed), 1.0, { 100.0, 1e3 });
    double largest = 0.0;
    double least = 1e300;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      for (std::size_t j = i + 1; j < polygon.size(); ++j)
      {
        const double distance =
          std::hypot(polygon[i].x - polygon[j].x, polygon[i].y - polygon[j].y);
        largest = std::max(largest, distance);
        least = std::min(least, distance);
      }
    }
    EXPECT_NEAR(Diameter(polygon), largest, 1e-15 * largest) << seed;
    EXPECT_NEAR(ClosestPair(polygon).Distance, least, 1e-15 * largest) << seed;
    const DistanceRange both = MeasureDistances(polygon);
    EXPECT_EQ(both.Farthest.Distance, Diameter(polygon)) << seed;
    EXPECT_EQ(both.Farthest.First, FarthestPair(polygon).First) << seed;
    EXPECT_EQ(both.Farthest.Second, FarthestPair(polygon).Second) << seed;
    EXPECT_EQ(both.Least, ClosestPair(polygon).Distance) << seed;
  }
}

TEST(PointDistances, LargeSetsWithTiesAndRepeats)
{
  Polygon points = RegularPolygon(1000);
  EXPECT_NEAR(Diameter(points), 2.0, 1e-15);
  EXPECT_NEAR(ClosestPair(points).Distance, 2.0 * std::sin(std::numbers::pi / 1000), 1e-15);
  points.insert(points.begin() + 500, points[499]);
  EXPECT_EQ(ClosestPair(points).Distance, 0.0);
  EXPECT_NEAR(Diameter(points), 2.0, 1e-15);
  Polygon line;
  for (int i = 0; i < 100; ++i)
  {
    line.push_back({ 0.0, static_cast<double>(i) });
  }
  EXPECT_EQ(Diameter(line), 99.0);
  EXPECT_EQ(ClosestPair(line).Distance, 1.0);
  EXPECT_EQ(Diameter(Polygon(100, { 3.0, 4.0 })), 0.0);
  for (const std::size_t size : { 2, 3, 48, 49 })
  {
    const Polygon repeated(size, { 3.0, 4.0 });
    EXPECT_EQ(MeasureDistances(repeated).Farthest.Distance, 0.0) << size;
    EXPECT_EQ(MeasureDistances(repeated).Least, 0.0) << size;
    const DistanceRange part = MeasureDistances(PolygonView(line).first(size));
    EXPECT_EQ(part.Farthest.Distance, static_cast<double>(size - 1)) << size;
    EXPECT_EQ(part.Least, 1.0) << size;
  }
}

TEST(EnclosingCircle, AgreesWithAllPairsAndTriples)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 3, 24);
    const double expected = BruteEnclosingRadius(polygon);
    EXPECT_NEAR(SmallestEnclosingCircle(polygon).Radius, expected, 1e-14 * expected) << seed;
  }
}

TEST(EnclosingCircle, HardPolygonsAndNearRepeats)
{
  for (const NamedPolygon& hard : HardPolygons())
  {
    const double expected = BruteEnclosingRadius(hard.Vertices);
    EXPECT_NEAR(SmallestEnclosingCircle(hard.Vertices).Radius, expected, 1e-14 * expected)
      << hard.Name;
  }
  Polygon repeated;
  Random random(5);
  for (const Point2& p : RegularPolygon(7))
  {
    for (int i = 0; i < 5; ++i)
    {
      repeated.push_back({ p.x + random.Uniform(-1e-15, 1e-15), p.y });
      repeated.push_back(repeated.back());
    }
  }
  EXPECT_NEAR(SmallestEnclosingCircle(repeated).Radius, 1.0, 1e-14);
  EXPECT_NEAR(SmallestEnclosingCircle(RegularPolygon(10000)).Radius, 1.0, 1e-14);
  EXPECT_EQ(SmallestEnclosingCircle(Polygon(5, { 1.0, 2.0 })).Radius, 0.0);
}

TEST(EnclosingCircle, InvariantUnderMotionAndScale)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 3, 30);
    const double radius = SmallestEnclosingCircle(polygon).Radius;
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      const Polygon moved =
        Transformed(polygon, 0.1 * static_cast<double>(seed), scale, { 100 * scale, scale });
      EXPECT_NEAR(SmallestEnclosingCircle(moved).Radius / scale, radius, 1e-13) << seed;
    }
  }
}

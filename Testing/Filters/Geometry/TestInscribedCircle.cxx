// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "InscribedCircle.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

using namespace pemesh;
using namespace pemesh::test;

TEST(InscribedCircle, KnownShapes)
{
  EXPECT_NEAR(LargestInscribedCircle(UnitSquare()).Radius, 0.5, 1e-15);
  EXPECT_NEAR(LargestInscribedCircle(RegularPolygon(3)).Radius, 0.5, 1e-15);
  EXPECT_NEAR(LargestInscribedCircle(RegularPolygon(6)).Radius, std::sqrt(0.75), 1e-15);
  const Polygon lShape = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  // Touches two sides and the reflex corner: r sqrt(2) + r = sqrt(2).
  EXPECT_NEAR(LargestInscribedCircle(lShape).Radius, 2.0 - std::sqrt(2.0), 1e-14);
  // INR = 2 r / h of the specification, h = sqrt(2).
  EXPECT_NEAR(
    2.0 * LargestInscribedCircle(ConvexityFamily(0.7)).Radius / std::sqrt(2.0), 0.2485, 5e-5);
}

TEST(InscribedCircle, ANotchOfAKnownSizeInACorridor)
{
  // Two parallel walls: every centre on the middle line is as good.
  const Polygon corridor = { { 0, 0 }, { 10, 0 }, { 10, 1 }, { 6, 1 }, { 5, 0.5 }, { 4, 1 },
    { 0, 1 } };
  EXPECT_NEAR(LargestInscribedCircle(corridor).Radius, 0.5, 1e-15);
}

TEST(InscribedCircle, AgreesWithAllTriplesOfFeatures)
{
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 4, 12);
    const double expected = BruteInscribedRadius(polygon);
    EXPECT_NEAR(LargestInscribedCircle(polygon).Radius, expected, 1e-11 * expected + 1e-15)
      << "seed " << seed << " size " << polygon.size();
  }
}

TEST(InscribedCircle, HardPolygonsAgreeWithAllTriples)
{
  for (const NamedPolygon& hard : HardPolygons())
  {
    if (hard.Vertices.size() > 30)
    {
      continue;
    }
    const double expected = BruteInscribedRadius(hard.Vertices);
    EXPECT_NEAR(LargestInscribedCircle(hard.Vertices).Radius, expected, 1e-11 * expected + 4e-15)
      << hard.Name;
  }
  EXPECT_NEAR(LargestInscribedCircle(StarFamily(40)).Radius, 1.0, 1e-14);
}

TEST(InscribedCircle, SquashedPolygonsAgreeWithAllTriples)
{
  // Ever thinner, and not convex: the search must not take as many steps as they are thin. Below
  // 1e-5 the enumeration loses digits, in extended precision too, and is a lower bound only.
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    Random random(seed);
    Polygon polygon = Untangled(random, 10);
    const double thickness = std::pow(10.0, -0.2 * static_cast<double>(seed));
    for (Point2& point : polygon)
    {
      point.y *= thickness;
    }
    const double radius = LargestInscribedCircle(polygon).Radius;
    const double expected = BruteInscribedRadius(polygon);
    const double tolerance = 1e-11 * expected + 4e-15;
    EXPECT_GE(radius, expected - tolerance) << seed;
    EXPECT_LE(radius, 0.5 * thickness) << seed;
    if (thickness > 1e-5)
    {
      EXPECT_NEAR(radius, expected, tolerance) << seed;
    }
  }
}

TEST(InscribedCircle, TheCircleIsInside)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 5, 40);
    const Circle circle = LargestInscribedCircle(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2& a = polygon[i];
      EXPECT_GE(
        std::hypot(a.x - circle.Center.x, a.y - circle.Center.y), circle.Radius * (1.0 - 1e-12));
    }
  }
}

TEST(InscribedCircle, InvariantUnderMotionScaleAndShift)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 5, 25);
    const double radius = LargestInscribedCircle(polygon).Radius;
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      const Polygon moved = Transformed(polygon, 0.3 + static_cast<double>(seed), scale, {});
      EXPECT_NEAR(LargestInscribedCircle(moved).Radius / scale, radius, 1e-13) << seed;
    }
    const Polygon far = Transformed(polygon, 0.0, 1.0, { 1e4, -1e4 });
    EXPECT_NEAR(LargestInscribedCircle(far).Radius, radius, 1e-11) << seed;
    Polygon shifted = polygon;
    std::rotate(shifted.begin(), shifted.begin() + 2, shifted.end());
    EXPECT_NEAR(LargestInscribedCircle(shifted).Radius, radius, 1e-14) << seed;
  }
}

TEST(InscribedCircle, OfTheKernelAgreesWithAllTriples)
{
  int empty = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 6, 18);
    const double expected = BruteKernelRadius(polygon);
    empty += expected == 0.0 ? 1 : 0;
    EXPECT_NEAR(LargestCircleInKernel(polygon).Radius, expected, 1e-14) << "seed " << seed;
  }
  EXPECT_GT(empty, 20);
  EXPECT_LT(empty, 350);
}

TEST(BoundaryCover, FindsWhatOnlyArcsAroundReflexVerticesBound)
{
  // The room in the middle of a star: all that bounds it are the vertices between the spikes.
  const Polygon star = StarFamily(12);
  BoundaryCover cover;
  cover.SetPolygon(star);
  for (const double radius : { 0.9, 0.99, 0.999999 })
  {
    Point2 point;
    // From the first vertex: a vertex of the star, its center, and a point far outside.
    for (const Point2& common : { Point2{}, Point2{ -star[0].x, -star[0].y }, Point2{ 9, 9 } })
    {
      ASSERT_TRUE(cover.FindFarther(radius, 1e-9, common, point)) << radius;
      EXPECT_GT(cover.DistanceFrom(point), radius - 1e-9);
      EXPECT_TRUE(cover.Contains(point));
      EXPECT_FALSE(cover.FindFarther(1.0 + 1e-9, 1e-12, common, point));
    }
  }
}

TEST(BoundaryCover, TellsTheRadiusFromAllOthers)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 4, 12);
    const double radius = BruteInscribedRadius(polygon);
    BoundaryCover cover;
    cover.SetPolygon(polygon);
    Point2 point;
    // Whatever the common point: it spares curves, and no answer may depend on it.
    const Point2& vertex = polygon[seed % polygon.size()];
    const Point2 common = { vertex.x - polygon[0].x, vertex.y - polygon[0].y };
    for (const double share : { 0.5, 0.9, 0.999, 0.9999999 })
    {
      EXPECT_TRUE(cover.FindFarther(share * radius, 1e-9 * radius, common, point))
        << seed << ' ' << share;
    }
    for (const double share : { 1.0000001, 1.001, 1.1, 2.0 })
    {
      EXPECT_FALSE(cover.FindFarther(share * radius, 1e-9 * radius, common, point))
        << seed << ' ' << share;
    }
  }
}

TEST(InscribedCircle, TenThousandVertices)
{
  EXPECT_NEAR(LargestInscribedCircle(RegularPolygon(10000)).Radius,
    std::cos(std::numbers::pi / 10000), 1e-13);
  Polygon gear = RegularPolygon(10000);
  for (std::size_t i = 0; i < gear.size(); i += 2)
  {
    gear[i] = { 1.1 * gear[i].x, 1.1 * gear[i].y };
  }
  EXPECT_NEAR(LargestInscribedCircle(gear).Radius, 1.0, 1e-12);
}

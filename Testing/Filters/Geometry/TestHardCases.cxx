// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Every kernel on what is hard: next to discontinuities, repeated vertices, clockwise, very many.
 */
#include "PolygonValidity.h"

#include "KernelQuantities.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

void ExpectAllAgree(const Polygon& polygon, const std::string& name)
{
  const double diameter = Diameter(polygon);
  for (const Quantity& quantity : Quantities)
  {
    const double expected = quantity.Expected(polygon);
    EXPECT_NEAR(quantity.Kernel(polygon), expected, Allowed(expected, quantity.Power, diameter))
      << quantity.Name << " of " << name;
  }
}

constexpr double Offsets[] = { 0.0, 1e-9, -1e-9, 1e-10, -1e-10, 1e-12, -1e-12, 1e-15, -1e-15, 1e-17,
  -1e-17, 1e-300, -1e-300 };

/** Random radii: not a circle in sight, and half of the vertices are reflex. */
Polygon Burr(int size)
{
  Random random(3);
  return StarShaped(random, size, 0.9);
}

/** A corridor of height 1 with teeth above it. */
Polygon Comb(int teeth)
{
  Polygon polygon = { { 0.0, 0.0 }, { 2.0 * teeth, 0.0 } };
  for (int i = teeth; i > 0; --i)
  {
    polygon.push_back({ 2.0 * i, 5.0 });
    polygon.push_back({ 2.0 * i - 0.1, 5.0 });
    polygon.push_back({ 2.0 * i - 0.1, 1.0 });
    polygon.push_back({ 2.0 * i - 2.0, 1.0 });
  }
  return polygon;
}

} // namespace

TEST(HardCases, AtAllScalesAndPlaces)
{
  constexpr double Scales[] = { 1e-9, 1.0, 1e9 };
  std::size_t number = 0;
  for (const NamedPolygon& hard : HardPolygons())
  {
    if (hard.Vertices.size() < 30) // more are too many for brute force
    {
      const double scale = Scales[number++ % std::size(Scales)];
      ExpectAllAgree(Transformed(hard.Vertices, 0.0, scale, {}), hard.Name);
      const Polygon far = Transformed(hard.Vertices, 0.1, scale, { 7.0 * scale, 0.0 });
      if (IsSimple(far)) // as rounded
      {
        ExpectAllAgree(far, hard.Name + ", moved");
      }
    }
  }
}

TEST(HardCases, NextToAStraightVertex)
{
  for (const double offset : Offsets)
  {
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      // At offset 0 it is straight; reflex above the line.
      const Polygon polygon =
        Transformed({ { -1, 0 }, { 0, offset }, { 1, 0 }, { 0.2, 1 } }, 0.0, scale, {});
      ExpectAllAgree(polygon, "a vertex off by " + std::to_string(offset));
      EXPECT_EQ(IsConvex(polygon), offset <= 0.0) << offset;
    }
  }
}

TEST(HardCases, NextToAnEmptyKernel)
{
  for (const double offset : Offsets)
  {
    const double x = 1.0 + offset;
    const Polygon polygon = { { 0, 0 }, { x, 0 }, { x, 1 }, { 2, 1 }, { 2, 3 }, { 1, 3 }, { 1, 2 },
      { 0, 2 } };
    ExpectAllAgree(polygon, "a kernel of width " + std::to_string(offset));
    EXPECT_NEAR(SignedArea(PolygonKernel(polygon)), std::max(0.0, x - 1.0), 1e-15) << offset;
    EXPECT_NEAR(LargestCircleInKernel(polygon).Radius, std::max(0.0, 0.5 * (x - 1.0)), 1e-15);
  }
}

TEST(HardCases, NextToTwoEqualCircles)
{
  for (const double offset : Offsets)
  {
    const Polygon dumbbell = { { 0, 0 }, { 1, 0 }, { 1, .4 }, { 2, .4 }, { 2, 0 },
      { 3 + offset, 0 }, { 3 + offset, 1 }, { 2, 1 }, { 2, .6 }, { 1, .6 }, { 1, 1 }, { 0, 1 } };
    ExpectAllAgree(dumbbell, "two rooms");
  }
}

TEST(HardCases, RepeatedVertices)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 4, 12);
    Polygon repeated;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      repeated.insert(repeated.end(), (i + seed) % 3 == 0 ? 3 : 1, polygon[i]);
    }
    for (const Quantity& quantity : Quantities)
    {
      const double expected =
        std::string(quantity.Name) == "closest pair" ? 0.0 : quantity.Kernel(polygon);
      EXPECT_NEAR(quantity.Kernel(repeated), expected, 1e-12) << quantity.Name << ' ' << seed;
    }
    EXPECT_EQ(IsConvex(repeated), IsConvex(polygon)) << seed;
    EXPECT_EQ(PolygonOrientation(repeated), 1) << seed;
  }
}

TEST(HardCases, ClockwisePolygonsAreTold)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 4, 12);
    const Polygon clockwise(polygon.rbegin(), polygon.rend());
    EXPECT_EQ(PolygonOrientation(clockwise), -1) << seed;
    EXPECT_NEAR(SignedArea(clockwise), -SignedArea(polygon), 1e-15) << seed;
    EXPECT_FALSE(IsConvex(clockwise)) << seed;
    EXPECT_EQ(LargestCircleInKernel(clockwise).Radius, 0.0) << seed;
    EXPECT_DOUBLE_EQ(Diameter(clockwise), Diameter(polygon)) << seed;
    EXPECT_NEAR(
      SmallestEnclosingCircle(clockwise).Radius, SmallestEnclosingCircle(polygon).Radius, 1e-14)
      << seed;
  }
}

TEST(HardCases, TenThousandVerticesTakeSecondsAtMost)
{
  // The test as a whole has a limit of time; n^2 log n of a slow kernel would break it.
  const Polygon burr = Burr(10000);
  const Circle inBurr = LargestInscribedCircle(burr);
  EXPECT_NEAR(BruteDistanceInside(burr, inBurr.Center), inBurr.Radius, 1e-12);
  EXPECT_NEAR(LargestCircleInKernel(burr).Radius, 0.0, inBurr.Radius);
  EXPECT_GE(SignedArea(PolygonKernel(burr)), 0.0);
  EXPECT_LE(SmallestEnclosingCircle(burr).Radius, 1.0);

  const Polygon comb = Comb(2500);
  const Circle inComb = LargestInscribedCircle(comb);
  EXPECT_NEAR(BruteDistanceInside(comb, inComb.Center), inComb.Radius, 1e-9);
  // A circle below a tooth touches the floor and both corners: r = 1 - r + s, s << 1.
  EXPECT_GT(inComb.Radius, 0.5);
  EXPECT_LT(inComb.Radius, 0.502);
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonKernel.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pemesh;
using namespace pemesh::test;

TEST(PolygonKernel, OfAConvexPolygonIsThePolygon)
{
  for (int size = 3; size < 30; ++size)
  {
    const Polygon polygon = RegularPolygon(size);
    EXPECT_EQ(PolygonKernel(polygon), polygon);
  }
  const Polygon straight = { { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_EQ(PolygonKernel(straight), straight);
}

TEST(PolygonKernel, KnownShapes)
{
  const Polygon lShape = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  EXPECT_NEAR(SignedArea(PolygonKernel(lShape)), 1.0, 1e-15);
  const Polygon uShape = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 },
    { 0, 3 } };
  EXPECT_EQ(SignedArea(PolygonKernel(uShape)), 0.0);
  // KAR of the specification.
  const Polygon dart = ConvexityFamily(0.7);
  EXPECT_NEAR(SignedArea(PolygonKernel(dart)) / SignedArea(dart), 3.0 / 7.0, 1e-15);
  // The kernel of a star is the regular polygon cut out by its sides.
  for (const int spikes : { 5, 8, 20 })
  {
    const Polygon star = StarFamily(spikes);
    EXPECT_NEAR(SignedArea(PolygonKernel(star)), ExactKernelArea(star), 1e-14);
  }
}

TEST(PolygonKernel, AgreesWithRationalNumbers)
{
  int empty = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 4, 30);
    const double expected = ExactKernelArea(polygon);
    empty += expected == 0.0 ? 1 : 0;
    EXPECT_NEAR(SignedArea(PolygonKernel(polygon)), expected, 1e-14) << seed;
  }
  EXPECT_GT(empty, 40);
  EXPECT_LT(empty, 300);
}

TEST(PolygonKernel, HardPolygons)
{
  for (const NamedPolygon& hard : HardPolygons())
  {
    const double expected = ExactKernelArea(hard.Vertices);
    EXPECT_NEAR(SignedArea(PolygonKernel(hard.Vertices)), expected, 1e-14) << hard.Name;
  }
  // A short edge decides the line it lies on: its direction must not suffer from the rest.
  const Polygon hooked = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.5 + 1e-13, 0.7 }, { 0.5, 0.7 - 1e-13 },
    { 0, 1 } };
  EXPECT_NEAR(SignedArea(PolygonKernel(hooked)), ExactKernelArea(hooked), 1e-13);
}

namespace
{

/** With 2^times as many vertices: midpoints, which are exact for coordinates of few bits. */
Polygon Subdivided(Polygon polygon, int times)
{
  for (; times > 0; --times)
  {
    Polygon finer;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2& a = polygon[i];
      const Point2& b = polygon[(i + 1) % polygon.size()];
      finer.push_back(a);
      finer.push_back({ 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) });
    }
    polygon = finer;
  }
  return polygon;
}

/** A square with four arms, each of which is seen whole from one side of a line `gap` off zero. */
Polygon Pinwheel(double gap)
{
  return { { 1, -1 }, { 2, -1 }, { 2, gap }, { 1, gap }, { 1, 1 }, { 1, 2 }, { -gap, 2 },
    { -gap, 1 }, { -1, 1 }, { -2, 1 }, { -2, -gap }, { -1, -gap }, { -1, -1 }, { -1, -2 },
    { gap, -2 }, { gap, -1 } };
}

void ExpectExact(const Polygon& polygon, const char* name, std::uint64_t number)
{
  const double expected = ExactKernelArea(polygon);
  for (std::size_t shift = 0; shift < polygon.size(); shift += polygon.size() / 3)
  {
    Polygon shifted = polygon;
    std::rotate(
      shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shift), shifted.end());
    const Polygon kernel = PolygonKernel(shifted);
    EXPECT_NEAR(SignedArea(kernel), expected, 1e-13) << name << ' ' << number;
    if (polygon.size() > PolygonKernelFinder::FewVertices)
    {
      EXPECT_EQ(kernel.size() >= 3, expected > 0.0) << name << ' ' << number; // decided exactly
    }
  }
}

} // namespace

TEST(PolygonKernel, ManyVerticesAgreeWithRationalNumbers)
{
  int empty = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    Random random(seed + 5);
    const int size = random.Integer(49, 150);
    ExpectExact(StarShaped(random, size, random.Uniform(0.0, 0.6)), "star-shaped", seed);
    const Polygon untangled = Untangled(random, 60);
    empty += ExactKernelArea(untangled) == 0.0 ? 1 : 0;
    ExpectExact(untangled, "untangled", seed);
  }
  EXPECT_GT(empty, 10);
  for (const int spikes : { 25, 30, 64, 100 }) // every line meets others in one point, many times
  {
    ExpectExact(StarFamily(spikes), "star", static_cast<std::uint64_t>(spikes));
  }
}

TEST(PolygonKernel, APointOrASegmentIsNone)
{
  const Polygon z = { { -1, -1 }, { 2, -1 }, { 2, 0 }, { 1, 0 }, { 1, 1 }, { -2, 1 }, { -2, 0 },
    { -1, 0 } };
  for (const int times : { 0, 3, 5 }) // by clipping, and in linear time
  {
    const Polygon segment = PolygonKernel(Subdivided(z, times));
    const Polygon point = PolygonKernel(Subdivided(Pinwheel(0.0), times));
    EXPECT_EQ(SignedArea(segment), 0.0) << times;
    EXPECT_EQ(SignedArea(point), 0.0) << times;
    if (times > 0)
    {
      EXPECT_TRUE(segment.empty()) << times;
      EXPECT_TRUE(point.empty()) << times;
    }
    const double gap = 0x1p-30;
    EXPECT_NEAR(
      SignedArea(PolygonKernel(Subdivided(Pinwheel(gap), times))) / (4.0 * gap * gap), 1.0, 1e-6);
    EXPECT_EQ(SignedArea(PolygonKernel(Subdivided(Pinwheel(-gap), times))), 0.0);
  }
}

/** Turned by some angle, what should be no more than a point has a tiny area, or none. */
TEST(PolygonKernel, WhetherThereIsOneIsExactForFewVertices)
{
  const Polygon upright = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 3 }, { 1, 3 }, { 1, 2 },
    { 0, 2 } };
  PolygonKernelFinder finder;
  int empty = 0;
  constexpr int Trials = 2000;
  for (int i = 0; i < Trials; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / Trials;
    Polygon polygon;
    for (const Point2& point : upright)
    {
      polygon.push_back({ std::cos(angle) * point.x - std::sin(angle) * point.y,
        std::sin(angle) * point.x + std::cos(angle) * point.y });
    }
    const bool isEmpty = ExactKernelArea(polygon) == 0.0;
    EXPECT_EQ(finder.Find(polygon).empty(), isEmpty) << i;
    empty += isEmpty ? 1 : 0;
    // Straight vertices change nothing.
    Polygon fine;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      fine.insert(fine.end(), PolygonKernelFinder::FewVertices, polygon[k]);
    }
    EXPECT_EQ(finder.Find(fine).empty(), isEmpty) << i;
  }
  EXPECT_GT(empty, Trials / 10);
  EXPECT_LT(empty, Trials - Trials / 10);
}

TEST(PolygonKernel, CombsAndSpirals)
{
  Polygon comb = { { 0, 0 }, { 40, 0 } }; // teeth between walls: nothing sees two of them whole
  for (int tooth = 40; tooth > 0; tooth -= 2)
  {
    comb.insert(comb.end(),
      { { tooth + 0.0, 5 }, { tooth - 0.75, 5 }, { tooth - 1.0, 1 }, { tooth - 1.25, 1 } });
  }
  comb.push_back({ 0, 5 });
  ExpectExact(comb, "comb", comb.size());
  Polygon saw = { { 0, -80 }, { 40, -80 } }; // seen whole from below
  for (int tooth = 40; tooth > 0; --tooth)
  {
    saw.insert(saw.end(), { { tooth + 0.0, 0 }, { tooth - 0.5, 1 } });
  }
  saw.push_back({ 0, 0 });
  EXPECT_GT(ExactKernelArea(saw), 0.0);
  const Polygon smallSaw = Transformed(saw, 0.3, 0x1p-7, {});
  ExpectExact(smallSaw, "saw", saw.size());
  for (const double turns : { 0.4, 0.9, 1.6, 5.0 })
  {
    Polygon spiral;
    constexpr int Steps = 80;
    for (int i = 0; i <= Steps; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * turns * i / Steps;
      const double radius = 0.1 + 0.8 * i / Steps;
      spiral.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    for (int i = Steps; i >= 0; --i)
    {
      const double angle = 2.0 * std::numbers::pi * turns * i / Steps;
      const double radius = 0.05 + 0.8 * i / Steps;
      spiral.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    std::reverse(spiral.begin(), spiral.end());
    if (PolygonOrientation(spiral) < 0)
    {
      std::reverse(spiral.begin(), spiral.end());
    }
    ExpectExact(spiral, "spiral", static_cast<std::uint64_t>(10 * turns));
  }
}

TEST(PolygonKernel, WhatIsNoSimplePolygonEnds)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed);
    Polygon tangle(100);
    for (Point2& point : tangle)
    {
      point = { random.Integer(0, 8) + 0.0, random.Integer(0, 8) + 0.0 };
    }
    EXPECT_LT(PolygonKernel(tangle).size(), 200U) << seed;
  }
}

TEST(PolygonKernel, TenThousandVertices)
{
  EXPECT_EQ(PolygonKernel(RegularPolygon(10000)).size(), 10000U);
  Polygon dented = RegularPolygon(10000);
  dented[0] = { 0.5, 0.0 };
  // Half planes of the two edges of the dent: a wedge from there to the other side.
  const double area = SignedArea(PolygonKernel(dented));
  EXPECT_GT(area, 0.0);
  EXPECT_LT(area, 0.1);
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random polygons: simple for every seed, setting and deformation, the same for the same seed, and
 * as wild as they are asked to be.
 */
#include "RandomPolygon.h"

#include "MeshInvariants.h"
#include "PolygonKernel.h"
#include "PolygonMeasures.h"
#include "PolygonPlacement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace
{

using pemesh::MakeRandomPolygon;
using pemesh::Point2;
using pemesh::RandomPolygonOptions;
using Polygon = std::vector<Point2>;

RandomPolygonOptions Options(
  int vertices, double irregularity, double spikiness, double tangle, std::uint64_t seed)
{
  return { vertices, irregularity, spikiness, tangle, seed };
}

/** Whether the middle sees every edge from its left, in exact arithmetic on the given doubles. */
bool IsSeenFromMiddle(const Polygon& polygon)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& next = polygon[(i + 1) % polygon.size()];
    if (!IsSimpleAndCounterClockwise({ { 0.0, 0.0 }, polygon[i], next }))
    {
      return false;
    }
  }
  return true;
}

double KernelArea(const Polygon& polygon)
{
  const Polygon kernel = pemesh::PolygonKernel(polygon);
  return kernel.size() < 3 ? 0.0 : SignedArea(kernel);
}

double Largest(const Polygon& a, const Polygon& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::hypot(a[i].x - b[i].x, a[i].y - b[i].y));
  }
  return largest;
}

} // namespace

TEST(RandomPolygon, BeginsAsTheRegularPolygon)
{
  for (const int n : { 3, 4, 7, 16, 100, 10000 })
  {
    const Polygon polygon = MakeRandomPolygon(Options(n, 1.0, 1.0, 1.0, 5), 0.0);
    ASSERT_EQ(polygon.size(), static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
    {
      const double angle = std::numbers::pi * (0.5 + 2.0 * i / n);
      EXPECT_NEAR(polygon[i].x, std::cos(angle), 1e-11);
      EXPECT_NEAR(polygon[i].y, std::sin(angle), 1e-11);
    }
  }
}

TEST(RandomPolygon, SimpleForThousandsOfSeedsAndAllDeformations)
{
  const int sizes[] = { 3, 4, 5, 6, 8, 11, 16, 23, 40 };
  const double settings[] = { 0.0, 0.3, 1.0 };
  for (std::uint64_t seed = 0; seed < 3000; ++seed)
  {
    const RandomPolygonOptions options = Options(sizes[seed % 9], settings[seed / 9 % 3],
      settings[seed / 27 % 3], settings[seed / 81 % 3], seed);
    const double t = seed % 4 == 0 ? 1.0 : static_cast<double>(seed * 37 % 1000) / 1000.0;
    const Polygon polygon = MakeRandomPolygon(options, t);
    ASSERT_EQ(polygon.size(), static_cast<std::size_t>(options.Vertices));
    ASSERT_TRUE(IsSimpleAndCounterClockwise(polygon)) << "seed " << seed << " t " << t;
    ASSERT_TRUE(IsSimpleAndCounterClockwise(
      pemesh::PlacePolygon(polygon, { 0.3, 0.7 }, 0.1, static_cast<double>(seed))))
      << "seed " << seed << " t " << t;
    for (const Point2& point : polygon)
    {
      ASSERT_LE(std::hypot(point.x, point.y), 1.0 + 1e-15);
    }
  }
}

TEST(RandomPolygon, LargeOnesAreSimpleToo)
{
  for (const double t : { 0.5, 0.77, 1.0 })
  {
    EXPECT_TRUE(IsSimpleAndCounterClockwise(MakeRandomPolygon(Options(1000, 1.0, 1.0, 1.0, 1), t)));
  }
  EXPECT_TRUE(
    IsSimpleAndCounterClockwise(MakeRandomPolygon(Options(10000, 1.0, 1.0, 0.1, 1), 1.0)));
}

TEST(RandomPolygon, StarShapedWithoutTangleAndSeldomWithIt)
{
  int starShaped = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const int n = 3 + static_cast<int>(seed % 40);
    EXPECT_TRUE(IsSeenFromMiddle(MakeRandomPolygon(Options(n, 1.0, 1.0, 0.0, seed), 1.0)));
    starShaped += KernelArea(MakeRandomPolygon(Options(12, 0.5, 0.5, 1.0, seed), 1.0)) > 0.0;
  }
  EXPECT_LT(starShaped, 40);
}

TEST(RandomPolygon, OptionsMeanWhatTheySay)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const Polygon onCircle = MakeRandomPolygon(Options(20, 1.0, 0.0, 0.0, seed), 1.0);
    const Polygon onRays = MakeRandomPolygon(Options(20, 0.0, 1.0, 0.0, seed), 1.0);
    double nearest = 1.0;
    double widest = 0.0;
    for (std::size_t i = 0; i < 20; ++i)
    {
      EXPECT_NEAR(std::hypot(onCircle[i].x, onCircle[i].y), 1.0, 1e-14);
      const Point2& next = onCircle[(i + 1) % 20];
      widest = std::max(widest, std::hypot(onCircle[i].x - next.x, onCircle[i].y - next.y));
      const double radius = std::hypot(onRays[i].x, onRays[i].y);
      EXPECT_GE(radius, 0.1 - 1e-14);
      nearest = std::min(nearest, radius);
      const double angle = std::numbers::pi * (0.5 + 0.1 * static_cast<double>(i));
      EXPECT_NEAR(onRays[i].x, radius * std::cos(angle), 1e-14);
      EXPECT_NEAR(onRays[i].y, radius * std::sin(angle), 1e-14);
    }
    EXPECT_LT(nearest, 0.5);
    EXPECT_GT(widest, 1.3 * 2.0 * std::sin(std::numbers::pi / 20.0));
  }
}

TEST(RandomPolygon, TheSameForTheSameSeedOnly)
{
  std::set<std::pair<double, double>> firsts;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    const RandomPolygonOptions options = Options(15, 0.5, 0.5, 0.5, seed);
    const Polygon polygon = MakeRandomPolygon(options, 0.9);
    EXPECT_EQ(polygon, MakeRandomPolygon(options, 0.9));
    firsts.insert({ polygon[3].x, polygon[3].y });
  }
  EXPECT_EQ(firsts.size(), 100u);
  // Bits that any other platform must give: mt19937_64 and IEEE arithmetic leave no choice.
  const Polygon known = MakeRandomPolygon(Options(8, 0.5, 0.5, 1.0, 2026), 1.0);
  EXPECT_EQ(known[2].x, -0.74769746710093676);
  EXPECT_EQ(known[5].y, -0.96691762482008914);
}

TEST(RandomPolygon, DeformsWithoutJumps)
{
  for (const double tangle : { 0.0, 1.0 })
  {
    const RandomPolygonOptions options = Options(10, 0.7, 0.7, tangle, 4);
    Polygon last = MakeRandomPolygon(options, 0.0);
    double longest = 0.0;
    for (int i = 1; i <= 20000; ++i)
    {
      Polygon next = MakeRandomPolygon(options, i / 20000.0);
      longest = std::max(longest, Largest(last, next));
      last = std::move(next);
    }
    // Half of the time is the walk: 80 ways, each up to sqrt(2) long, in 10000 steps.
    EXPECT_LT(longest, tangle == 0.0 ? 1e-3 : std::sqrt(2.0) * 80.0 / 10000.0 + 1e-9);
    EXPECT_GT(longest, 0.0);
  }
}

TEST(RandomPolygon, EdgesKeepTheirDistance)
{
  // Of the last part of the way only: the start is as near as spikes are.
  const int n = 12;
  const double clearance = 0.05 * 2.0 * std::numbers::pi / n;
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const Polygon polygon = MakeRandomPolygon(Options(n, 0.0, 0.0, 1.0, seed), 1.0);
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      for (std::size_t j = i + 1; j < polygon.size(); ++j)
      {
        EXPECT_GE(std::hypot(polygon[i].x - polygon[j].x, polygon[i].y - polygon[j].y),
          clearance * (1.0 - 1e-12));
      }
    }
  }
}

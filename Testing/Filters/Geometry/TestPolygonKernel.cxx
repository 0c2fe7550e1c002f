// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonKernel.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

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

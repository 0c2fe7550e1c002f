// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonMeasures.h"

#include "BruteForce.h"
#include "PolygonSamples.h"

#include <gtest/gtest.h>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

constexpr double Pi = std::numbers::pi;

long double LongAngle(const Point2& previous, const Point2& vertex, const Point2& next)
{
  const long double ax = static_cast<long double>(next.x) - vertex.x;
  const long double ay = static_cast<long double>(next.y) - vertex.y;
  const long double bx = static_cast<long double>(previous.x) - vertex.x;
  const long double by = static_cast<long double>(previous.y) - vertex.y;
  const long double angle = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  return angle < 0 ? angle + 2 * std::numbers::pi_v<long double> : angle;
}

} // namespace

TEST(PolygonMeasures, KnownShapes)
{
  const Polygon square = UnitSquare();
  EXPECT_EQ(SignedArea(square), 1.0);
  EXPECT_EQ(Perimeter(square), 4.0);
  EXPECT_EQ(Centroid(square), (Point2{ 0.5, 0.5 }));
  EXPECT_EQ(PolygonOrientation(square), 1);
  // Pentagon of the literature's unit test for stiffness matrices.
  const Polygon pentagon = { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 1.5, 4 }, { 0, 4 } };
  EXPECT_NEAR(SignedArea(pentagon), 21.0 / 2.0, 1e-15);
  EXPECT_NEAR(Centroid(pentagon).x, 19.0 / 14.0, 1e-15);
  EXPECT_NEAR(Centroid(pentagon).y, 38.0 / 21.0, 1e-15);
  EXPECT_EQ(MeasureEdges(pentagon).Shortest, 1.5);
  EXPECT_EQ(MeasureEdges(pentagon).Longest, 4.0);
}

TEST(PolygonMeasures, AreaAgreesWithRationalNumbers)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    const Polygon polygon = Transformed(
      RandomPolygon(seed, 3, 60), static_cast<double>(seed), std::pow(10.0, seed % 19 - 9.0), {});
    const double exact = ExactArea(polygon);
    EXPECT_NEAR(SignedArea(polygon), exact, 1e-12 * exact) << seed;
  }
  for (const NamedPolygon& hard : HardPolygons())
  {
    for (const Point2& offset : { Point2{}, Point2{ 1e3, -1e3 } })
    {
      const Polygon moved = Transformed(hard.Vertices, 0.0, 1.0, offset);
      const double exact = ExactArea(moved);
      EXPECT_NEAR(SignedArea(moved), exact, 1e-13 * std::abs(exact)) << hard.Name;
    }
  }
}

TEST(PolygonMeasures, AThinPolygonTurnedHasItsAreaToTheLastDigits)
{
  const Polygon needle =
    Transformed({ { 0, 0 }, { 1, 0 }, { 1, 1e-12 }, { 0, 1e-12 } }, 0.7, 1.0, { 0.1, 0.2 });
  const double exact = ExactArea(needle);
  EXPECT_NEAR(SignedArea(needle), exact, 1e-14 * std::abs(exact));
}

TEST(PolygonMeasures, OrientationIsThatOfTheExactArea)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Polygon polygon = RandomPolygon(seed, 3, 30);
    EXPECT_EQ(PolygonOrientation(polygon), 1);
    std::reverse(polygon.begin(), polygon.end());
    EXPECT_EQ(PolygonOrientation(polygon), -1);
  }
  EXPECT_EQ(PolygonOrientation(Polygon{ { 0, 0 }, { 1, 1 }, { 2, 2 } }), 0);
  // A vertex one unit in the last place to the left of the line.
  EXPECT_EQ(PolygonOrientation(Polygon{ { 0, 0 }, { 1, 1 }, { 0.5, std::nextafter(0.5, 1) } }), 1);
}

TEST(PolygonMeasures, AnglesAddUpAndAgreeWithExtendedPrecision)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 3, 30);
    const std::vector<double> angles = InteriorAngles(polygon);
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const std::size_t size = polygon.size();
      sum += angles[i];
      EXPECT_NEAR(angles[i],
        static_cast<double>(
          LongAngle(polygon[(i + size - 1) % size], polygon[i], polygon[(i + 1) % size])),
        1e-14);
    }
    EXPECT_NEAR(sum, (static_cast<double>(polygon.size()) - 2.0) * Pi, 1e-11) << seed;
    const AngleRange range = MeasureAngles(polygon);
    EXPECT_NEAR(range.Smallest, *std::min_element(angles.begin(), angles.end()), 1e-15);
    EXPECT_NEAR(range.Largest, *std::max_element(angles.begin(), angles.end()), 1e-15);
  }
}

TEST(PolygonMeasures, ReflexStraightAndNeedleAngles)
{
  EXPECT_EQ(MeasureAngles(UnitSquare()).Largest, Pi / 2);
  const Polygon lShape = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  EXPECT_EQ(MeasureAngles(lShape).Largest, 1.5 * Pi);
  EXPECT_EQ(InteriorAngles(Polygon{ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } })[1], Pi);
  // The tip of a spike into the polygon, 1e-16 wide and turned: almost 2 pi, never almost 0.
  const Polygon spike = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 1.6 + 2e-16, 3 }, { 1.1, 1.3 },
    { 1.6, 3 }, { 0, 3 } };
  EXPECT_NEAR(InteriorAngles(spike)[4], 2.0 * Pi, 1e-14);
  EXPECT_LE(InteriorAngles(spike)[4], 2.0 * Pi);
}

TEST(PolygonMeasures, ConvexityIsExact)
{
  EXPECT_TRUE(IsConvex(UnitSquare()));
  EXPECT_TRUE(IsConvex(Polygon{ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } }));
  Polygon dented = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 3 } };
  EXPECT_TRUE(IsConvex(dented));
  dented[1].y = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(IsConvex(dented));
  const Polygon pentagram = { { 1, 0 }, { -0.809, 0.588 }, { 0.309, -0.951 }, { 0.309, 0.951 },
    { -0.809, -0.588 } };
  EXPECT_FALSE(IsConvex(pentagram)); // turns left everywhere, but goes round twice
  for (int size = 3; size < 100; ++size)
  {
    EXPECT_TRUE(IsConvex(RegularPolygon(size))) << size;
  }
}

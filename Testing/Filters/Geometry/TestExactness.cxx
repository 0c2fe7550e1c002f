// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Every kernel against brute force on random polygons: to 1e-9 of its natural scale, and to 1e-9 of
 * itself where it exceeds 1e-4 of that. A few hundred polygons every time, 10,000 with
 * `ctest --preset nightly`.
 */
#include "PolygonCrossings.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include "KernelQuantities.h"
#include "RandomSamples.h"

#include <gtest/gtest.h>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

class Exactness : public testing::TestWithParam<int>
{
protected:
  static constexpr int PartSize = PEMESH_EXACTNESS_PART;
  int First() const { return this->GetParam() * PartSize; }
  int Last() const { return this->First() + PartSize; }
};

std::vector<double> MeasureAll(PolygonView polygon)
{
  std::vector<double> values;
  for (const Quantity& quantity : Quantities)
  {
    values.push_back(quantity.Kernel(polygon));
  }
  return values;
}

/** That the kernels of an image are those of the polygon, times the factor of lengths. */
void ExpectSame(const std::vector<double>& expected, const Polygon& image, double factor,
  double diameter, const std::string& name)
{
  const std::vector<double> values = MeasureAll(image);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const int power = Quantities[i].Power;
    EXPECT_NEAR(
      values[i] / std::pow(factor, power), expected[i], Allowed(expected[i], power, diameter))
      << Quantities[i].Name << " of " << name;
  }
}

} // namespace

TEST_P(Exactness, KernelsAgreeWithBruteForce)
{
  int tested = 0;
  for (int number = this->First(); number < this->Last(); ++number)
  {
    const Sample sample = MakeSample(number);
    if (!IsSimple(sample.Vertices))
    {
      continue; // straight vertices as rounded can cross in a sharp corner
    }
    ++tested;
    const double diameter = Diameter(sample.Vertices);
    for (const Quantity& quantity : Quantities)
    {
      const double expected = quantity.Expected(sample.Vertices);
      EXPECT_NEAR(
        quantity.Kernel(sample.Vertices), expected, Allowed(expected, quantity.Power, diameter))
        << quantity.Name << " of " << sample.Name;
    }
    EXPECT_EQ(IsConvex(sample.Vertices), BruteMeasure(sample.Vertices).Convex) << sample.Name;
    EXPECT_EQ(PolygonOrientation(sample.Vertices), 1) << sample.Name;
    EXPECT_FALSE(HasCrossingEdges(sample.Vertices)) << sample.Name;
  }
  EXPECT_GE(tested, PartSize * 9 / 10);
}

TEST_P(Exactness, KernelsAreInvariant)
{
  for (int number = this->First(); number < this->Last(); ++number)
  {
    const Sample sample = MakeSample(number);
    const Polygon& polygon = sample.Vertices;
    const double diameter = Diameter(polygon);
    // What the image is rounded by must not be what is measured.
    if (!IsSimple(polygon) || ClosestPair(polygon).Distance < 1e-3 * diameter)
    {
      continue;
    }
    const std::vector<double> expected = MeasureAll(polygon);
    const Point2 home = { -polygon[0].x, -polygon[0].y };
    const Polygon atHome = Transformed(polygon, 0.0, 1.0, home);
    const auto Expect = [&](const Polygon& image, double factor, const char* what)
    {
      if (IsSimple(image))
      {
        ExpectSame(expected, image, factor, diameter, sample.Name + what);
      }
    };
    Expect(atHome, 1.0, " moved to the origin");
    Expect(Transformed(atHome, 0.0, 1.0, { 3.0 * diameter, diameter }), 1.0, " moved");
    Expect(Transformed(atHome, 0.4 + number, 1.0, {}), 1.0, " rotated");
    for (const double factor : { 1e-9, 0.3, 1e9 })
    {
      Expect(Transformed(atHome, 0.0, factor, {}), factor, " scaled");
    }
    Polygon shifted = polygon;
    std::rotate(shifted.begin(), shifted.begin() + 1 + number % 2, shifted.end());
    Expect(shifted, 1.0, " from another vertex on");
    Polygon mirrored(atHome.rbegin(), atHome.rend());
    EXPECT_EQ(PolygonOrientation(mirrored), -1) << sample.Name;
    EXPECT_NEAR(SignedArea(mirrored), -expected[0], 1e-9 * expected[0]) << sample.Name;
    for (Point2& point : mirrored)
    {
      point.x = -point.x;
    }
    Expect(mirrored, 1.0, " in a mirror, reversed");
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Exactness,
  testing::Range(0, PEMESH_EXACTNESS_POLYGONS / PEMESH_EXACTNESS_PART),
  [](const testing::TestParamInfo<int>& part) { return "Part" + std::to_string(part.param); });

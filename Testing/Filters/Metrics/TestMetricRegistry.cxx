// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementGeometry.h"
#include "MetricRegistry.h"

#include "../Geometry/BruteForce.h"
#include "../Geometry/PolygonSamples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <ranges>
#include <set>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

constexpr double Pi = std::numbers::pi;

bool IsOfElement(const Metric& metric)
{
  return metric.Function != nullptr;
}

/** The metrics that need nothing but the element. */
std::map<std::string, double> Measure(const Polygon& polygon)
{
  ElementGeometry element;
  std::map<std::string, double> values;
  EXPECT_TRUE(element.SetVertices(polygon));
  for (const Metric& metric : Metrics() | std::views::filter(IsOfElement))
  {
    values[metric.Name] = metric.Function(element);
  }
  return values;
}

/** What a metric is to be compared with: 1, the diameter or its square. */
double NaturalScale(const Metric& metric, double diameter)
{
  const std::string unit = metric.Unit;
  return unit == "length" ? diameter : (unit == "length^2" ? diameter * diameter : 1.0);
}

void ExpectSame(const Polygon& polygon, const std::map<std::string, double>& expected, double scale,
  double tolerance, const std::string& what, bool turned = false)
{
  const std::map<std::string, double> values = Measure(polygon);
  for (const Metric& metric : Metrics() | std::views::filter(IsOfElement))
  {
    if (turned && !metric.RotationInvariant)
    {
      continue;
    }
    const double factor = NaturalScale(metric, scale);
    const double value = expected.at(metric.Name);
    EXPECT_NEAR(values.at(metric.Name) / factor, value, tolerance * std::max(1.0, std::abs(value)))
      << metric.Name << ' ' << what;
  }
}

/** A bound as the registry writes it. */
double ParseBound(const std::string& text)
{
  static const std::map<std::string, double> words = { { "inf",
                                                         std::numeric_limits<double>::infinity() },
    { "pi", Pi }, { "2 pi", 2.0 * Pi }, { "pi/3", Pi / 3.0 }, { "1/2", 0.5 }, { "5/6", 5.0 / 6.0 },
    { "sqrt(3)/2", std::sqrt(0.75) }, { "2/sqrt(pi)", 2.0 / std::sqrt(Pi) } };
  const auto word = words.find(text);
  return word != words.end() ? word->second : std::stod(text);
}

/** The range of a metric, its ends included. */
std::pair<double, double> ParseRange(const Metric& metric)
{
  const std::string range = metric.Range;
  const std::size_t comma = range.find(", ");
  EXPECT_NE(comma, std::string::npos) << metric.Name;
  return { ParseBound(range.substr(1, comma - 1)),
    ParseBound(range.substr(comma + 2, range.size() - comma - 3)) };
}

} // namespace

TEST(MetricRegistry, HasAllMetricsInOrderAndComplete)
{
  const std::vector<std::string> names = { "NumberOfEdges", "InscribedRadius",
    "CircumscribedRadius", "CircleRatio", "Area", "KernelArea", "KernelAreaRatio",
    "AreaPerimeterRatio", "MinAngle", "MaxAngle", "AngleRatio", "ShortestEdge", "EdgeRatio",
    "MinPointDistance", "NormalizedPointDistance", "ShapeRegularity", "Diameter", "InradiusRatio",
    "OutradiusRatio", "MinAngleFraction", "MaxAngleFraction", "ScaledJacobian", "FrobeniusRatio",
    "VEMRho1", "VEMRho2", "VEMRho3", "VEMRho4", "VEMIndicator", "VEMRatio", "MinSideRadiusRatio",
    "UniformityFactor", "BoxRatio" };
  EXPECT_EQ(MetricNames(), names);
  std::set<std::string> labels;
  for (const Metric& metric : Metrics())
  {
    for (const char* text : { metric.Name, metric.Symbol, metric.Label, metric.Formula, metric.Tex,
           metric.Description, metric.Range, metric.Unit, metric.Reference })
    {
      ASSERT_TRUE(text) << metric.Name;
      EXPECT_FALSE(std::string(text).empty()) << metric.Name;
    }
    EXPECT_TRUE(labels.insert(metric.Label).second);
    EXPECT_TRUE(labels.insert(metric.Symbol).second);
    const std::pair<double, double> range = ParseRange(metric);
    EXPECT_LT(range.first, range.second) << metric.Name;
    EXPECT_NE(metric.Function == nullptr, metric.InMesh == nullptr) << metric.Name;
    EXPECT_EQ(metric.InMesh != nullptr, (metric.Needs & (NeedsMesh | NeedsNeighbours)) != 0)
      << metric.Name;
    EXPECT_EQ(FindElementMetric(metric.Name), metric.Function ? &metric : nullptr);
    if (!std::string(metric.Base).empty())
    {
      EXPECT_TRUE(FindElementMetric(metric.Base)) << metric.Name;
    }
    EXPECT_TRUE(metric.Good >= -1 && metric.Good <= 1);
    EXPECT_EQ(FindMetric(metric.Name), &metric);
    const std::string unit = metric.Unit;
    EXPECT_EQ(metric.ScaleInvariant, unit == "1" || unit == "rad") << metric.Name;
    EXPECT_TRUE(metric.ScaleInvariant || unit == "length" || unit == "length^2") << metric.Name;
  }
  EXPECT_EQ(FindMetric("area"), nullptr);
  EXPECT_EQ(FindMetric(""), nullptr);
  EXPECT_EQ(FindMetric("KernelRadiusRatio"), FindMetric("ShapeRegularity")) << "an alias";
  EXPECT_NE(DescribeUnknownMetric("KernalArea").find("\"KernelArea\""), std::string::npos);
  EXPECT_NE(DescribeUnknownMetric("KAR").find("\"KernelAreaRatio\""), std::string::npos);
}

TEST(MetricRegistry, KernelsAreComputedOnlyWhenNeeded)
{
  const std::vector<Polygon> elements = { RegularPolygon(3), UnitSquare(), ConvexityFamily(0.7) };
  for (const Polygon& polygon : elements)
  {
    for (const Metric& metric : Metrics() | std::views::filter(IsOfElement))
    {
      ElementGeometry element;
      ASSERT_TRUE(element.SetVertices(polygon));
      metric.Function(element);
      if (&polygon == &elements.back())
      {
        // A circle starts from the diameter, and what is straight is measured by it; other than
        // that nothing is borrowed.
        const unsigned int distances =
          (metric.Needs & (NeedsEnclosingCircle | NeedsSides)) != 0 ? NeedsDistances : NeedsNothing;
        EXPECT_EQ(element.GetComputed() & ~distances,
          (metric.Needs | (metric.Needs & NeedsKernelArea ? NeedsArea : NeedsNothing)) & ~distances)
          << metric.Name;
      }
    }
    ElementGeometry element;
    ASSERT_TRUE(element.SetVertices(polygon));
    FindMetric("Area")->Function(element);
    EXPECT_EQ(element.GetComputed(), NeedsArea);
  }
}

TEST(MetricRegistry, TrianglesAgreeWithTheGeneralKernels)
{
  Random random(11);
  for (int i = 0; i < 300; ++i)
  {
    Polygon triangle;
    for (int k = 0; k < 3; ++k)
    {
      triangle.push_back({ random.Uniform(), (i % 3 == 0 ? 1e-6 : 1.0) * random.Uniform() });
    }
    const std::map<std::string, double> v = Measure(triangle);
    if (PolygonOrientation(triangle) < 0)
    {
      std::reverse(triangle.begin(), triangle.end());
    }
    EXPECT_NEAR(v.at("CircumscribedRadius"), BruteEnclosingRadius(triangle), 1e-14);
    EXPECT_NEAR(v.at("InscribedRadius"), BruteKernelRadius(triangle), 1e-14);
    EXPECT_NEAR(v.at("Area"), ExactArea(triangle), 1e-15);
    EXPECT_EQ(v.at("KernelAreaRatio"), 1.0);
    const BruteMeasures brute = BruteMeasure(triangle);
    EXPECT_NEAR(v.at("MinAngle"), brute.SmallestAngle, 1e-13);
    EXPECT_NEAR(v.at("MaxAngle"), brute.LargestAngle, 1e-13);
    EXPECT_NEAR(v.at("Diameter"), brute.Diameter, 1e-15);
    EXPECT_NEAR(v.at("MinPointDistance"), brute.ClosestPair, 1e-15);
    EXPECT_NEAR(v.at("ShortestEdge"), brute.ClosestPair, 1e-15);
    EXPECT_NEAR(v.at("EdgeRatio"), brute.ClosestPair / brute.Diameter, 1e-15);
    EXPECT_NEAR(v.at("ScaledJacobian"), MeasureCorners(triangle).SmallestSine, 1e-13);
    EXPECT_NEAR(v.at("FrobeniusRatio"), MeasureCorners(triangle).SmallestFrobeniusRatio, 1e-13);
    // A straight vertex changes the element to a quadrilateral, but not its shape.
    Polygon split = triangle;
    split.push_back(
      { 0.5 * (triangle[0].x + triangle[2].x), 0.5 * (triangle[0].y + triangle[2].y) });
    const std::map<std::string, double> w = Measure(split);
    for (const char* name : { "InscribedRadius", "CircumscribedRadius", "Area", "KernelArea" })
    {
      EXPECT_NEAR(v.at(name), w.at(name), 1e-14) << name;
    }
  }
}

TEST(MetricRegistry, AgreesWithBruteForce)
{
  for (std::uint64_t seed = 0; seed < 150; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 3, 12);
    const std::map<std::string, double> v = Measure(polygon);
    const double area = ExactArea(polygon);
    const double enclosing = BruteEnclosingRadius(polygon);
    EXPECT_NEAR(v.at("Area"), area, 1e-14 * area) << seed;
    EXPECT_NEAR(v.at("CircumscribedRadius"), enclosing, 1e-14) << seed;
    EXPECT_NEAR(v.at("InscribedRadius"), BruteInscribedRadius(polygon), 1e-11) << seed;
    EXPECT_NEAR(v.at("KernelArea"), ExactKernelArea(polygon), 1e-14) << seed;
    EXPECT_NEAR(v.at("ShapeRegularity"), BruteKernelRadius(polygon) / enclosing, 1e-13) << seed;
    EXPECT_NEAR(v.at("CircleRatio"), v.at("InscribedRadius") / enclosing, 1e-13) << seed;
  }
}

TEST(MetricRegistry, InvariantUnderMotionScaleShiftAndReversal)
{
  for (std::uint64_t seed = 0; seed < 80; ++seed)
  {
    Random random(seed);
    const Polygon polygon = RandomPolygon(seed, 4, 20);
    if (seed % 4 == 3)
    {
      continue; // vertices straight to rounding: kernels there are discontinuous
    }
    const std::map<std::string, double> values = Measure(polygon);
    const std::string name = "seed " + std::to_string(seed);
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      ExpectSame(Transformed(polygon, random.Uniform(0.0, 6.0), scale, {}), values, scale, 1e-11,
        name + " turned, scaled", true);
    }
    ExpectSame(Transformed(polygon, 0.0, 1.0, { 1e4, -1e4 }), values, 1.0, 1e-9, name + " far");
    Polygon shifted = polygon;
    std::rotate(shifted.begin(), shifted.begin() + random.Integer(1, 3), shifted.end());
    ExpectSame(shifted, values, 1.0, 1e-12, name + " shifted");
    std::reverse(shifted.begin(), shifted.end());
    ExpectSame(shifted, values, 1.0, 1e-12, name + " reversed");
    shifted.insert(shifted.begin() + 1, shifted[1]);
    ExpectSame(shifted, values, 1.0, 1e-12, name + " with a repeat");
  }
}

TEST(MetricRegistry, ValuesStayInTheirRangesOnHardPolygons)
{
  for (const NamedPolygon& hard : HardPolygons())
  {
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      const std::map<std::string, double> v =
        Measure(Transformed(hard.Vertices, 0.0, scale, { 0.1 * scale, 0.0 }));
      for (const auto& [name, value] : v)
      {
        const auto [low, high] = ParseRange(*FindMetric(name));
        EXPECT_TRUE(std::isfinite(value)) << hard.Name << ' ' << name;
        EXPECT_GE(value, low * (1.0 - 1e-14)) << hard.Name << ' ' << name;
        EXPECT_LE(value, high) << hard.Name << ' ' << name;
      }
      EXPECT_LE(v.at("MinPointDistance"), v.at("ShortestEdge")) << hard.Name;
      EXPECT_LE(v.at("ShapeRegularity"), v.at("CircleRatio") * (1.0 + 1e-12)) << hard.Name;
    }
  }
}

TEST(MetricRegistry, IndicatorsAreMadeOfOtherMetrics)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const std::map<std::string, double> v = Measure(RandomPolygon(seed, 3, 20));
    const double h = v.at("Diameter");
    EXPECT_NEAR(v.at("NormalizedPointDistance"), v.at("MinPointDistance") / h, 1e-15);
    EXPECT_NEAR(v.at("InradiusRatio"), 2.0 * v.at("InscribedRadius") / h, 1e-15);
    EXPECT_NEAR(v.at("OutradiusRatio"), h / (2.0 * v.at("CircumscribedRadius")), 1e-15);
    EXPECT_NEAR(v.at("MinAngleFraction"), v.at("MinAngle") / (2.0 * Pi), 1e-15);
    EXPECT_NEAR(v.at("MaxAngleFraction"), 1.0 - v.at("MaxAngle") / (2.0 * Pi), 1e-15);
    const double size = std::min(std::sqrt(v.at("Area")), v.at("ShortestEdge"));
    EXPECT_NEAR(v.at("VEMRho2"), size / h, 1e-15);
    EXPECT_NEAR(v.at("VEMRatio") * v.at("VEMRho2"), 1.0, 1e-14);
    EXPECT_EQ(v.at("VEMRho1"), v.at("KernelAreaRatio"));
    EXPECT_EQ(v.at("VEMRho3"), 3.0 / v.at("NumberOfEdges"));
    EXPECT_NEAR(3.0 * std::pow(v.at("VEMIndicator"), 2.0),
      v.at("VEMRho1") * (v.at("VEMRho2") + v.at("VEMRho3") + v.at("VEMRho4")), 1e-14);
    EXPECT_NEAR(v.at("MinSideRadiusRatio"), v.at("ShortestEdge") / v.at("InscribedRadius"), 1e-13);
  }
}

TEST(MetricRegistry, TheTestsOfMetricsExist)
{
  std::set<std::string> tests;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
  {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k)
    {
      tests.insert(
        "FiltersMetrics." + std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
    }
  }
  for (const Metric& metric : Metrics())
  {
    EXPECT_TRUE(tests.contains(MetricTest(metric))) << MetricTest(metric);
  }
}

TEST(ElementGeometry, WhatCannotBeMeasured)
{
  ElementGeometry element;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(element.SetVertices(Polygon{}));
  EXPECT_FALSE(element.SetVertices(Polygon{ { 0, 0 }, { 1, 0 }, { 0, 0 }, { 0, 0 } }));
  EXPECT_FALSE(element.SetVertices(Polygon{ { 0, 0 }, { 1, 1 }, { 2, 2 } }));
  EXPECT_FALSE(element.SetVertices(Polygon{ { 0, 0 }, { 1, nan }, { 0, 1 } }));
  EXPECT_FALSE(element.SetVertices(Polygon{ { 0, 0 }, { infinity, 0 }, { 0, 1 } }));
  EXPECT_FALSE(element.SetVertices(Polygon{ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_TRUE(element.SetVertices(UnitSquare()));
  EXPECT_FALSE(element.HasRepeatedVertices());
  EXPECT_TRUE(element.SetVertices(Polygon{ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } }));
  EXPECT_TRUE(element.HasRepeatedVertices());
  EXPECT_EQ(element.GetVertices().size(), 3U);
}

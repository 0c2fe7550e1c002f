// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementGeometry.h"
#include "MetricRegistry.h"

#include "../Geometry/BruteForce.h"
#include "../Geometry/PolygonSamples.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

constexpr double Pi = std::numbers::pi;

std::map<std::string, double> Measure(const Polygon& polygon)
{
  ElementGeometry element;
  std::map<std::string, double> values;
  EXPECT_TRUE(element.SetVertices(polygon));
  for (const Metric& metric : Metrics())
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
  double tolerance, const std::string& what)
{
  const std::map<std::string, double> values = Measure(polygon);
  for (const Metric& metric : Metrics())
  {
    const double factor = NaturalScale(metric, scale);
    EXPECT_NEAR(values.at(metric.Name) / factor, expected.at(metric.Name), tolerance)
      << metric.Name << ' ' << what;
  }
}

} // namespace

TEST(MetricRegistry, HasAllMetricsInOrderAndComplete)
{
  const std::vector<std::string> names = { "NumberOfEdges", "InscribedRadius",
    "CircumscribedRadius", "CircleRatio", "Area", "KernelArea", "KernelAreaRatio",
    "AreaPerimeterRatio", "MinAngle", "MaxAngle", "AngleRatio", "ShortestEdge", "EdgeRatio",
    "MinPointDistance", "NormalizedPointDistance", "ShapeRegularity" };
  EXPECT_EQ(MetricNames(), names);
  std::set<std::string> labels;
  for (const Metric& metric : Metrics())
  {
    for (const char* text : { metric.Name, metric.Symbol, metric.Label, metric.Formula,
           metric.Description, metric.Range, metric.Unit, metric.Reference })
    {
      ASSERT_TRUE(text) << metric.Name;
      EXPECT_FALSE(std::string(text).empty()) << metric.Name;
    }
    EXPECT_TRUE(labels.insert(metric.Label).second);
    EXPECT_TRUE(labels.insert(metric.Symbol).second);
    EXPECT_TRUE(metric.Good >= -1 && metric.Good <= 1);
    EXPECT_EQ(FindMetric(metric.Name), &metric);
    const std::string unit = metric.Unit;
    EXPECT_EQ(metric.ScaleInvariant, unit == "1" || unit == "rad") << metric.Name;
    EXPECT_TRUE(metric.ScaleInvariant || unit == "length" || unit == "length^2") << metric.Name;
  }
  EXPECT_EQ(FindMetric("area"), nullptr);
  EXPECT_NE(DescribeUnknownMetric("KernalArea").find("\"KernelArea\""), std::string::npos);
  EXPECT_NE(DescribeUnknownMetric("KAR").find("\"KernelAreaRatio\""), std::string::npos);
}

TEST(MetricRegistry, KernelsAreComputedOnlyWhenNeeded)
{
  const std::vector<Polygon> elements = { RegularPolygon(3), UnitSquare(), ConvexityFamily(0.7) };
  for (const Polygon& polygon : elements)
  {
    for (const Metric& metric : Metrics())
    {
      ElementGeometry element;
      ASSERT_TRUE(element.SetVertices(polygon));
      metric.Function(element);
      if (&polygon == &elements.back())
      {
        // A circle starts from the diameter; other than that nothing is borrowed.
        const unsigned int distances =
          (metric.Needs & NeedsEnclosingCircle) != 0 ? NeedsDistances : NeedsNothing;
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

TEST(MetricRegistry, UnitSquare)
{
  const std::map<std::string, double> v = Measure(UnitSquare());
  EXPECT_EQ(v.at("NumberOfEdges"), 4.0);
  EXPECT_NEAR(v.at("InscribedRadius"), 0.5, 1e-15);
  EXPECT_NEAR(v.at("CircumscribedRadius"), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(v.at("CircleRatio"), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(v.at("Area"), 1.0);
  EXPECT_EQ(v.at("KernelArea"), 1.0);
  EXPECT_EQ(v.at("KernelAreaRatio"), 1.0);
  EXPECT_NEAR(v.at("AreaPerimeterRatio"), Pi / 4.0, 1e-15);
  EXPECT_EQ(v.at("MinAngle"), Pi / 2.0);
  EXPECT_EQ(v.at("MaxAngle"), Pi / 2.0);
  EXPECT_EQ(v.at("AngleRatio"), 1.0);
  EXPECT_EQ(v.at("ShortestEdge"), 1.0);
  EXPECT_EQ(v.at("EdgeRatio"), 1.0);
  EXPECT_EQ(v.at("MinPointDistance"), 1.0);
  EXPECT_NEAR(v.at("NormalizedPointDistance"), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(v.at("ShapeRegularity"), std::sqrt(0.5), 1e-15);
}

TEST(MetricRegistry, EquilateralTriangleOfRadiusOne)
{
  const std::map<std::string, double> v = Measure(RegularPolygon(3));
  EXPECT_NEAR(v.at("InscribedRadius"), 0.5, 1e-15);
  EXPECT_NEAR(v.at("CircumscribedRadius"), 1.0, 1e-15);
  EXPECT_NEAR(v.at("AreaPerimeterRatio"), Pi * std::sqrt(3.0) / 9.0, 1e-15); // .60460
  EXPECT_NEAR(v.at("NormalizedPointDistance"), 1.0, 1e-15);
  EXPECT_NEAR(v.at("ShapeRegularity"), 0.5, 1e-15);
  EXPECT_NEAR(v.at("MaxAngle"), Pi / 3.0, 1e-15);
}

TEST(MetricRegistry, ConvexityFamilyOfTheSpecification)
{
  const std::map<std::string, double> v = Measure(ConvexityFamily(0.7));
  EXPECT_NEAR(v.at("ShapeRegularity"), 0.2408, 5e-5);
  EXPECT_NEAR(v.at("KernelAreaRatio"), 0.4286, 5e-5);
  EXPECT_NEAR(v.at("AngleRatio"), 0.1037, 5e-5);
  EXPECT_NEAR(2.0 * v.at("InscribedRadius") / std::sqrt(2.0), 0.2485, 5e-5);
  EXPECT_NEAR(v.at("Area"), 0.3, 1e-15);
}

TEST(MetricRegistry, TrianglesAgreeWithTheGeneralKernels)
{
  Random random(11);
  for (int i = 0; i < 300; ++i)
  {
    Polygon triangle;
    for (int k = 0; k < 3; ++k)
    {
      triangle.push_back({ random.Uniform(), random.Uniform() });
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
        name + " turned, scaled");
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
        EXPECT_TRUE(std::isfinite(value)) << hard.Name << ' ' << name;
        EXPECT_GE(value, 0.0) << hard.Name << ' ' << name;
      }
      for (const char* name : { "CircleRatio", "KernelAreaRatio", "AreaPerimeterRatio",
             "AngleRatio", "EdgeRatio", "NormalizedPointDistance", "ShapeRegularity" })
      {
        EXPECT_LE(v.at(name), 1.0) << hard.Name << ' ' << name;
      }
      EXPECT_LT(v.at("MaxAngle"), 2.0 * Pi) << hard.Name;
      EXPECT_LE(v.at("MinPointDistance"), v.at("ShortestEdge")) << hard.Name;
      EXPECT_LE(v.at("ShapeRegularity"), v.at("CircleRatio") * (1.0 + 1e-12)) << hard.Name;
    }
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

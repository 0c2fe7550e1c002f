// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Every metric of an element, as it is measured, against its definition: from exact rational
// arithmetic, the enumeration of all candidates, and matrices in extended precision.
#include "CornerMeasures.h"
#include "ElementGeometry.h"
#include "MetricRegistry.h"

#include "../Geometry/KernelQuantities.h"
#include "../Geometry/RandomSamples.h"
#include "PolygonValidity.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <ranges>
#include <string>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

using Real = long double;
using Values = std::map<std::string, double>;

auto ElementMetrics()
{
  return Metrics() | std::views::filter([](const Metric& metric) { return metric.Function; });
}

Values Measure(const Polygon& polygon, const std::string& name)
{
  Values values;
  ElementGeometry element;
  EXPECT_TRUE(element.SetVertices(polygon)) << name;
  for (const Metric& metric : ElementMetrics())
  {
    values[metric.Name] = metric.Function(element);
  }
  return values;
}

struct Corner // the edges before and after a vertex
{
  Real InX, InY, OutX, OutY;
  Real InLength() const { return std::hypot(this->InX, this->InY); }
  Real OutLength() const { return std::hypot(this->OutX, this->OutY); }
  Real Cross() const { return this->InX * this->OutY - this->InY * this->OutX; }
  /** Of the vertex from the line through its neighbours; large where the boundary turns back. */
  Real Height() const
  {
    const bool goesOn = this->InX * this->OutX + this->InY * this->OutY > 0;
    const Real chord = std::hypot(this->InX + this->OutX, this->InY + this->OutY);
    return goesOn ? std::abs(this->Cross()) / chord : chord + this->InLength() + this->OutLength();
  }
};

std::vector<Corner> CornersOf(const Polygon& polygon)
{
  std::vector<Corner> corners;
  const std::size_t size = polygon.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& a = polygon[(i + size - 1) % size];
    const Point2& b = polygon[i];
    const Point2& c = polygon[(i + 1) % size];
    corners.push_back({ Real(b.x) - a.x, Real(b.y) - a.y, Real(c.x) - b.x, Real(c.y) - b.y });
  }
  return corners;
}

/** Of each straight side, the ratio of its edges; NaN where it is not clear what is straight. */
Real ExpectedSideRatio(const std::vector<Corner>& corners, Real distance)
{
  const std::size_t size = corners.size();
  Real smallest = 1;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (std::abs(corners[i].Height() / distance - 1) < 1e-3)
    {
      return std::nan("");
    }
    Real shortest = corners[i].OutLength(); // of the side that begins with the edge after i
    Real longest = shortest;
    for (std::size_t k = 1; k < size && corners[(i + k) % size].Height() <= distance; ++k)
    {
      shortest = std::min(shortest, corners[(i + k) % size].OutLength());
      longest = std::max(longest, corners[(i + k) % size].OutLength());
    }
    smallest = std::min(smallest, shortest / longest);
  }
  return smallest;
}

/** The lowest-order virtual element from its definition: n values at the vertices. */
void AddStiffnessMeasures(const Polygon& polygon, Real area, Real diameter, Values& values)
{
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const auto n = static_cast<Eigen::Index>(polygon.size());
  Matrix monomials(n, 3); // of the vertices, about their mean: the mean of the vertices is kept
  Matrix projection(3, n);
  Real meanX = 0;
  Real meanY = 0;
  for (const Point2& point : polygon)
  {
    meanX += (Real(point.x) - polygon[0].x) / n;
    meanY += (Real(point.y) - polygon[0].y) / n;
  }
  Real momentX = 0; // centroid relative to the first vertex
  Real momentY = 0;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Point2& before = polygon[static_cast<std::size_t>((i + n - 1) % n)];
    const Point2& point = polygon[static_cast<std::size_t>(i)];
    const Point2& after = polygon[static_cast<std::size_t>((i + 1) % n)];
    const Real x = Real(point.x) - polygon[0].x;
    const Real y = Real(point.y) - polygon[0].y;
    const Real nextX = Real(after.x) - polygon[0].x;
    const Real nextY = Real(after.y) - polygon[0].y;
    const Real cross = x * nextY - y * nextX;
    momentX += cross * (x + nextX) / (6 * area);
    momentY += cross * (y + nextY) / (6 * area);
    // The mean of a gradient is the integral of value times normal, over the area.
    projection(1, i) = diameter * (Real(after.y) - before.y) / (2 * area);
    projection(2, i) = diameter * (Real(before.x) - after.x) / (2 * area);
  }
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Point2& point = polygon[static_cast<std::size_t>(i)];
    monomials.row(i) << 1, (Real(point.x) - polygon[0].x - momentX) / diameter,
      (Real(point.y) - polygon[0].y - momentY) / diameter;
    projection(0, i) = Real(1) / n - projection(1, i) * (meanX - momentX) / diameter -
      projection(2, i) * (meanY - momentY) / diameter;
  }
  const Matrix gradients = projection.bottomRows(2);
  const Matrix rest = Matrix::Identity(n, n) - monomials * projection;
  const Matrix stiffness =
    area / (diameter * diameter) * gradients.transpose() * gradients + rest.transpose() * rest;
  const auto eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix>(stiffness).eigenvalues().eval();
  const auto singular = Eigen::JacobiSVD<Matrix>(projection).singularValues().eval();
  values["StabilityRatio"] = static_cast<double>(eigenvalues(1) / eigenvalues(n - 1));
  values["ProjectionCondition"] = static_cast<double>(singular(0) / singular(2));
}

/** What is defined by a few lengths, areas and angles. */
void AddRatios(Values& v, double n)
{
  constexpr double Pi = std::numbers::pi;
  const double h = v["Diameter"];
  const double small = std::min(std::sqrt(v["Area"]), v["ShortestEdge"]);
  v["NumberOfEdges"] = n;
  v["CircleRatio"] = v["InscribedRadius"] / v["CircumscribedRadius"];
  v["KernelAreaRatio"] = v["VEMRho1"] = v["KernelArea"] / v["Area"];
  v["AngleRatio"] = v["MinAngle"] / v["MaxAngle"];
  v["NormalizedPointDistance"] = v["MinPointDistance"] / h;
  v["InradiusRatio"] = 2.0 * v["InscribedRadius"] / h;
  v["OutradiusRatio"] = h / (2.0 * v["CircumscribedRadius"]);
  v["MinAngleFraction"] = v["MinAngle"] / (2.0 * Pi);
  v["MaxAngleFraction"] = 1.0 - v["MaxAngle"] / (2.0 * Pi);
  v["VEMRho2"] = small / h;
  v["VEMRho3"] = 3.0 / n;
  v["VEMIndicator"] = std::sqrt(v["VEMRho1"] * (v["VEMRho2"] + v["VEMRho3"] + v["VEMRho4"]) / 3.0);
  v["VEMRatio"] = h / small;
  v["MinSideRadiusRatio"] = v["ShortestEdge"] / v["InscribedRadius"];
}

Values Expect(const Polygon& polygon)
{
  const BruteMeasures brute = BruteMeasure(polygon);
  const std::vector<Corner> corners = CornersOf(polygon);
  Real shortest = corners[0].OutLength();
  Real longest = shortest;
  Real sine = 1;
  Real frobenius = 1;
  Point2 low = polygon[0];
  Point2 high = polygon[0];
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Real in = corners[i].InLength();
    const Real out = corners[i].OutLength();
    shortest = std::min(shortest, out);
    longest = std::max(longest, out);
    sine = std::min(sine, corners[i].Cross() / (in * out));
    frobenius = std::min(frobenius, 2 * std::abs(corners[i].Cross()) / (in * in + out * out));
    low = { std::min(low.x, polygon[i].x), std::min(low.y, polygon[i].y) };
    high = { std::max(high.x, polygon[i].x), std::max(high.y, polygon[i].y) };
  }
  const double area = ExactArea(polygon);
  const double enclosing = BruteEnclosingRadius(polygon);
  const Real box = (Real(high.x) - low.x) * (Real(high.y) - low.y);
  Values v = { { "Area", area }, { "Diameter", brute.Diameter },
    { "MinPointDistance", brute.ClosestPair }, { "MinAngle", brute.SmallestAngle },
    { "MaxAngle", brute.LargestAngle }, { "CircumscribedRadius", enclosing },
    { "InscribedRadius", ExpectedInscribedRadius(polygon) },
    { "KernelArea", ExactKernelArea(polygon) },
    { "ShapeRegularity", BruteKernelRadius(polygon) / enclosing },
    { "AreaPerimeterRatio", 4.0 * std::numbers::pi * area / (brute.Perimeter * brute.Perimeter) },
    { "ShortestEdge", static_cast<double>(shortest) },
    { "EdgeRatio", static_cast<double>(shortest / longest) },
    { "ScaledJacobian", static_cast<double>(std::max(Real(0), sine)) },
    { "FrobeniusRatio", static_cast<double>(frobenius) },
    { "VEMRho4",
      static_cast<double>(ExpectedSideRatio(corners, StraightTolerance * brute.Diameter)) },
    { "BoxRatio", static_cast<double>(area / box) } };
  AddRatios(v, static_cast<double>(polygon.size()));
  AddStiffnessMeasures(polygon, area, brute.Diameter, v);
  return v;
}

int PowerOf(const Metric& metric)
{
  const std::string unit = metric.Unit;
  return unit == "length" ? 1 : unit == "length^2" ? 2 : 0;
}

class MetricExactness : public testing::TestWithParam<int>
{
protected:
  static constexpr int PartSize = PEMESH_EXACTNESS_PART;
  int First() const { return this->GetParam() * PartSize; }
  int Last() const { return this->First() + PartSize; }
};

} // namespace

TEST_P(MetricExactness, AgreesWithDefinitions)
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
    const Values expected = Expect(sample.Vertices);
    const Values measured = Measure(sample.Vertices, sample.Name);
    for (const Metric& metric : ElementMetrics())
    {
      ASSERT_TRUE(expected.contains(metric.Name)) << metric.Name;
      const double value = expected.at(metric.Name);
      if (!std::isnan(value))
      {
        EXPECT_NEAR(
          measured.at(metric.Name), value, Allowed(value, PowerOf(metric), expected.at("Diameter")))
          << metric.Name << " of " << sample.Name;
      }
    }
  }
  EXPECT_GE(tested, PartSize * 9 / 10);
}

TEST_P(MetricExactness, IsInvariant)
{
  int tested = 0;
  for (int number = this->First(); number < this->Last(); ++number)
  {
    const Sample sample = MakeSample(number);
    const Polygon& polygon = sample.Vertices;
    const double diameter = Diameter(polygon);
    // What the image is rounded by must not be what is measured, nor decide what is straight.
    if (!IsSimple(polygon) || ClosestPair(polygon).Distance < 1e-3 * diameter ||
      std::isnan(ExpectedSideRatio(CornersOf(polygon), StraightTolerance * diameter)))
    {
      continue;
    }
    const Polygon atHome = Transformed(polygon, 0.0, 1.0, { -polygon[0].x, -polygon[0].y });
    const Values expected = Measure(polygon, sample.Name);
    const auto Compare = [&](const Polygon& image, double factor, bool turned, const char* what)
    {
      if (!IsSimple(image))
      {
        return;
      }
      ++tested;
      const Values values = Measure(image, sample.Name + what);
      for (const Metric& metric : ElementMetrics())
      {
        if (!turned || metric.RotationInvariant)
        {
          const int power = PowerOf(metric);
          const double value = expected.at(metric.Name);
          EXPECT_NEAR(values.at(metric.Name) / std::pow(factor, power), value,
            Allowed(value, power, diameter))
            << metric.Name << " of " << sample.Name << what;
        }
      }
    };
    Compare(Transformed(atHome, 0.0, 1.0, { 3.0 * diameter, diameter }), 1.0, false, " moved");
    Compare(Transformed(atHome, 0.4 + number, 1.0, {}), 1.0, true, " rotated");
    for (const double factor : { 1e-9, 0.3, 1e9 })
    {
      Compare(Transformed(atHome, 0.0, factor, {}), factor, false, " scaled");
    }
    Polygon image = polygon;
    std::rotate(image.begin(), image.begin() + 1 + number % 2, image.end());
    Compare(image, 1.0, false, " from another vertex on");
    std::reverse(image.begin(), image.end());
    Compare(image, 1.0, false, " reversed");
    for (Point2& point : image)
    {
      point.x = -point.x;
    }
    Compare(image, 1.0, false, " in a mirror");
  }
  EXPECT_GE(tested, PartSize);
}

INSTANTIATE_TEST_SUITE_P(Random, MetricExactness,
  testing::Range(0, PEMESH_EXACTNESS_POLYGONS / PEMESH_EXACTNESS_PART),
  [](const testing::TestParamInfo<int>& part) { return "Part" + std::to_string(part.param); });

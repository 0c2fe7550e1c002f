// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using pemesh::IntegrandValues;
using pemesh::PointBlock;
using pemesh::PointBlockSize;
using pemesh::Triangle2;

const Triangle2 UnitTriangle = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } } };

template <typename Function>
auto AsIntegrand(Function function)
{
  return [function](const PointBlock& points, IntegrandValues<1>& values)
  {
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      values[0][i] = function(points.X[i], points.Y[i]);
    }
  };
}

// a! b! / (a + b + 2)!
double MonomialIntegral(int a, int b)
{
  return std::exp(std::lgamma(a + 1) + std::lgamma(b + 1) - std::lgamma(a + b + 3));
}

double ErrorOfRule(std::size_t rule, int a, int b)
{
  const auto sums = pemesh::ApplyTriangleRule<1>(rule, UnitTriangle, 0.5,
    AsIntegrand([a, b](double x, double y) { return std::pow(x, a) * std::pow(y, b); }));
  return std::abs(sums.Value[0] / MonomialIntegral(a, b) - 1.0);
}

const auto Agree = [](const auto& coarse, const auto& fine, double)
{ return std::abs(coarse.Value[0] - fine.Value[0]) <= 1.0e-12 * fine.Absolute[0]; };

TEST(Quadrature, RulesAreExactToTheirDegreeAndNoFurther)
{
  for (std::size_t rule = 0; rule < pemesh::NumberOfTriangleRules; ++rule)
  {
    const int degree = pemesh::TriangleRuleDegrees[rule];
    for (int total = 0; total <= degree; ++total)
    {
      for (int a = 0; a <= total; ++a)
      {
        EXPECT_LT(ErrorOfRule(rule, a, total - a), 2.0e-14) << rule << " " << a << " " << total;
      }
    }
    EXPECT_GT(ErrorOfRule(rule, degree + 1, 0), 1.0e-9);
  }
}

TEST(Quadrature, WeightsArePositiveAndPointsInside)
{
  const std::size_t counts[] = { 7, 16, 33 };
  for (std::size_t rule = 0; rule < pemesh::NumberOfTriangleRules; ++rule)
  {
    std::size_t count = 0;
    for (const auto& block : pemesh::TriangleRule(rule))
    {
      for (std::size_t i = 0; i < PointBlockSize; ++i)
      {
        count += block.Weight[i] > 0.0 ? 1 : 0;
        EXPECT_GE(block.Weight[i], 0.0);
        EXPECT_GT(std::min({ block.First[i], block.Second[i], block.Third[i] }), 0.0);
      }
    }
    EXPECT_EQ(count, counts[rule]);
  }
}

TEST(Quadrature, SubdividesUntilASteepFunctionIsIntegrated)
{
  for (const double a : { 1.0, 20.0, 200.0 })
  {
    // The integral of exp(a x) over the triangle is (exp(a) - 1 - a) / a^2.
    const double exact = (std::exp(a) - 1.0 - a) / (a * a);
    const auto value = pemesh::IntegrateOverTriangle<1>(
      UnitTriangle, AsIntegrand([a](double x, double) { return std::exp(a * x); }), Agree);
    EXPECT_NEAR(value[0] / exact, 1.0, 1.0e-11) << a;
  }
}

TEST(Quadrature, EndsOnAFunctionThatJumps)
{
  const auto value = pemesh::IntegrateOverTriangle<1>(
    UnitTriangle, AsIntegrand([](double x, double) { return x < 0.3 ? 1.0 : 0.0; }), Agree, 8);
  EXPECT_NEAR(value[0], 0.3 - 0.045, 1.0e-3);
}

TEST(Quadrature, AClockwiseTriangleCountsNegative)
{
  const Triangle2 clockwise = { UnitTriangle[0], UnitTriangle[2], UnitTriangle[1] };
  const auto value = pemesh::IntegrateOverTriangle<1>(
    clockwise, AsIntegrand([](double x, double y) { return x + y; }), Agree);
  EXPECT_NEAR(value[0], -1.0 / 3.0, 1.0e-15);
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GaussRules.h"
#include "Quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
  return [function](const PointBlock& points, IntegrandValues values)
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
  pemesh::TriangleIntegrals sums;
  pemesh::TriangleIntegrator(1).ApplyRule(pemesh::TriangleRule(rule), false, UnitTriangle,
    AsIntegrand([a, b](double x, double y) { return std::pow(x, a) * std::pow(y, b); }), sums);
  return std::abs(sums.Value[0] / MonomialIntegral(a, b) - 1.0);
}

template <typename Function, typename Agree>
double Integrate(
  const Triangle2& triangle, const Function& function, const Agree& agree, int depth = 14)
{
  double sum = 0.0;
  pemesh::TriangleIntegrator(1).Add(triangle, AsIntegrand(function), agree, { &sum, 1 }, depth);
  return sum;
}

const auto Agree = [](const auto& coarse, const auto& fine, double, std::size_t)
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
    const auto value = Integrate(
      UnitTriangle, [a](double x, double) { return std::exp(a * x); }, Agree);
    EXPECT_NEAR(value / exact, 1.0, 1.0e-11) << a;
  }
}

TEST(Quadrature, TheEmbeddedRulesHaveTheirDegrees)
{
  const int degrees[] = { 2, 4, 6 };
  for (std::size_t rule = 0; rule < pemesh::NumberOfTriangleRules; ++rule)
  {
    double worst = 0.0; // one degree further on
    for (int a = 0; a <= degrees[rule] + 1; ++a)
    {
      for (int b = 0; a + b <= degrees[rule] + 1; ++b)
      {
        pemesh::TriangleIntegrals sums;
        pemesh::TriangleIntegrator(1).ApplyRule(pemesh::TriangleRule(rule), true, UnitTriangle,
          AsIntegrand([a, b](double x, double y) { return std::pow(x, a) * std::pow(y, b); }),
          sums);
        const double error = std::abs(sums.Embedded[0] / MonomialIntegral(a, b) - 1.0);
        if (a + b <= degrees[rule])
        {
          EXPECT_LT(error, 1.0e-14) << rule << " " << a << " " << b;
        }
        worst = std::max(worst, error);
        if (rule == 0 && a + b <= 1)
        {
          EXPECT_NEAR(sums.FirstDegree[0] / MonomialIntegral(a, b), 1.0, 1.0e-14) << a << " " << b;
        }
      }
    }
    EXPECT_GT(worst, 1.0e-4);
  }
}

// The square of the error of a method of order k on a small triangle, (p^2, p of degree k + 1) and
// a little more: the steps end without a cut, and are exact.
TEST(Quadrature, SquaresOfErrorsOfEveryOrderAreIntegratedWithoutCuts)
{
  for (int order = 1; order <= 6; ++order)
  {
    const auto steps = pemesh::StepsForErrors(order);
    const auto allowed = pemesh::DifferencesAllowed(1.0e-10, steps, 2 * order + 2);
    int calls = 0;
    const auto agree = [&](const auto& coarse, const auto& fine, double, std::size_t step)
    {
      EXPECT_GT(allowed[step], 0.0) << order;
      return std::abs(coarse.Value[0] - fine.Value[0]) <= allowed[step] * fine.Absolute[0];
    };
    for (const double h : { 1.0e-4, 1.0e-3 })
    {
      double sum = 0.0;
      pemesh::TriangleIntegrator(1, steps).Add(UnitTriangle,
        [&](const PointBlock& points, IntegrandValues values)
        {
          ++calls;
          for (std::size_t i = 0; i < PointBlockSize; ++i)
          {
            values[0][i] = std::pow(points.X[i], 2 * order + 2) * (1.0 + h * points.Y[i]);
          }
        },
        agree, { &sum, 1 });
      const double exact =
        MonomialIntegral(2 * order + 2, 0) + h * MonomialIntegral(2 * order + 2, 1);
      EXPECT_NEAR(sum / exact, 1.0, 1.0e-10) << order << " " << h;
    }
    EXPECT_LE(calls, 2 * 32) << order;
  }
}

TEST(Quadrature, AnAllowedDifferenceLeavesTheErrorOfTheTolerance)
{
  // exp(h (x + y)) over the unit triangle, that is over a triangle of the size h: the integral is
  // the sum of h^n / n! times that of (x + y)^n, which is 1 / (n + 2).
  for (const double h : { 1.0e-3, 1.0e-2, 0.05, 0.2, 0.5, 1.0 })
  {
    double exact = 0.0;
    double term = 1.0;
    for (int n = 0; n < 30; ++n)
    {
      exact += term / (n + 2);
      term *= h / (n + 1);
    }
    for (const double tolerance : { 1.0e-6, 1.0e-8, 1.0e-10 })
    {
      const auto allowed = pemesh::DifferencesAllowed(tolerance, pemesh::GeneralSteps());
      const auto agree = [&](const auto& coarse, const auto& fine, double, std::size_t step)
      { return std::abs(coarse.Value[0] - fine.Value[0]) <= allowed[step] * fine.Absolute[0]; };
      const double value = Integrate(
        UnitTriangle, [h](double x, double y) { return std::exp(h * (x + y)); }, agree);
      EXPECT_NEAR(value / exact, 1.0, tolerance) << h;
    }
  }
}

TEST(Quadrature, WhatACoarseRuleDoesNotTakeIsNotComparedWithIt)
{
  EXPECT_EQ(pemesh::DifferenceAllowed(1e-10, { 2, 5 }, 4), 0.0);
  EXPECT_NEAR(pemesh::DifferenceAllowed(1e-10, { 5, 8 }, 4), 1e-4, 1e-15);  // h^2 against h^5
  EXPECT_NEAR(pemesh::DifferenceAllowed(1e-12, { 5, 8 }), 1e-8, 1e-19);     // h^6 against h^9
  EXPECT_NEAR(pemesh::DifferenceAllowed(1e-10, { 8, 12 }, 8), 1e-4, 1e-15); // not further
}

TEST(Quadrature, EndsOnAFunctionThatJumps)
{
  for (const double place : { 0.05, 0.15, 0.3, 0.47, 0.6, 0.8, 0.9 })
  {
    // Seven points do not see a corner: what is cut off there shrinks with every cut.
    for (const auto& [cuts, tolerance] : { std::pair{ 1, 6.0e-3 }, { 3, 2.0e-3 } })
    {
      double value = 0.0;
      pemesh::TriangleIntegrator(1, pemesh::GeneralSteps(), static_cast<std::size_t>(cuts))
        .Add(UnitTriangle,
          AsIntegrand([place = place](double x, double) { return x < place ? 1.0 : 0.0; }), Agree,
          { &value, 1 }, 8);
      EXPECT_NEAR(value, place - 0.5 * place * place, tolerance) << place << " " << cuts;
    }
  }
}

TEST(Quadrature, AClockwiseTriangleCountsNegative)
{
  const Triangle2 clockwise = { UnitTriangle[0], UnitTriangle[2], UnitTriangle[1] };
  const auto value = Integrate(
    clockwise, [](double x, double y) { return x + y; }, Agree);
  EXPECT_NEAR(value, -1.0 / 3.0, 1.0e-15);
}

TEST(Quadrature, RulesOfAnyDegreeAreExact)
{
  for (const int degree : { 1, 4, 6, 11, 13, 14, 20, 31 })
  {
    for (int a = 0; a <= degree; ++a)
    {
      double sum = 0.0;
      for (const auto& block : pemesh::TriangleRuleOfDegree(degree))
      {
        for (std::size_t i = 0; i < PointBlockSize; ++i)
        {
          sum += 0.5 * block.Weight[i] * std::pow(block.Second[i], a) *
            std::pow(block.Third[i], degree - a);
          EXPECT_GE(std::min({ block.First[i], block.Second[i], block.Third[i] }), 0.0);
        }
      }
      EXPECT_NEAR(sum / MonomialIntegral(a, degree - a), 1.0, 1.0e-12) << degree << " " << a;
    }
  }
}

TEST(GaussRules, AreThoseOfTheTables)
{
  // Abramowitz, Stegun, Handbook of mathematical functions, 25.4.29 and 25.4.32, on [0, 1].
  const auto legendre = pemesh::GaussLegendre(3);
  EXPECT_NEAR(legendre.Points[0], 0.5 - 0.5 * std::sqrt(0.6), 1.0e-16);
  EXPECT_NEAR(legendre.Weights[1], 4.0 / 9.0, 1.0e-16);
  const auto lobatto = pemesh::GaussLobatto(5);
  EXPECT_NEAR(lobatto.Points[1], 0.5 - 0.5 * std::sqrt(3.0 / 7.0), 1.0e-16);
  EXPECT_NEAR(lobatto.Weights[0], 1.0 / 20.0, 1.0e-16);
  EXPECT_NEAR(lobatto.Weights[1], 49.0 / 180.0, 1.0e-16);
  EXPECT_NEAR(lobatto.Weights[2], 16.0 / 45.0, 1.0e-16);
}

TEST(GaussRules, AreExactToTheirDegree)
{
  for (int n = 2; n <= 12; ++n)
  {
    const auto check = [n](const pemesh::GaussRule& rule, int degree)
    {
      for (int power = 0; power <= degree + 1; ++power)
      {
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.Points.size(); ++i)
        {
          sum += rule.Weights[i] * std::pow(2.0 * rule.Points[i] - 1.0, power);
        }
        const double exact = power % 2 == 0 ? 1.0 / (power + 1) : 0.0;
        if (power <= degree)
        {
          EXPECT_NEAR(sum, exact, 1.0e-15) << n << " " << power;
        }
        else if (n < 8)
        {
          EXPECT_GT(std::abs(sum - exact), 1.0e-6) << n;
        }
      }
    };
    check(pemesh::GaussLegendre(n), 2 * n - 1);
    check(pemesh::GaussLobatto(n), 2 * n - 3);
  }
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EllipticProblem.h"
#include "TestProblems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

namespace
{

using pemesh::EllipticProblem;
using pemesh::Point2;
using pemesh::TestProblem;

const Point2 Places[] = { { 0.0, 0.0 }, { 1.0, 1.0 }, { 0.21, 0.83 }, { 4.0 / 9.0, 7.0 / 9.0 },
  { 2.0 / 9.0, 2.0 / 9.0 }, { 7.0 / 9.0, 1.0 / 3.0 }, { 0.5, 0.123 }, { 0.99, 0.01 } };

double FrankeFormula(double x, double y, double last)
{
  const auto square = [](double v) { return v * v; };
  return 0.75 * std::exp(-(square(9 * x - 2) + square(9 * y - 2)) / 4) +
    0.75 * std::exp(-(square(9 * x + 1) / 49 + (9 * y + 1) / 10)) +
    0.5 * std::exp(-(square(9 * x - 7) + square(9 * y - 3)) / 4) +
    last * std::exp(-(square(9 * x - 4) + square(9 * y - 7)));
}

TEST(TestProblems, TheTableHasTheProblemsUnderDistinctNames)
{
  std::set<std::string> names;
  for (const TestProblem& problem : pemesh::TestProblems())
  {
    EXPECT_TRUE(names.insert(problem.Name).second);
    EXPECT_EQ(pemesh::FindTestProblem(problem.Name), &problem);
    EXPECT_FALSE(std::string(problem.Label).empty());
    EXPECT_FALSE(std::string(problem.Formula).empty());
  }
  for (const char* name : { "franke", "franke-1979", "linear", "polynomial", "trigonometric" })
  {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
  EXPECT_EQ(pemesh::FindTestProblem("frank"), nullptr);
}

TEST(TestProblems, SolutionsAreTheFormulas)
{
  const double pi = std::numbers::pi;
  for (const auto& [x, y] : Places)
  {
    const auto value = [x = x, y = y](const char* name) {
      return pemesh::EllipticProblem(*pemesh::FindTestProblem(name)).Solution({ x, y });
    };
    EXPECT_NEAR(value("franke"), FrankeFormula(x, y, 0.2), 3.0e-16 * 4);
    EXPECT_NEAR(value("franke-1979"), FrankeFormula(x, y, -0.2), 3.0e-16 * 4);
    EXPECT_DOUBLE_EQ(value("polynomial"), 16 * x * y * (1 - x) * (1 - y) + 1.1);
    EXPECT_NEAR(value("trigonometric"), std::sin(2 * pi * x) * std::sin(2 * pi * y), 1.0e-15);
  }
}

TEST(TestProblems, FrankesPeakHasTheSignOfItsLastTerm)
{
  const Point2 peak = { 4.0 / 9.0, 7.0 / 9.0 };
  EXPECT_NEAR(pemesh::EllipticProblem(*pemesh::FindTestProblem("franke")).Solution(peak) -
      pemesh::EllipticProblem(*pemesh::FindTestProblem("franke-1979")).Solution(peak),
    0.4, 1.0e-15);
}

TEST(TestProblems, SmallValuesKeepTheirDigits)
{
  // Far outside only the second term is left, and it is tiny.
  const double x = 15.0;
  const double y = 3.0;
  const double exact = 0.75 * std::exp(-(136.0 * 136.0 / 49.0 + 28.0 / 10.0));
  const pemesh::EllipticProblem franke = *pemesh::FindTestProblem("franke");
  EXPECT_NEAR(franke.Solution({ x, y }) / exact, 1.0, 1.0e-12);
}

// Central differences of fourth order; the step balances their error with rounding, where a layer
// allows it.
struct Differences
{
  const EllipticProblem& Problem;
  Point2 Place;
  double Step;

  template <typename Function>
  double First(const Function& f, double dx, double dy) const
  {
    const auto at = [&](double s) {
      return f({ Place.x + s * dx * Step, Place.y + s * dy * Step });
    };
    return (8 * (at(1) - at(-1)) - at(2) + at(-2)) / (12 * Step);
  }
};

// -div(kappa grad u) + beta . grad u + c u, from differences of kappa grad u.
TEST(TestProblems, GradientsAndSourcesAreTheDerivatives)
{
  for (const TestProblem& entry : pemesh::TestProblems())
  {
    const EllipticProblem problem = entry;
    for (const Point2& place : Places)
    {
      if (std::string(entry.Name) == "l-shape" && place.x >= 0.5 && place.y <= 0.5)
      {
        continue; // not in its domain
      }
      const Differences d = { problem, place, 5.0e-4 };
      const auto u = [&](Point2 p) { return problem.Solution(p); };
      const auto fluxX = [&](Point2 p)
      {
        return problem.Diffusion(p).XX * problem.Gradient(p).x +
          problem.Diffusion(p).XY * problem.Gradient(p).y;
      };
      const auto fluxY = [&](Point2 p)
      {
        return problem.Diffusion(p).XY * problem.Gradient(p).x +
          problem.Diffusion(p).YY * problem.Gradient(p).y;
      };
      const Point2 gradient = problem.Gradient(place);
      EXPECT_NEAR(gradient.x, d.First(u, 1, 0), 1.0e-5 * (1 + std::abs(gradient.x))) << entry.Name;
      EXPECT_NEAR(gradient.y, d.First(u, 0, 1), 1.0e-5 * (1 + std::abs(gradient.y))) << entry.Name;
      pemesh::PointBlock points;
      points.X.fill(place.x);
      points.Y.fill(place.y);
      pemesh::CoefficientBlock c;
      problem.EvaluateCoefficients(points, c);
      const double expected = -d.First(fluxX, 1, 0) - d.First(fluxY, 0, 1) +
        c.AdvectionX[0] * gradient.x + c.AdvectionY[0] * gradient.y + c.Reaction[0] * u(place);
      EXPECT_NEAR(problem.Source(place), expected, 1.0e-5 * (1 + std::abs(expected))) << entry.Name;
    }
  }
}

TEST(TestProblems, ABlockHoldsWhatEachPointGives)
{
  for (const TestProblem& entry : pemesh::TestProblems())
  {
    const EllipticProblem problem = entry;
    pemesh::PointBlock points;
    for (std::size_t i = 0; i < pemesh::PointBlockSize; ++i)
    {
      points.X[i] = Places[i].x;
      points.Y[i] = Places[i].y;
    }
    pemesh::TestProblemBlock block;
    problem.Evaluate(points, block);
    for (std::size_t i = 0; i < pemesh::PointBlockSize; ++i)
    {
      EXPECT_EQ(block.Solution[i], problem.Solution(Places[i]));
      EXPECT_EQ(block.GradientX[i], problem.Gradient(Places[i]).x);
      EXPECT_EQ(block.GradientY[i], problem.Gradient(Places[i]).y);
      EXPECT_EQ(block.Source[i], problem.Source(Places[i]));
    }
  }
}

std::string WhyRefused(const pemesh::ProblemFormulas& formulas)
{
  try
  {
    const EllipticProblem problem(formulas);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "accepted";
}

TEST(Formulas, ASolutionGivesItsSource)
{
  pemesh::ProblemFormulas formulas;
  formulas.Solution = "sin(pi*x)*y^2 + sqrt(1+x)*exp(-y)";
  formulas.Diffusion = "2+x";
  formulas.AdvectionX = "y";
  formulas.Reaction = "3";
  const EllipticProblem problem(formulas);
  const double pi = std::numbers::pi;
  for (const auto& [x, y] : Places)
  {
    const double root = std::sqrt(1 + x);
    const double e = std::exp(-y);
    const double u = std::sin(pi * x) * y * y + root * e;
    const double ux = pi * std::cos(pi * x) * y * y + e / (2 * root);
    const double uxx = -pi * pi * std::sin(pi * x) * y * y - e / (4 * root * root * root);
    const double uyy = 2 * std::sin(pi * x) + root * e;
    EXPECT_NEAR(problem.Solution({ x, y }), u, 1.0e-14);
    EXPECT_NEAR(problem.Source({ x, y }), -(2 + x) * (uxx + uyy) - ux + y * ux + 3 * u, 1.0e-12);
  }
  EXPECT_TRUE(problem.HasAdvection());
  EXPECT_TRUE(problem.HasReaction());
  EXPECT_FALSE(problem.IsPoisson());
}

TEST(Formulas, WhatIsWrongIsToldWithItsPlace)
{
  pemesh::ProblemFormulas formulas;
  formulas.Solution = "sin(x) + 3*z";
  EXPECT_NE(WhyRefused(formulas).find("solution"), std::string::npos) << WhyRefused(formulas);
  EXPECT_NE(WhyRefused(formulas).find("position 12"), std::string::npos) << WhyRefused(formulas);
  for (const char* wrong :
    { "sin(x", "x+*y", "1/0", "x; y", "sin(x,y)", "  ", "sqrt(-1)", "log(0)" })
  {
    formulas.Solution = wrong;
    EXPECT_NE(WhyRefused(formulas).find("solution"), std::string::npos)
      << wrong << ": " << WhyRefused(formulas);
  }
  EXPECT_NE(WhyRefused({}).find("load"), std::string::npos);
}

} // namespace

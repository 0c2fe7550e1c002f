// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestProblems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace
{

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
      return pemesh::FindTestProblem(name)->Solution({ x, y });
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
  EXPECT_NEAR(pemesh::FindTestProblem("franke")->Solution(peak) -
      pemesh::FindTestProblem("franke-1979")->Solution(peak),
    0.4, 1.0e-15);
}

TEST(TestProblems, SmallValuesKeepTheirDigits)
{
  // Far outside only the second term is left, and it is tiny.
  const double x = 15.0;
  const double y = 3.0;
  const double exact = 0.75 * std::exp(-(136.0 * 136.0 / 49.0 + 28.0 / 10.0));
  EXPECT_NEAR(pemesh::FindTestProblem("franke")->Solution({ x, y }) / exact, 1.0, 1.0e-12);
}

// Central differences of fourth order; the step balances their error with rounding.
TEST(TestProblems, GradientsAndSourcesAreTheDerivatives)
{
  const double h = 2.0e-3;
  for (const TestProblem& problem : pemesh::TestProblems())
  {
    for (const Point2& p : Places)
    {
      const auto along = [&](double dx, double dy) {
        return problem.Solution({ p.x + dx, p.y + dy });
      };
      const auto first = [&](double dx, double dy)
      {
        return (8 * (along(dx, dy) - along(-dx, -dy)) - along(2 * dx, 2 * dy) +
                 along(-2 * dx, -2 * dy)) /
          (12 * h);
      };
      const auto second = [&](double dx, double dy)
      {
        return (16 * (along(dx, dy) + along(-dx, -dy)) - along(2 * dx, 2 * dy) -
                 along(-2 * dx, -2 * dy) - 30 * along(0, 0)) /
          (12 * h * h);
      };
      EXPECT_NEAR(problem.Gradient(p).x, first(h, 0), 2.0e-4) << problem.Name;
      EXPECT_NEAR(problem.Gradient(p).y, first(0, h), 2.0e-4) << problem.Name;
      EXPECT_NEAR(problem.Source(p), -second(h, 0) - second(0, h), 1.0e-2) << problem.Name;
    }
  }
}

TEST(TestProblems, ABlockHoldsWhatEachPointGives)
{
  for (const TestProblem& problem : pemesh::TestProblems())
  {
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

} // namespace

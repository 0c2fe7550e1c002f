// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Systems that have no solution, or none in double precision, are refused; those that are only
 * indefinite are solved.
 */
#include "EllipticProblem.h"
#include "SparseCholesky.h"
#include "SparseLU.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"
#include "VirtualElementTestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

using pemesh::EllipticProblem;
using pemesh::FindTestProblem;
using pemesh::SolveElliptic;
using pemesh::SparseMatrix;
using pemesh::VirtualElementOptions;
using pemesh::VirtualElementResult;
using testing::HasSubstr;

std::string WhyRefused(vtkPolyData* mesh, const pemesh::ProblemFormulas& formulas, int order = 1)
{
  try
  {
    VirtualElementOptions options;
    options.Order = order;
    SolveElliptic(mesh, EllipticProblem(formulas, FindTestProblem("linear")), options);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "accepted";
}

// The unit square, and another one beside it that does not touch it, each of four squares.
vtkSmartPointer<vtkPolyData> MakeTwoSquares()
{
  std::vector<pemesh::Point2> points;
  std::vector<pemesh::IdList> elements;
  for (const double left : { 0.0, 2.0 })
  {
    const auto first = static_cast<vtkIdType>(points.size());
    for (int i = 0; i < 9; ++i)
    {
      points.push_back({ left + 0.5 * (i % 3), 0.5 * (i / 3) });
    }
    for (const vtkIdType corner : { 0, 1, 3, 4 })
    {
      const vtkIdType a = first + corner;
      elements.push_back({ a, a + 1, a + 4, a + 3 });
    }
  }
  return pemesh::MakeMesh(points, elements);
}

TEST(WellPosedness, AdvectionDoesNotFixTheConstant)
{
  pemesh::ProblemFormulas formulas;
  formulas.Neumann = "1";
  formulas.AdvectionX = "1";
  for (const int order : { 1, 2 })
  {
    EXPECT_THAT(
      WhyRefused(pemesh::MakeLShapes(4), formulas, order), HasSubstr("only up to a constant"));
  }
  formulas.Reaction = "1";
  EXPECT_EQ(WhyRefused(pemesh::MakeLShapes(4), formulas), "accepted");
}

TEST(WellPosedness, EveryPartOfTheMeshNeedsBoundaryValues)
{
  pemesh::ProblemFormulas formulas;
  formulas.Neumann = "x-1.5"; // all of the second square
  for (const int order : { 1, 2, 3 })
  {
    EXPECT_THAT(WhyRefused(MakeTwoSquares(), formulas, order),
      HasSubstr("the part of the mesh that holds element 4,"));
  }
  formulas.Neumann = "x-2.8"; // one side of it
  EXPECT_EQ(WhyRefused(MakeTwoSquares(), formulas), "accepted");
  formulas.Neumann = "x-1.5";
  formulas.Reaction = "2";
  EXPECT_EQ(WhyRefused(MakeTwoSquares(), formulas), "accepted");
}

// A reaction that is zero on the second square: only the pivots tell.
TEST(WellPosedness, AReactionElsewhereDoesNotFixTheConstant)
{
  pemesh::ProblemFormulas formulas;
  formulas.Neumann = "x-1.5";
  formulas.Reaction = "step(1.5-x)";
  EXPECT_THAT(WhyRefused(MakeTwoSquares(), formulas), HasSubstr("singular"));
  formulas.AdvectionX = "1";
  EXPECT_THAT(WhyRefused(MakeTwoSquares(), formulas), HasSubstr("singular"));
}

// u of degree k is reproduced, however many eigenvalues are negative: those of -Laplace on the unit
// square are 2, 5, 5, 8, … times pi^2.
TEST(WellPosedness, IndefiniteSystemsAreSolved)
{
  for (const char* reaction : { "-30", "-50", "-300" })
  {
    pemesh::ProblemFormulas formulas;
    formulas.Reaction = reaction;
    const char* const problems[] = { "", "linear", "quadratic", "cubic" };
    for (const int order : { 1, 2, 3 })
    {
      VirtualElementOptions options;
      options.Order = order;
      options.Load = pemesh::LoadProjection::SameDegree;
      options.Details = true;
      const VirtualElementResult result = SolveElliptic(pemesh::MakeLShapes(10, 0.4),
        EllipticProblem(formulas, FindTestProblem(problems[order])), options);
      EXPECT_LT(result.RelativeErrorInf, 1.0e-9) << reaction << " order " << order;
      EXPECT_LT(result.RelativeErrorL2, 1.0e-9) << reaction << " order " << order;
      EXPECT_GT(result.ConditionNumber, 1.0);
      EXPECT_LT(result.ConditionNumber, 1.0e7);
      // Each norm is at most sqrt(n) times the other.
      const double ratio = result.SpectralConditionNumber / result.ConditionNumber;
      EXPECT_GT(ratio * result.DegreesOfFreedom, 1.0);
      EXPECT_LT(ratio, 1.0 + 1.0e-4); // the 2-norm of a symmetric matrix is the smallest one
    }
  }
}

// e^T K e of an indefinite K is no square.
TEST(WellPosedness, AnIndefiniteFormIsNoEnergy)
{
  pemesh::ProblemFormulas formulas;
  formulas.Reaction = "-2000";
  const VirtualElementResult result = SolveElliptic(
    pemesh::MakeLShapes(10, 0.4), EllipticProblem(formulas, FindTestProblem("franke")));
  EXPECT_TRUE(std::isnan(result.RelativeErrorEnergy)) << result.RelativeErrorEnergy;
  EXPECT_GT(result.RelativeErrorL2, 0.0);
}

TEST(WellPosedness, WhatTheIterationAdvisesHelps)
{
  pemesh::ProblemFormulas formulas;
  formulas.Reaction = "-30";
  const EllipticProblem problem(formulas, FindTestProblem("franke"));
  VirtualElementOptions options;
  options.Solver = pemesh::SolverKind::Iterative;
  const auto mesh = pemesh::MakeLShapes(10, 0.4);
  try
  {
    SolveElliptic(mesh, problem, options);
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_THAT(error.what(), HasSubstr("negative reaction"));
    EXPECT_THAT(error.what(), HasSubstr("direct"));
  }
  options.Solver = pemesh::SolverKind::Direct;
  EXPECT_LT(SolveElliptic(mesh, problem, options).RelativeErrorL2, 0.2);
}

// (1 -1; -1 1 + delta), scaled by s in the second row and column.
SparseMatrix MakePair(double delta, double s, bool symmetric)
{
  SparseMatrix matrix;
  matrix.Symmetric = symmetric;
  if (symmetric)
  {
    matrix.ColumnStart = { 0, 2, 3 };
    matrix.Row = { 0, 1, 1 };
    matrix.Value = { 1.0, -s, (1.0 + delta) * s * s };
    return matrix;
  }
  matrix.ColumnStart = { 0, 2, 4 };
  matrix.Row = { 0, 1, 0, 1 };
  matrix.Value = { 1.0, -s, -s, (1.0 + delta) * s * s };
  return matrix;
}

TEST(WellPosedness, PivotsWithoutACorrectDigitAreRefused)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_THROW(
    pemesh::SparseCholesky(MakePair(2.0 * epsilon, 1.0, true)), pemesh::NotPositiveDefinite);
  EXPECT_THROW(pemesh::SparseCholesky(MakePair(-0.1, 1.0, true)), pemesh::NotPositiveDefinite);
  EXPECT_THROW(pemesh::SparseLU(MakePair(0.5 * epsilon, 1.0, false), none), std::runtime_error);
  EXPECT_NO_THROW(pemesh::SparseCholesky(MakePair(1.0e-10, 1.0, true)));
  EXPECT_NO_THROW(pemesh::SparseLU(MakePair(1.0e-10, 1.0, false), none));
}

// Coefficients that differ by many powers of ten are no reason to refuse.
TEST(WellPosedness, ScalesDoNotMatterToCholesky)
{
  const pemesh::SparseCholesky factor(MakePair(1.0, 1.0e-12, true));
  const std::vector<double> found = factor.Solve(std::vector<double>{ 0.0, 1.0e-12 });
  EXPECT_NEAR(found[0], 1.0, 1.0e-12);
  EXPECT_NEAR(found[1], 1.0e12, 1.0);
}

TEST(WellPosedness, BothTrianglesAreThoseOfTheSymmetricMatrix)
{
  const SparseMatrix full = pemesh::WithBothTriangles(MakePair(0.5, 3.0, true));
  const SparseMatrix expected = MakePair(0.5, 3.0, false);
  EXPECT_EQ(full.ColumnStart, expected.ColumnStart);
  EXPECT_EQ(full.Row, expected.Row);
  EXPECT_EQ(full.Value, expected.Value);
  EXPECT_FALSE(full.Symmetric);
}

// Formulas that are undefined in a part of the domain: at once, not after all subdivisions.
TEST(WellPosedness, AnUndefinedSourceIsTold)
{
  pemesh::ProblemFormulas formulas;
  formulas.Load = "log(x-0.5)";
  formulas.Dirichlet = "0";
  EXPECT_THAT(WhyRefused(pemesh::MakeLShapes(4), formulas), HasSubstr("not finite"));
}

// |x - 1/2| has a jump in its slope, and step(x - 1/3) one in its value, inside elements.
TEST(WellPosedness, JumpsOfTheSourceAreSeen)
{
  for (const auto& [formula, exact] : { std::pair{ "step(x-0.31)", 0.69 },
         { "abs(x-0.47)", 0.2509 }, { "exp(-1e4*((x-0.31)^2+(y-0.37)^2))", 3.14159265358979e-4 } })
  {
    pemesh::ProblemFormulas formulas;
    formulas.Load = formula;
    formulas.Dirichlet = "0";
    formulas.Neumann = "1";
    formulas.Reaction = "1";
    // With pure Neumann data and c = 1 the mean of u_h is that of f.
    pemesh::VirtualElementOptions options;
    options.Load = pemesh::LoadProjection::SameDegree;
    const auto mesh = pemesh::MakeTriangles(5, 0.3);
    const VirtualElementResult result = SolveElliptic(mesh, EllipticProblem(formulas), options);
    double mean = 0.0;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetPolys()->GetCellAtId(cell, size, ids);
      double a[3];
      double b[3];
      double c[3];
      mesh->GetPoint(ids[0], a);
      mesh->GetPoint(ids[1], b);
      mesh->GetPoint(ids[2], c);
      const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
      for (int i = 0; i < 3; ++i)
      {
        mean += area / 3.0 * result.Solution[static_cast<std::size_t>(ids[i])];
      }
    }
    EXPECT_NEAR(mean / exact, 1.0, 1.0e-3) << formula;
  }
}

} // namespace

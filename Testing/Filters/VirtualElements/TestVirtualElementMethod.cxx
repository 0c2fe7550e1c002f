// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethod.h"

#include "CsvTable.h"
#include "EllipticProblem.h"
#include "MeshFormats.h"
#include "ParallelLoop.h"
#include "TestProblems.h"
#include "VirtualElementMethodElement.h"
#include "VirtualElementTestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <vtkTable.h>
#include <vtkVariant.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{

using pemesh::FindTestProblem;
using pemesh::MakeMesh;
using pemesh::SolveElliptic;
using pemesh::VirtualElementOptions;
using pemesh::VirtualElementResult;

const std::filesystem::path Meshes = std::filesystem::path(PEMESH_TEST_DATA) / "Meshes";

std::string WhyRefused(vtkPolyData* mesh)
{
  try
  {
    SolveElliptic(mesh, *FindTestProblem("linear"));
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "accepted";
}

void ExpectPatchTest(vtkPolyData* mesh, const std::string& name)
{
  for (const auto constant :
    { pemesh::ProjectionConstant::BoundaryMean, pemesh::ProjectionConstant::VertexMean })
  {
    VirtualElementOptions options;
    options.Constant = constant;
    const VirtualElementResult result = SolveElliptic(mesh, *FindTestProblem("linear"), options);
    const double allowed =
      std::max(1.0e-10, 100.0 * std::numeric_limits<double>::epsilon() * result.ConditionNumber);
    EXPECT_LT(result.RelativeErrorEnergy, allowed) << name;
    EXPECT_LT(result.RelativeErrorInf, allowed) << name;
    EXPECT_LT(result.RelativeErrorL2, allowed) << name;
    EXPECT_LT(result.RelativeErrorH1, allowed) << name;
  }
}

// An independent program's answers, see Testing/Data/README.md.
TEST(VirtualElementMethod, KnownAnswersOfPublishedMeshes)
{
  const auto table =
    pemesh::ReadCsvFile(std::filesystem::path(PEMESH_TEST_DATA) / "reference_vem_k1.csv");
  ASSERT_EQ(table->GetNumberOfRows(), 80);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return std::string(table->GetValueByName(row, column).ToString()); };
    const auto number = [&](const char* column)
    { return table->GetValueByName(row, column).ToDouble(); };
    SCOPED_TRACE(text("mesh") + " " + text("problem"));
    const auto mesh = pemesh::ReadMesh(Meshes / text("mesh"));
    EXPECT_EQ(mesh->GetNumberOfPolys(), number("elements"));
    EXPECT_EQ(mesh->GetNumberOfPoints(), number("vertices"));
    const VirtualElementResult result = SolveElliptic(mesh, *FindTestProblem(text("problem")));
    const auto expect = [&](double value, const char* column, double tolerance)
    { EXPECT_NEAR(value / number(column), 1.0, tolerance) << column; };
    EXPECT_EQ(result.DegreesOfFreedom, number("dofs"));
    EXPECT_EQ(result.ConditionIsEstimate, number("dofs") < 500 ? 0.0 : 1.0);
    EXPECT_EQ(result.Iterative, 0.0);
    expect(result.MeshSize, "mesh_size", 1.0e-9);
    expect(result.RelativeErrorEnergy, "epsilon_S", 1.0e-8);
    expect(result.RelativeErrorInf, "epsilon_inf", 1.0e-8);
    expect(result.RelativeErrorL2, "relative_L2", 1.0e-8);
    expect(result.RelativeErrorH1, "relative_H1_seminorm", 1.0e-8);
    if (result.ConditionIsEstimate == 0.0)
    {
      expect(result.ConditionNumber, "kappa1_exact", 1.0e-6);
    }
    else
    {
      EXPECT_LE(result.ConditionNumber, number("kappa1_exact") * (1.0 + 1.0e-6));
      EXPECT_GE(result.ConditionNumber, number("kappa1_exact") * 0.95);
    }
  }
}

TEST(VirtualElementMethod, PatchTestOnPublishedMeshes)
{
  int count = 0;
  for (const char* folder : { "vem_quality_2d", "exercise_1_2" })
  {
    for (const auto& entry : std::filesystem::directory_iterator(Meshes / folder))
    {
      ExpectPatchTest(pemesh::ReadMesh(entry.path()), entry.path().filename().string());
      ++count;
    }
  }
  EXPECT_EQ(count, 28);
}

TEST(VirtualElementMethod, PatchTestOnDistortedMeshes)
{
  ExpectPatchTest(pemesh::MakeTriangles(12, 0.6), "triangles");
  ExpectPatchTest(pemesh::MakeLShapes(12, 0.6), "L-shapes");
  ExpectPatchTest(pemesh::MakeChessboard(6), "chessboard");
  for (const double t : { 0.0, 0.5, 0.9, 0.99 })
  {
    ExpectPatchTest(pemesh::MakeMaze(t), "maze at " + std::to_string(t));
  }
}

// u is in H2 and the meshes are regular: order 2 in L2, 1 in H1 (Beirao da Veiga et al. 2013).
TEST(VirtualElementMethod, ConvergesAtTheRatesOfTheTheory)
{
  const auto makers = { +[](int n) { return pemesh::MakeLShapes(n, 0.2); },
    +[](int n) { return pemesh::MakeChessboard(n / 2); } };
  for (const auto& make : makers)
  {
    for (const char* name : { "trigonometric", "franke" })
    {
      const VirtualElementResult coarse = SolveElliptic(make(32), *FindTestProblem(name));
      const VirtualElementResult fine = SolveElliptic(make(64), *FindTestProblem(name));
      EXPECT_NEAR(std::log2(coarse.RelativeErrorL2 / fine.RelativeErrorL2), 2.0, 0.15) << name;
      EXPECT_NEAR(std::log2(coarse.RelativeErrorH1 / fine.RelativeErrorH1), 1.0, 0.15) << name;
    }
  }
}

// x^3 + y^3: a linear source, whose integrals against hat functions are known.
void EvaluateCubic(const pemesh::PointBlock& points, pemesh::TestProblemBlock& values)
{
  for (std::size_t i = 0; i < pemesh::PointBlockSize; ++i)
  {
    const double x = points.X[i];
    const double y = points.Y[i];
    values.Solution[i] = x * x * x + y * y * y;
    values.GradientX[i] = 3.0 * x * x;
    values.GradientY[i] = 3.0 * y * y;
    values.Source[i] = -6.0 * (x + y);
  }
}

// The linear finite element method, dense. f is linear on each triangle.
Eigen::VectorXd SolveWithFiniteElements(vtkPolyData* mesh, bool meanOnly)
{
  const Eigen::Index n = mesh->GetNumberOfPoints();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    Eigen::Matrix<double, 3, 3> corners;
    Eigen::Vector3d source;
    for (int i = 0; i < 3; ++i)
    {
      const double* p = mesh->GetPoint(ids[i]);
      corners.row(i) << 1.0, p[0], p[1];
      source[i] = -6.0 * (p[0] + p[1]);
    }
    const double area = 0.5 * corners.determinant();
    const Eigen::Matrix<double, 2, 3> gradients = corners.inverse().bottomRows<2>();
    const Eigen::Matrix3d local = area * gradients.transpose() * gradients;
    for (int i = 0; i < 3; ++i)
    {
      load[ids[i]] +=
        meanOnly ? area * source.sum() / 9.0 : area / 12.0 * (source.sum() + source[i]);
      for (int j = 0; j < 3; ++j)
      {
        matrix(ids[i], ids[j]) += local(i, j);
      }
    }
  }
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const double* p = mesh->GetPoint(i);
    if (p[0] == 0.0 || p[0] == 1.0 || p[1] == 0.0 || p[1] == 1.0)
    {
      matrix.row(i).setZero();
      matrix(i, i) = 1.0;
      load[i] = std::pow(p[0], 3) + std::pow(p[1], 3);
    }
  }
  return matrix.partialPivLu().solve(load);
}

TEST(VirtualElementMethod, OnTrianglesItIsTheFiniteElementMethod)
{
  const pemesh::TestProblem cubic = { "cubic", "Cubic", "x^3 + y^3", EvaluateCubic };
  const auto mesh = pemesh::MakeTriangles(7, 0.5);
  for (const bool meanOnly : { true, false })
  {
    VirtualElementOptions options;
    options.Load =
      meanOnly ? pemesh::LoadProjection::LowerDegree : pemesh::LoadProjection::Gradient;
    const VirtualElementResult result = SolveElliptic(mesh, cubic, options);
    const Eigen::VectorXd expected = SolveWithFiniteElements(mesh, meanOnly);
    const Eigen::Map<const Eigen::VectorXd> found(
      result.Solution.data(), static_cast<Eigen::Index>(result.Solution.size()));
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1.0e-13) << meanOnly;
  }
}

TEST(VirtualElementMethod, TheOptionsMatterOnPolygons)
{
  const auto mesh = pemesh::ReadMesh(Meshes / "vem_quality_2d/Jenga2.off");
  const pemesh::TestProblem& problem = *FindTestProblem("franke");
  VirtualElementOptions vertex;
  vertex.Constant = pemesh::ProjectionConstant::VertexMean;
  VirtualElementOptions full;
  full.Load = pemesh::LoadProjection::Gradient;
  const double standard = SolveElliptic(mesh, problem).RelativeErrorL2;
  EXPECT_GT(std::abs(SolveElliptic(mesh, problem, vertex).RelativeErrorL2 / standard - 1), 1.0e-4);
  EXPECT_GT(std::abs(SolveElliptic(mesh, problem, full).RelativeErrorL2 / standard - 1), 1.0e-4);
}

TEST(VirtualElementMethod, SameBitsWithAnyNumberOfThreads)
{
  for (const int order : { 1, 2, 3 })
  {
    const auto mesh = pemesh::MakeLShapes(order == 1 ? 40 : 16, 0.5);
    VirtualElementOptions options;
    options.Order = order;
    options.Details = order > 1;
    std::vector<VirtualElementResult> results;
    for (const int threads : { 1, 2, 5 })
    {
      pemesh::SetNumberOfThreads(threads);
      results.push_back(SolveElliptic(mesh, *FindTestProblem("franke"), options));
    }
    pemesh::SetNumberOfThreads(0);
    EXPECT_EQ(results[0].ConditionIsEstimate, 1.0);
    for (const VirtualElementResult& result : results)
    {
      EXPECT_EQ(result.Solution, results[0].Solution);
      EXPECT_EQ(result.ErrorL2, results[0].ErrorL2);
      for (const auto& performance : pemesh::VirtualElementPerformances())
      {
        if (!performance.Measured && (options.Details || !performance.Detail))
        {
          EXPECT_EQ(result.*performance.Value, results[0].*performance.Value)
            << performance.Name << ", order " << order;
        }
      }
    }
  }
}

TEST(VirtualElementMethod, TheNumberingOfTheVerticesDoesNotMatter)
{
  const auto mesh = pemesh::MakeMaze(0.6);
  std::vector<pemesh::Point2> points;
  std::vector<pemesh::IdList> elements;
  const vtkIdType last = mesh->GetNumberOfPoints() - 1;
  for (vtkIdType id = last; id >= 0; --id)
  {
    points.push_back({ mesh->GetPoint(id)[0], mesh->GetPoint(id)[1] });
  }
  for (vtkIdType cell = 1; cell >= 0; --cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    elements.emplace_back();
    for (vtkIdType i = 0; i < size; ++i)
    {
      elements.back().push_back(last - ids[(i + 3) % size]);
    }
  }
  const pemesh::TestProblem& problem = *FindTestProblem("franke");
  const VirtualElementResult a = SolveElliptic(mesh, problem);
  const VirtualElementResult b = SolveElliptic(MakeMesh(points, elements), problem);
  EXPECT_NEAR(a.ConditionNumber / b.ConditionNumber, 1.0, 1.0e-10);
  EXPECT_NEAR(a.RelativeErrorL2 / b.RelativeErrorL2, 1.0, 1.0e-10);
  for (std::size_t i = 0; i < a.Solution.size(); ++i)
  {
    EXPECT_NEAR(a.Solution[i], b.Solution[a.Solution.size() - 1 - i],
      1.0e-11); // f is integrated over other triangles
  }
}

// K of the elements, added up in a dense matrix.
Eigen::MatrixXd AssembleDense(vtkPolyData* mesh)
{
  const Eigen::Index n = mesh->GetNumberOfPoints();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  pemesh::VirtualElement element;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    std::vector<pemesh::Point2> vertices;
    for (vtkIdType i = 0; i < size; ++i)
    {
      vertices.push_back({ mesh->GetPoint(ids[i])[0], mesh->GetPoint(ids[i])[1] });
    }
    element.Set(vertices, pemesh::ProjectionConstant::BoundaryMean);
    std::vector<double> packed(static_cast<std::size_t>(size * (size + 1) / 2));
    element.GetStiffness(packed);
    std::size_t slot = 0;
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (vtkIdType j = 0; j <= i; ++j, ++slot)
      {
        matrix(ids[i], ids[j]) += packed[slot];
        matrix(ids[j], ids[i]) += i == j ? 0.0 : packed[slot];
      }
    }
  }
  return matrix;
}

TEST(VirtualElementMethod, EnergiesAndConditionNumbersAreThoseOfTheDenseMatrix)
{
  const auto mesh = pemesh::MakeLShapes(14, 0.4);
  const Eigen::MatrixXd stiffness = AssembleDense(mesh);
  VirtualElementOptions options;
  options.Details = true;
  const VirtualElementResult result = SolveElliptic(mesh, *FindTestProblem("franke"), options);
  const Eigen::Index n = stiffness.rows();
  const Eigen::Map<const Eigen::VectorXd> truth(result.GroundTruth.data(), n);
  const Eigen::VectorXd error =
    truth - Eigen::Map<const Eigen::VectorXd>(result.Solution.data(), n);
  const double energy = std::sqrt(error.dot(stiffness * error) / truth.dot(stiffness * truth));
  EXPECT_NEAR(result.RelativeErrorEnergy / energy, 1.0, 1.0e-10);
  std::vector<Eigen::Index> inside;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const double* p = mesh->GetPoint(i);
    if (p[0] > 0.0 && p[0] < 1.0 && p[1] > 0.0 && p[1] < 1.0)
    {
      inside.push_back(i);
    }
  }
  const Eigen::MatrixXd interior = stiffness(inside, inside);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(interior);
  const double kappa2 = spectrum.eigenvalues().maxCoeff() / spectrum.eigenvalues().minCoeff();
  const auto norm = [](const Eigen::MatrixXd& m)
  { return m.cwiseAbs().colwise().sum().maxCoeff(); };
  EXPECT_NEAR(result.ConditionNumber / (norm(interior) * norm(interior.inverse())), 1.0, 1.0e-9);
  EXPECT_NEAR(result.SpectralConditionNumber / kappa2, 1.0, 1.0e-6);
  EXPECT_EQ(result.Nonzeros, static_cast<double>((interior.array() != 0.0).count()));
}

TEST(VirtualElementMethod, VerticesThatNoElementUsesDoNoHarm)
{
  const VirtualElementResult result =
    SolveElliptic(pemesh::MakeChessboard(4), *FindTestProblem("polynomial"));
  EXPECT_EQ(result.Solution.size(), 81u);
  EXPECT_EQ(result.DegreesOfFreedom, 41.0); // 49 vertices inside, 8 of them unused
  EXPECT_THAT(result.Solution,
    testing::Each(testing::Truly([](double value) { return std::isfinite(value); })));
}

TEST(VirtualElementMethod, AnyPolygonalDomainWillDo)
{
  // The square turned, shrunk and moved; the patch test does not notice.
  auto mesh = pemesh::MakeLShapes(8);
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    const double* p = mesh->GetPoint(id);
    mesh->GetPoints()->SetPoint(
      id, 5.0 + 0.01 * (0.6 * p[0] - 0.8 * p[1]), -3.0 + 0.01 * (0.8 * p[0] + 0.6 * p[1]), 0.0);
  }
  ExpectPatchTest(mesh, "turned");
}

TEST(VirtualElementMethod, WhatCannotBeSolvedIsRefused)
{
  EXPECT_THAT(WhyRefused(MakeMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2, 3 } })),
    testing::HasSubstr("no vertex inside"));
  EXPECT_THAT(WhyRefused(nullptr), testing::HasSubstr("no polygons"));
}

TEST(VirtualElementMethod, RelativeErrorsOfAFunctionThatVanishesAreUndefined)
{
  // sin 2 pi x sin 2 pi y is zero at all vertices of this mesh, not between them.
  const VirtualElementResult result = SolveElliptic(
    pemesh::ReadMesh(Meshes / "vem_quality_2d/Jenga0.off"), *FindTestProblem("trigonometric"));
  EXPECT_TRUE(std::isnan(result.RelativeErrorEnergy));
  EXPECT_TRUE(std::isnan(result.RelativeErrorInf));
  EXPECT_NEAR(result.RelativeErrorL2, 1.0, 0.2);
}

TEST(VirtualElementMethod, SliversBeyondDoublePrecisionEndInANumberOrASentence)
{
  for (const double t : { 0.999999, 1.0 - 1.0e-9, 1.0 - 1.0e-13 })
  {
    try
    {
      const VirtualElementResult result =
        SolveElliptic(pemesh::MakeMaze(t), *FindTestProblem("franke"));
      EXPECT_GT(result.ConditionNumber, 1.0);
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_FALSE(std::string(error.what()).empty());
    }
  }
}

} // namespace

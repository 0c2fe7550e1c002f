// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EllipticProblem.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"
#include "VirtualElementTestMeshes.h"

#include "MeshConversion.h"
#include "Tessellations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using pemesh::EllipticProblem;
using pemesh::FindTestProblem;
using pemesh::SolveElliptic;
using pemesh::VirtualElementOptions;
using pemesh::VirtualElementResult;
using Mesh = vtkSmartPointer<vtkPolyData>;

Mesh MakeTessellated(const char* name, double cells)
{
  const pemesh::Tessellation& entry =
    pemesh::Tessellations()[static_cast<std::size_t>(pemesh::FindTessellation(name))];
  pemesh::TessellationInput input;
  input.Values = pemesh::ParameterValues(entry.Parameters);
  input.Values.Set("cells", cells);
  const pemesh::TessellationResult made = pemesh::MakeTessellation(entry, input);
  EXPECT_EQ(made.Status, pemesh::TessellationStatus::Done) << made.Message;
  auto mesh = Mesh::New();
  pemesh::SetPolygonMesh(mesh, made.Mesh);
  return mesh;
}

const char* const PatchProblems[] = { "constant", "linear", "quadratic", "cubic", "quartic",
  "quintic", "sextic" };

VirtualElementOptions OrderOptions(int order)
{
  VirtualElementOptions options;
  options.Order = order;
  return options;
}

void ExpectExact(const VirtualElementResult& result, const std::string& name)
{
  const double allowed =
    std::max(1.0e-9, 100.0 * std::numeric_limits<double>::epsilon() * result.ConditionNumber);
  EXPECT_LT(result.ConditionNumber, 1.0e8) << name; // so that allowed means something
  EXPECT_LT(result.RelativeErrorInf, allowed) << name;
  EXPECT_LT(result.RelativeErrorL2, allowed) << name;
  EXPECT_LT(result.RelativeErrorH1, allowed) << name;
  EXPECT_LT(result.RelativeErrorEnergy, allowed) << name;
  EXPECT_LT(result.ProjectedErrorL2, allowed) << name;
}

struct NamedMesh
{
  const char* Name;
  Mesh Polygons;
};

std::vector<NamedMesh> PatchMeshes()
{
  return { { "triangles", pemesh::MakeTriangles(3, 0.4) },
    { "L-shapes", pemesh::MakeLShapes(4, 0.5) }, { "chessboard", pemesh::MakeChessboard(2) },
    { "maze", pemesh::MakeMaze(0.5) }, { "voronoi", MakeTessellated("voronoi", 25) },
    { "agglomerates", MakeTessellated("random-agglomerates", 12) } };
}

TEST(HighOrder, ConstantsAreReproduced)
{
  for (const NamedMesh& mesh : PatchMeshes())
  {
    for (int order = 1; order <= 6; ++order)
    {
      const auto result =
        SolveElliptic(mesh.Polygons, *FindTestProblem("constant"), OrderOptions(order));
      EXPECT_LT(result.AbsoluteErrorL2, 1.0e-9) << mesh.Name << " order " << order;
      EXPECT_LT(result.AbsoluteErrorH1, 1.0e-8) << mesh.Name << " order " << order;
    }
  }
}

TEST(HighOrder, PolynomialsOfTheOrderAreReproduced)
{
  for (const NamedMesh& mesh : PatchMeshes())
  {
    for (int order = 1; order <= 6; ++order)
    {
      ExpectExact(
        SolveElliptic(mesh.Polygons, *FindTestProblem(PatchProblems[order]), OrderOptions(order)),
        mesh.Name + std::string(" order ") + std::to_string(order));
    }
  }
}

TEST(HighOrder, PolynomialsOfAHigherDegreeAreNot)
{
  const Mesh mesh = pemesh::MakeLShapes(4, 0.5);
  for (int order = 1; order < 6; ++order)
  {
    const VirtualElementResult result =
      SolveElliptic(mesh, *FindTestProblem(PatchProblems[order + 1]), OrderOptions(order));
    EXPECT_GT(result.RelativeErrorL2, 1.0e-7) << order;
  }
}

TEST(HighOrder, EveryBasisAndStabilisationPassesThePatchTest)
{
  const Mesh mesh = pemesh::MakeLShapes(4, 0.5);
  for (int order = 1; order <= 4; ++order)
  {
    VirtualElementOptions options = OrderOptions(order);
    const EllipticProblem problem = *FindTestProblem(PatchProblems[order]);
    for (const pemesh::BasisRule& basis : pemesh::BasisRules())
    {
      options.Basis = &basis;
      ExpectExact(SolveElliptic(mesh, problem, options), basis.Name);
    }
    options = OrderOptions(order);
    for (const pemesh::StabilisationRule& rule : pemesh::StabilisationRules())
    {
      options.Stabilisation = &rule;
      ExpectExact(SolveElliptic(mesh, problem, options), rule.Name);
    }
    options = OrderOptions(order);
    for (const auto& load : pemesh::LoadProjections())
    {
      options.Load = load.Choice;
      if (order > 2 && load.Choice == pemesh::LoadProjection::Gradient)
      {
        EXPECT_THROW(SolveElliptic(mesh, problem, options), std::runtime_error);
        continue;
      }
      ExpectExact(SolveElliptic(mesh, problem, options), load.Name);
    }
  }
}

// With f against the same projection as the reaction's test functions the patch test holds for
// any coefficients that the quadrature integrates exactly.
TEST(HighOrder, PolynomialsAreReproducedWithVaryingCoefficients)
{
  for (const Mesh& mesh : { pemesh::MakeLShapes(4, 0.5), pemesh::MakeTriangles(3, 0.4) })
  {
    for (int order = 1; order <= 4; ++order)
    {
      VirtualElementOptions options = OrderOptions(order);
      options.Load = pemesh::LoadProjection::SameDegree;
      pemesh::ProblemFormulas formulas;
      formulas.Reaction = "2+x*y";
      const auto* solution = FindTestProblem(PatchProblems[order]);
      ExpectExact(SolveElliptic(mesh, EllipticProblem(formulas, solution), options), "reaction");
      formulas.AdvectionX = "1+y";
      formulas.AdvectionY = "-x";
      ExpectExact(SolveElliptic(mesh, EllipticProblem(formulas, solution), options), "advection");
    }
  }
}

TEST(HighOrder, NeumannDataAreHeard)
{
  for (int order = 1; order <= 4; ++order)
  {
    pemesh::ProblemFormulas formulas;
    formulas.Neumann = "x+y-1.2"; // two sides, but for their ends
    formulas.Diffusion = "3";
    const EllipticProblem problem(formulas, FindTestProblem(PatchProblems[order]));
    const Mesh mesh = pemesh::MakeLShapes(4, 0.5);
    const VirtualElementResult result = SolveElliptic(mesh, problem, OrderOptions(order));
    ExpectExact(result, std::to_string(order));
    EXPECT_GT(result.DegreesOfFreedom,
      SolveElliptic(mesh, *FindTestProblem("linear"), OrderOptions(order)).DegreesOfFreedom);
  }
}

// Data on the boundary of both kinds, so that the fluxes must be those of the tensor, too.
TEST(HighOrder, PolynomialsAreReproducedWithATensor)
{
  for (int order = 1; order <= 4; ++order)
  {
    pemesh::ProblemFormulas formulas;
    formulas.Neumann = "x+y-1.2";
    formulas.Diffusion = "3";
    formulas.DiffusionXY = "-1.5";
    formulas.DiffusionYY = "1";
    formulas.Solution = order == 1 ? "1+x+2*y" : FindTestProblem(PatchProblems[order])->Formula;
    for (const char* stabilisation : { "dofi-dofi", "D-recipe", "none" })
    {
      VirtualElementOptions options = OrderOptions(order);
      options.Stabilisation = FindByName(pemesh::StabilisationRules(), stabilisation);
      ExpectExact(SolveElliptic(pemesh::MakeLShapes(4, 0.5), EllipticProblem(formulas), options),
        stabilisation);
    }
  }
}

TEST(HighOrder, ATensorMustBePositiveDefiniteAndItsSolutionAFormula)
{
  pemesh::ProblemFormulas formulas;
  formulas.Diffusion = "1";
  formulas.DiffusionXY = "2";
  const EllipticProblem problem(formulas, FindTestProblem("quadratic"));
  EXPECT_THROW(SolveElliptic(pemesh::MakeLShapes(4), problem), std::runtime_error);
  EXPECT_THROW(EllipticProblem(formulas, FindTestProblem("franke")), std::runtime_error);
}

// A tensor times the unit matrix is no tensor.
TEST(HighOrder, ATensorOfUnitsIsTheScalar)
{
  pemesh::ProblemFormulas scalar;
  scalar.Diffusion = "1+x*y";
  pemesh::ProblemFormulas tensor = scalar;
  tensor.DiffusionXY = "0";
  tensor.DiffusionYY = "1+x*y";
  const auto mesh = pemesh::MakeLShapes(6, 0.4);
  const auto solve = [&](const pemesh::ProblemFormulas& formulas)
  {
    return SolveElliptic(
      mesh, EllipticProblem(formulas, FindTestProblem("cosine")), OrderOptions(2));
  };
  const VirtualElementResult a = solve(scalar);
  const VirtualElementResult b = solve(tensor);
  for (std::size_t i = 0; i < a.Solution.size(); ++i)
  {
    EXPECT_NEAR(a.Solution[i], b.Solution[i], 1.0e-12);
  }
}

struct Family
{
  const char* Name;
  Mesh Coarse;
  Mesh Fine;
};

std::vector<Family> Families(int order)
{
  const int n = order < 3 ? 16 : 8;
  return { { "triangles", pemesh::MakeTriangles(n), pemesh::MakeTriangles(2 * n) },
    { "L-shapes", pemesh::MakeLShapes(n, 0.2), pemesh::MakeLShapes(2 * n, 0.2) },
    { "chessboard", pemesh::MakeChessboard(n / 2), pemesh::MakeChessboard(n) },
    { "hexagons", MakeTessellated("hexagons", n), MakeTessellated("hexagons", 2 * n) } };
}

double ObservedOrder(const VirtualElementResult& coarse, const VirtualElementResult& fine,
  double VirtualElementResult::*error)
{
  return std::log(coarse.*error / fine.*error) / std::log(coarse.MeshSize / fine.MeshSize);
}

// u is smooth and the meshes are regular: order k + 1 in L2, k in H1 (Beirao da Veiga et al. 2013).
TEST(HighOrder, ConvergesAtTheRatesOfTheTheory)
{
  const EllipticProblem problem = *FindTestProblem("trigonometric");
  for (int order = 1; order <= 4; ++order)
  {
    for (const Family& family : Families(order))
    {
      const auto coarse = SolveElliptic(family.Coarse, problem, OrderOptions(order));
      const auto fine = SolveElliptic(family.Fine, problem, OrderOptions(order));
      EXPECT_NEAR(
        ObservedOrder(coarse, fine, &VirtualElementResult::RelativeErrorL2), order + 1, 0.2)
        << family.Name << " order " << order;
      EXPECT_NEAR(ObservedOrder(coarse, fine, &VirtualElementResult::RelativeErrorH1), order, 0.2)
        << family.Name << " order " << order;
    }
  }
}

TEST(HighOrder, ConvergesWithVaryingCoefficients)
{
  for (const char* name : { "reaction", "anisotropic" })
  {
    const EllipticProblem problem = *FindTestProblem(name);
    for (int order = 1; order <= 3; ++order)
    {
      const auto coarse = SolveElliptic(pemesh::MakeLShapes(8), problem, OrderOptions(order));
      const auto fine = SolveElliptic(pemesh::MakeLShapes(16), problem, OrderOptions(order));
      EXPECT_NEAR(
        ObservedOrder(coarse, fine, &VirtualElementResult::RelativeErrorL2), order + 1, 0.25)
        << name << order;
      EXPECT_NEAR(ObservedOrder(coarse, fine, &VirtualElementResult::RelativeErrorH1), order, 0.2)
        << name << order;
    }
  }
}

// Squares flattened to slivers of 1 : 2000, as in the study of Berrone, Teora, Vicini.
TEST(HighOrder, SliversNeedAStableBasis)
{
  Mesh mesh = pemesh::MakeLShapes(8, 0.3);
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    const double* p = mesh->GetPoint(id);
    const double row = std::round(p[1] * 8);
    // Rows 3 to 5 are squeezed onto a line; the others take their room.
    const double y = row <= 2 ? p[1] : row >= 6 ? p[1] : 0.375 + 5.0e-4 * (p[1] - 0.375);
    mesh->GetPoints()->SetPoint(id, p[0], y, 0.0);
  }
  VirtualElementOptions options = OrderOptions(3);
  options.Details = true;
  std::map<std::string, VirtualElementResult> results;
  for (const pemesh::BasisRule& basis : pemesh::BasisRules())
  {
    options.Basis = &basis;
    results[basis.Name] = SolveElliptic(mesh, *FindTestProblem("trigonometric"), options);
  }
  EXPECT_NEAR(
    results["orthonormal"].RelativeErrorL2 / results["inertia"].RelativeErrorL2, 1.0, 0.1);
  EXPECT_LT(results["orthonormal"].RelativeErrorL2, 0.05);
  EXPECT_GT(results["monomial"].WorstProjectionCondition,
    1.0e6 * results["orthonormal"].WorstProjectionCondition);
}

TEST(HighOrder, TheErrorsOfTheElementsAddUp)
{
  VirtualElementOptions options = OrderOptions(2);
  options.Details = true;
  const auto result =
    SolveElliptic(pemesh::MakeLShapes(6, 0.4), *FindTestProblem("franke"), options);
  double l2 = 0.0;
  double h1 = 0.0;
  ASSERT_EQ(result.ErrorL2.size(), 18u);
  for (std::size_t i = 0; i < result.ErrorL2.size(); ++i)
  {
    l2 += result.ErrorL2[i] * result.ErrorL2[i];
    h1 += result.ErrorH1[i] * result.ErrorH1[i];
  }
  EXPECT_NEAR(std::sqrt(l2) / result.AbsoluteErrorL2, 1.0, 1.0e-13);
  EXPECT_NEAR(std::sqrt(h1) / result.AbsoluteErrorH1, 1.0, 1.0e-13);
  EXPECT_LT(result.WorstGradientResidual, 1.0e-12);
  EXPECT_LT(result.WorstValueResidual, 1.0e-12);
  EXPECT_LT(result.WorstStabilisationResidual, 1.0e-12);
  EXPECT_EQ(result.WorstProjectionCondition,
    *std::max_element(result.ProjectionCondition.begin(), result.ProjectionCondition.end()));
}

// On squares of the side a, with the diameter h = a sqrt(2), the matrix G of the closed form of
// order 1 is diag(1, 1/2, 1/2), whatever basis was asked for: that is what is used.
TEST(HighOrder, TheChecksOfTheLowestOrderAreOfTheMatricesThatAreUsed)
{
  std::vector<pemesh::Point2> points;
  std::vector<pemesh::IdList> elements;
  for (int i = 0; i < 16; ++i)
  {
    points.push_back({ (i % 4) / 3.0, (i / 4) / 3.0 });
    if (i % 4 < 3 && i < 12)
    {
      elements.push_back({ i, i + 1, i + 5, i + 4 });
    }
  }
  for (const auto& constant : pemesh::ProjectionConstants())
  {
    VirtualElementOptions options = OrderOptions(1);
    options.Details = true;
    options.Constant = constant.Choice;
    const auto result =
      SolveElliptic(pemesh::MakeMesh(points, elements), *FindTestProblem("franke"), options);
    EXPECT_NEAR(result.WorstProjectionCondition, 2.0, 1.0e-12);
    const auto other =
      SolveElliptic(pemesh::MakeLShapes(6, 0.4), *FindTestProblem("franke"), options);
    for (const auto* checks : { &result, &other })
    {
      EXPECT_LT(checks->WorstGradientResidual, 1.0e-14);
      EXPECT_LT(checks->WorstValueResidual, 1.0e-14);
      EXPECT_LT(checks->WorstStabilisationResidual, 1.0e-14);
    }
  }
}

TEST(HighOrder, DirectAndIterativeSolversAgree)
{
  for (const char* name : { "franke", "reaction" })
  {
    VirtualElementOptions options = OrderOptions(2);
    options.Solver = pemesh::SolverKind::Direct;
    const Mesh mesh = pemesh::MakeLShapes(10, 0.3);
    const auto direct = SolveElliptic(mesh, *FindTestProblem(name), options);
    options.Solver = pemesh::SolverKind::Iterative;
    const auto iterative = SolveElliptic(mesh, *FindTestProblem(name), options);
    for (std::size_t i = 0; i < direct.Solution.size(); ++i)
    {
      EXPECT_NEAR(direct.Solution[i], iterative.Solution[i], 1.0e-9);
    }
    EXPECT_TRUE(std::isnan(iterative.ConditionNumber));
    EXPECT_TRUE(std::isnan(iterative.ConditionIsEstimate));
    EXPECT_EQ(iterative.Iterative, 1.0);
    EXPECT_EQ(direct.Iterative, 0.0);
    EXPECT_GT(direct.ConditionNumber, 1.0);
  }
}

// The unit square without its right lower quarter, in squares of the side 1/(2 n).
Mesh MakeCornerMesh(int n)
{
  std::vector<pemesh::Point2> points;
  std::map<std::pair<int, int>, vtkIdType> ids;
  const auto point = [&](int i, int j)
  {
    const auto [entry, isNew] = ids.try_emplace({ i, j }, static_cast<vtkIdType>(points.size()));
    if (isNew)
    {
      points.push_back({ 0.5 * i / n, 0.5 * j / n });
    }
    return entry->second;
  };
  std::vector<pemesh::IdList> elements;
  for (int j = 0; j < 2 * n; ++j)
  {
    for (int i = 0; i < (j < n ? n : 2 * n); ++i)
    {
      elements.push_back({ point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) });
    }
  }
  return pemesh::MakeMesh(points, elements);
}

// The solution is in H^s for s < 5/3 only: the H1 error falls like h^(2/3) at every order, that in
// L2 like h^(4/3) (P. Grisvard, Elliptic problems in nonsmooth domains, 1985, chapter 8).
TEST(HighOrder, AReentrantCornerReducesTheRate)
{
  for (const int order : { 1, 2, 3 })
  {
    const auto coarse =
      SolveElliptic(MakeCornerMesh(8), *FindTestProblem("l-shape"), OrderOptions(order));
    const auto fine =
      SolveElliptic(MakeCornerMesh(16), *FindTestProblem("l-shape"), OrderOptions(order));
    EXPECT_NEAR(std::log2(coarse.AbsoluteErrorH1 / fine.AbsoluteErrorH1), 2.0 / 3.0, 0.05) << order;
    EXPECT_NEAR(std::log2(coarse.AbsoluteErrorL2 / fine.AbsoluteErrorL2), 4.0 / 3.0, 0.25) << order;
  }
}

TEST(HighOrder, WithoutAFactorLanczosGivesTheConditionNumber)
{
  VirtualElementOptions options = OrderOptions(1);
  options.Details = true;
  const auto mesh = MakeTessellated("voronoi", 600);
  const VirtualElementResult direct = SolveElliptic(mesh, *FindTestProblem("franke"), options);
  options.Solver = pemesh::SolverKind::Iterative;
  const VirtualElementResult iterative = SolveElliptic(mesh, *FindTestProblem("franke"), options);
  const double ratio = iterative.SpectralConditionNumber / direct.SpectralConditionNumber;
  EXPECT_LT(ratio, 1.0 + 1.0e-4);
  EXPECT_GT(ratio, 0.98);
}

// Two ways that share nothing but the matrix: restarted Lanczos with the factor, and the matrix
// that conjugate gradients make without one.
TEST(HighOrder, ConditionNumbersOfHigherOrdersAgreeWithConjugateGradients)
{
  for (const int order : { 2, 3 })
  {
    VirtualElementOptions options = OrderOptions(order);
    options.Details = true;
    const auto mesh = MakeTessellated("voronoi", 60);
    const VirtualElementResult result = SolveElliptic(mesh, *FindTestProblem("franke"), options);
    options.Solver = pemesh::SolverKind::Iterative;
    const VirtualElementResult lanczos = SolveElliptic(mesh, *FindTestProblem("franke"), options);
    EXPECT_NEAR(lanczos.SpectralConditionNumber / result.SpectralConditionNumber, 1.0, 0.02);
  }
}

} // namespace

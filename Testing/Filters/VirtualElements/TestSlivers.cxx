// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Bases of polynomials on very flat elements.
 */
#include "EllipticProblem.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"
#include "VirtualElementTestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

// A square turned by 0.6, in n x n squares with slivers of the given height between their rows.
vtkSmartPointer<vtkPolyData> MakeTurnedSlivers(int n, double height)
{
  std::vector<double> levels{ 0.0 };
  for (int row = 1; row <= n; ++row)
  {
    levels.push_back(static_cast<double>(row) / n);
    if (row < n && height > 0.0)
    {
      levels.push_back((row + height) / n);
    }
  }
  std::vector<pemesh::Point2> points;
  std::vector<pemesh::IdList> elements;
  for (std::size_t j = 0; j < levels.size(); ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = static_cast<double>(i) / n;
      points.push_back({ std::cos(0.6) * x - std::sin(0.6) * levels[j],
        std::sin(0.6) * x + std::cos(0.6) * levels[j] });
      if (i < n && j + 1 < levels.size())
      {
        const vtkIdType a = static_cast<vtkIdType>(j) * (n + 1) + i;
        elements.push_back({ a, a + 1, a + n + 2, a + n + 1 });
      }
    }
  }
  return pemesh::MakeMesh(points, elements);
}

// Slivers that lie askew make scaled monomials of degree 3 nearly dependent: they fail, where the
// error of the stable bases is that of the mesh without slivers.
TEST(Slivers, OnlyStableBasesSolveOnThoseThatLieAskew)
{
  const pemesh::EllipticProblem problem = *pemesh::FindTestProblem("trigonometric");
  pemesh::VirtualElementOptions options;
  options.Order = 3;
  const double plain = SolveElliptic(MakeTurnedSlivers(8, 0.0), problem, options).RelativeErrorL2;
  for (const double height : { 1.0e-4, 1.0e-5, 1.0e-6 })
  {
    const auto mesh = MakeTurnedSlivers(8, height);
    for (const char* basis : { "orthonormal", "inertia" })
    {
      options.Basis = FindByName(pemesh::BasisRules(), basis);
      const auto result = SolveElliptic(mesh, problem, options);
      EXPECT_NEAR(result.RelativeErrorL2 / plain, 1.0, 0.05) << basis << " " << height;
    }
    options.Basis = FindByName(pemesh::BasisRules(), "monomial");
    double error = std::numeric_limits<double>::infinity();
    try
    {
      error = SolveElliptic(mesh, problem, options).RelativeErrorL2;
    }
    catch (const std::runtime_error&)
    {
      continue; // as good as the answer
    }
    EXPECT_GT(error, 100.0 * plain) << height;
  }
}

} // namespace

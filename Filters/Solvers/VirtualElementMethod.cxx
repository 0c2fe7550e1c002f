// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethod.h"

#include "ConditionNumber.h"
#include "TestProblems.h"
#include "VirtualElementMethodErrors.h"
#include "VirtualElementMethodSystem.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr std::array Performances = {
  VirtualElementPerformance{ "condition-number", "Condition number (1-norm)", true, false,
    &VirtualElementResult::ConditionNumber },
  VirtualElementPerformance{ "relative-error-energy", "Relative error, energy norm", true, false,
    &VirtualElementResult::RelativeErrorEnergy },
  VirtualElementPerformance{ "relative-error-inf", "Relative error, maximum norm", true, false,
    &VirtualElementResult::RelativeErrorInf },
  VirtualElementPerformance{ "relative-error-l2", "Relative error, L2 norm", true, false,
    &VirtualElementResult::RelativeErrorL2 },
  VirtualElementPerformance{ "relative-error-h1", "Relative error, H1 seminorm", true, false,
    &VirtualElementResult::RelativeErrorH1 },
  VirtualElementPerformance{
    "dofs", "Degrees of freedom", false, false, &VirtualElementResult::DegreesOfFreedom },
  VirtualElementPerformance{
    "mesh-size", "Mesh size", false, false, &VirtualElementResult::MeshSize },
  VirtualElementPerformance{
    "solve-seconds", "Time to solve (seconds)", true, true, &VirtualElementResult::SolveSeconds },
};

// One step of refinement takes out what the factorisation's rounding left in the residual.
std::vector<double> SolveAndRefine(const VirtualElementSystem& system, const SparseCholesky& factor)
{
  std::vector<double> solution = factor.Solve(system.RightHandSide);
  std::vector<double> residual = Multiply(system.Matrix, solution);
  std::transform(system.RightHandSide.begin(), system.RightHandSide.end(), residual.begin(),
    residual.begin(), std::minus<>());
  const std::vector<double> correction = factor.Solve(residual);
  std::transform(
    solution.begin(), solution.end(), correction.begin(), solution.begin(), std::plus<>());
  if (!std::all_of(
        solution.begin(), solution.end(), [](double value) { return std::isfinite(value); }))
  {
    throw std::runtime_error("The system cannot be solved in double precision: the solution has "
                             "values that are not finite.");
  }
  return solution;
}

std::vector<double> EvaluateSolution(const VirtualElementMesh& mesh, const TestProblem& problem)
{
  std::vector<double> values(mesh.Points.size());
  std::transform(mesh.Points.begin(), mesh.Points.end(), values.begin(),
    [&problem](const Point2& point) { return problem.Solution(point); });
  return values;
}

} // namespace

VirtualElementResult SolvePoisson(
  vtkPolyData* data, const TestProblem& problem, const VirtualElementOptions& options)
{
  const VirtualElementMesh mesh = MakeVirtualElementMesh(data);
  VirtualElementResult result;
  result.GroundTruth = EvaluateSolution(mesh, problem);
  result.Solution = result.GroundTruth; // right on the boundary, overwritten inside
  const VirtualElementParts parts = ComputeElementParts(mesh, problem, options);
  const VirtualElementSystem system = AssembleSystem(mesh, parts, result.GroundTruth);
  if (system.PointOf.empty())
  {
    throw std::runtime_error(
      "The mesh has no vertex inside, so that there is nothing to solve: all of them are on the "
      "boundary, where the solution is given.");
  }
  const auto start = std::chrono::steady_clock::now();
  const SparseCholesky factor(system.Matrix);
  const std::vector<double> inside = SolveAndRefine(system, factor);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    result.Solution[system.PointOf[i]] = inside[i];
  }
  const auto [condition, exact] = ComputeConditionNumber(system.Matrix, factor);
  result.SolveSeconds = seconds.count();
  result.ConditionNumber = condition;
  result.ConditionNumberIsExact = exact;
  result.DegreesOfFreedom = static_cast<double>(system.PointOf.size());
  result.MeshSize = *std::max_element(parts.Diameter.begin(), parts.Diameter.end());
  ComputeErrors(mesh, parts, problem, options, result);
  return result;
}

std::span<const VirtualElementPerformance> VirtualElementPerformances()
{
  return Performances;
}

} // namespace pemesh

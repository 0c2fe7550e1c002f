// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethod.h"

#include "ConditionNumber.h"
#include "ConjugateGradients.h"
#include "EllipticProblem.h"
#include "LinearSolver.h"
#include "SolveReport.h"
#include "SpectralCondition.h"
#include "VirtualElementMethodErrors.h"
#include "VirtualElementMethodSystem.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace pemesh
{

namespace
{

using Result = VirtualElementResult;
using Performance = VirtualElementPerformance;

constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double CgTolerance = 1.0e-8;

// Name, label, logarithmic, measured, detail, value.
constexpr std::array Performances = {
  Performance{ "condition-number", "Condition number (1-norm, moments eliminated)", true, false,
    false, &Result::ConditionNumber },
  Performance{ "condition-is-estimate", "Condition number in the 1-norm is estimated (1: yes)",
    false, false, false, &Result::ConditionIsEstimate },
  Performance{
    "iterative", "Solved by iteration (1: yes)", false, false, false, &Result::Iterative },
  Performance{ "relative-error-energy", "Relative error, energy norm", true, false, false,
    &Result::RelativeErrorEnergy },
  Performance{ "relative-error-inf", "Relative error, maximum norm", true, false, false,
    &Result::RelativeErrorInf },
  Performance{
    "relative-error-l2", "Relative error, L2 norm", true, false, false, &Result::RelativeErrorL2 },
  Performance{ "relative-error-h1", "Relative error, H1 seminorm", true, false, false,
    &Result::RelativeErrorH1 },
  Performance{
    "absolute-error-l2", "Absolute error, L2 norm", true, false, false, &Result::AbsoluteErrorL2 },
  Performance{ "absolute-error-h1", "Absolute error, H1 seminorm", true, false, false,
    &Result::AbsoluteErrorH1 },
  Performance{ "projected-error-l2", "Relative error against the projected solution, L2 norm", true,
    false, false, &Result::ProjectedErrorL2 },
  Performance{ "projected-error-h1", "Relative error against the projected solution, H1 seminorm",
    true, false, false, &Result::ProjectedErrorH1 },
  Performance{ "dofs", "Degrees of freedom", false, false, false, &Result::DegreesOfFreedom },
  Performance{ "mesh-size", "Mesh size", false, false, false, &Result::MeshSize },
  Performance{ "nonzeros", "Entries of the matrix", false, false, false, &Result::Nonzeros },
  Performance{ "condition-number-2", "Condition number (2-norm, moments eliminated)", true, false,
    true, &Result::SpectralConditionNumber },
  Performance{ "projection-condition", "Worst condition number of a projection", true, false, true,
    &Result::WorstProjectionCondition },
  Performance{ "gradient-check", "Worst residual of G = B D", true, false, true,
    &Result::WorstGradientResidual },
  Performance{
    "value-check", "Worst residual of H = C D", true, false, true, &Result::WorstValueResidual },
  Performance{ "stabilisation-check", "Worst stabilisation of a polynomial", true, false, true,
    &Result::WorstStabilisationResidual },
  Performance{ "cg-iterations", "Iterations of conjugate gradients", false, false, true,
    &Result::CgIterations },
  Performance{ "cg-iterations-jacobi", "Iterations of conjugate gradients, Jacobi", false, false,
    true, &Result::CgIterationsJacobi },
  Performance{ "cg-iterations-ic", "Iterations of conjugate gradients, incomplete Cholesky", false,
    false, true, &Result::CgIterationsCholesky },
  Performance{
    "assembly-seconds", "Time to assemble (seconds)", true, true, false, &Result::AssemblySeconds },
  Performance{
    "solve-seconds", "Time to solve (seconds)", true, true, false, &Result::SolveSeconds },
  Performance{
    "memory-megabytes", "Memory (megabytes)", true, true, false, &Result::MemoryMegabytes },
};

constexpr std::array Arrays = {
  VirtualElementArray{ "ErrorL2", "Absolute error, L2 norm", &Result::ErrorL2 },
  VirtualElementArray{ "ErrorH1", "Absolute error, H1 seminorm", &Result::ErrorH1 },
  VirtualElementArray{
    "ProjectionCondition", "Condition number of the projection", &Result::ProjectionCondition },
};

class Stopwatch
{
public:
  double Seconds() const
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - this->Start;
    return seconds.count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

void CheckOptions(const VirtualElementOptions& options)
{
  if (options.Order < 1 || options.Order > LargestOrder)
  {
    throw std::runtime_error("Order " + std::to_string(options.Order) +
      " is not available: the orders are 1 to " + std::to_string(LargestOrder) + ".");
  }
  if (options.Order > 2 && options.Load == LoadProjection::Gradient)
  {
    throw std::runtime_error("The load \"pinabla\" is for orders 1 and 2: from order 3 on gradient "
                             "projections do not keep the moments that f needs.");
  }
}

void CheckDiffusion(const VirtualElementMesh& mesh, const EllipticProblem& problem)
{
  for (vtkIdType id = 0; id < mesh.NumberOfPoints() && !problem.IsPoisson(); ++id)
  {
    const DiffusionTensor kappa = problem.Diffusion(mesh.Points[id]);
    const bool isPositive = kappa.XX > 0.0 &&
      (!problem.HasTensorDiffusion() || kappa.XX * kappa.YY > kappa.XY * kappa.XY);
    if (mesh.Used[id] && !isPositive)
    {
      throw std::runtime_error("The diffusion must be positive (definite), and is not at vertex " +
        std::to_string(id) + " (" + std::to_string(mesh.Points[id].x) + ", " +
        std::to_string(mesh.Points[id].y) + ").");
    }
  }
}

std::vector<double> EvaluateKnown(
  const DegreesOfFreedom& dofs, const EllipticProblem& problem, const std::vector<double>& truth)
{
  std::vector<double> values = truth;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (dofs.Known[i])
    {
      values[i] = problem.BoundaryValue(dofs.Points[i]);
    }
  }
  return values;
}

// Advection as well as diffusion maps constants to zero, on each part of the mesh that hangs
// together by degrees of freedom.
void CheckConstants(const DegreesOfFreedom& dofs)
{
  std::vector<vtkIdType> parent(dofs.Points.size()); // disjoint sets, halving paths
  std::iota(parent.begin(), parent.end(), vtkIdType{ 0 });
  const auto find = [&parent](vtkIdType id)
  {
    while (parent[id] != id)
    {
      id = parent[id] = parent[parent[id]];
    }
    return id;
  };
  const auto elements = static_cast<vtkIdType>(dofs.Offsets.size()) - 1;
  for (vtkIdType element = 0; element < elements; ++element)
  {
    const auto ids = dofs.OfElement(element);
    for (const vtkIdType id : ids)
    {
      const vtkIdType first = find(ids.front());
      parent[find(id)] = first;
    }
  }
  std::vector<char> isFixed(parent.size(), 0);
  for (vtkIdType id = 0; id < dofs.Size(); ++id)
  {
    isFixed[find(id)] = isFixed[find(id)] || dofs.Known[id];
  }
  for (vtkIdType element = 0; element < elements; ++element)
  {
    if (!isFixed[find(dofs.OfElement(element).front())])
    {
      throw std::runtime_error(
        "The solution is given on no part of the boundary of the part of the mesh that holds "
        "element " +
        std::to_string(element) + ", and there is no reaction: it is known only up to a constant.");
    }
  }
}

void CheckSystem(
  const DegreesOfFreedom& dofs, const VirtualElementSystem& system, const EllipticProblem& problem)
{
  if (system.DofOf.empty())
  {
    throw std::runtime_error(dofs.Order == 1
        ? "The mesh has no vertex inside, so that there is nothing to solve: all of them are on "
          "the boundary, where the solution is given."
        : "The mesh has no edge inside, so that there is nothing to solve.");
  }
  if (!problem.HasReaction())
  {
    CheckConstants(dofs);
  }
}

void AddDetails(const VirtualElementSystem& system, const Factorization* factor,
  SolveReport& report, VirtualElementResult& result)
{
  const auto check = [&report] { report.Check(); };
  if (factor)
  {
    result.SpectralConditionNumber = ComputeSpectralConditionNumber(system.Matrix, *factor, check);
  }
  if (!system.Matrix.Symmetric)
  {
    return;
  }
  const int limit = std::max(1000, 4 * system.Matrix.Size());
  const auto run = [&](CgPreconditioner preconditioner, double& iterations)
  {
    ConjugateGradients found = RunConjugateGradients(
      system.Matrix, system.RightHandSide, preconditioner, CgTolerance, limit, check);
    iterations = found.Converged ? found.Iterations : NotKnown;
    return found;
  };
  const ConjugateGradients plain = run(CgPreconditioner::None, result.CgIterations);
  run(CgPreconditioner::Jacobi, result.CgIterationsJacobi);
  run(CgPreconditioner::IncompleteCholesky, result.CgIterationsCholesky);
  if (!factor)
  {
    result.SpectralConditionNumber = LanczosConditionNumber(plain);
  }
}

double PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

VirtualElementResult UndefinedVirtualElementResult()
{
  VirtualElementResult result;
  for (const Performance& performance : Performances)
  {
    result.*performance.Value = NotKnown;
  }
  return result;
}

VirtualElementResult SolveElliptic(vtkPolyData* data, const EllipticProblem& problem,
  const VirtualElementOptions& options, const SolveProgress& progress)
{
  SolveReport report(progress);
  const auto check = [&report] { report.Check(); };
  CheckOptions(options);
  const VirtualElementMesh mesh = MakeVirtualElementMesh(data);
  CheckDiffusion(mesh, problem);
  VirtualElementResult result = UndefinedVirtualElementResult(); // what is not found out stays so
  const Stopwatch assembly;
  const DegreesOfFreedom dofs = NumberDegreesOfFreedom(mesh, problem, options.Order);
  const ExactValues truth = EvaluateExactly(dofs, problem);
  std::vector<double> values = EvaluateKnown(dofs, problem, truth.Solution);
  report.Tell(0.05);
  const VirtualElementParts parts = ComputeElementParts(mesh, dofs, problem, options, report);
  report.Tell(0.2);
  const VirtualElementSystem system = AssembleSystem(dofs, parts, values);
  CheckSystem(dofs, system, problem);
  result.AssemblySeconds = assembly.Seconds();
  report.Tell(0.3);
  const Stopwatch solving;
  const LinearSolution solution =
    SolveLinearSystem(system.Matrix, system.RightHandSide, options.Solver, check);
  result.SolveSeconds = solving.Seconds();
  result.Iterative = solution.Factor ? 0.0 : 1.0;
  report.Tell(0.6);
  for (std::size_t i = 0; i < solution.Values.size(); ++i)
  {
    values[system.DofOf[i]] = solution.Values[i];
  }
  if (solution.Factor)
  {
    const auto [condition, exact] = ComputeConditionNumber(system.Matrix, *solution.Factor, check);
    result.ConditionNumber = condition;
    result.ConditionIsEstimate = exact ? 0.0 : 1.0;
  }
  report.Tell(0.7);
  if (options.Details)
  {
    AddDetails(system, solution.Factor.get(), report, result);
  }
  report.Tell(0.8);
  result.DegreesOfFreedom = static_cast<double>(system.DofOf.size());
  result.Nonzeros = CountNonzeros(system.Matrix);
  result.MeshSize = *std::max_element(parts.Diameter.begin(), parts.Diameter.end());
  ComputeErrors(mesh, dofs, parts, problem, options, values, truth, report, result);
  values.resize(mesh.Points.size());
  result.Solution = std::move(values);
  if (problem.KnowsSolution())
  {
    result.GroundTruth.assign(
      truth.Solution.begin(), truth.Solution.begin() + mesh.NumberOfPoints());
  }
  result.MemoryMegabytes = PeakMegabytes();
  return result;
}

std::span<const VirtualElementPerformance> VirtualElementPerformances()
{
  return Performances;
}

std::span<const VirtualElementArray> VirtualElementArrays()
{
  return Arrays;
}

} // namespace pemesh

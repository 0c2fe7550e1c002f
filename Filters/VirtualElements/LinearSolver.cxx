// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LinearSolver.h"

#include "ConjugateGradients.h"
#include "SparseCholesky.h"
#include "SparseLU.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace pemesh
{

namespace
{

constexpr double ResidualTolerance = 1.0e-12;
constexpr double MemoryShare = 0.8; // of what is available, for the factor

// What the system says may be used without swapping; infinite where it says nothing.
double AvailableMemory()
{
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kilobytes = 0.0;
  while (file >> word)
  {
    if (word == "MemAvailable:" && file >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return std::numeric_limits<double>::infinity();
}

// The only place where an iteration of Eigen's can be heard is its preconditioner.
class CheckedIncompleteLU : public Eigen::IncompleteLUT<double>
{
public:
  template <typename Vector>
  auto solve(const Vector& vector) const
  {
    if (this->Check)
    {
      this->Check();
    }
    return this->Eigen::IncompleteLUT<double>::solve(vector);
  }

  std::function<void()> Check;
};

std::unique_ptr<Factorization> Factorize(const SparseMatrix& matrix, double memoryLimit)
{
  if (matrix.Symmetric)
  {
    try
    {
      return std::make_unique<SparseCholesky>(matrix, memoryLimit);
    }
    catch (const NotPositiveDefinite&)
    {
      if (matrix.Definite)
      {
        throw;
      }
    }
  }
  return std::make_unique<SparseLU>(matrix, memoryLimit);
}

// One step of refinement takes out what the factorisation's rounding left in the residual.
std::vector<double> SolveAndRefine(
  const SparseMatrix& matrix, std::span<const double> rightHandSide, const Factorization& factor)
{
  std::vector<double> solution = factor.Solve(rightHandSide);
  std::vector<double> residual = Multiply(matrix, solution);
  std::transform(
    rightHandSide.begin(), rightHandSide.end(), residual.begin(), residual.begin(), std::minus<>());
  const std::vector<double> correction = factor.Solve(residual);
  std::transform(
    solution.begin(), solution.end(), correction.begin(), solution.begin(), std::plus<>());
  return solution;
}

std::vector<double> Iterate(const SparseMatrix& matrix, std::span<const double> rightHandSide,
  const std::function<void()>& check)
{
  const int limit = std::max(1000, 20 * matrix.Size());
  if (matrix.Symmetric)
  {
    ConjugateGradients iteration = RunConjugateGradients(
      matrix, rightHandSide, CgPreconditioner::IncompleteCholesky, ResidualTolerance, limit, check);
    if (!iteration.Converged)
    {
      throw std::runtime_error(matrix.Definite
          ? "Conjugate gradients did not converge: use the direct solver."
          : "Conjugate gradients did not converge, as may be with a negative reaction: use the "
            "direct solver.");
    }
    return iteration.Solution;
  }
  const Eigen::Map<const Eigen::SparseMatrix<double>> view(matrix.Size(), matrix.Size(),
    static_cast<Eigen::Index>(matrix.Row.size()), matrix.ColumnStart.data(), matrix.Row.data(),
    matrix.Value.data());
  const Eigen::SparseMatrix<double> copy = view;
  Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, CheckedIncompleteLU> solver;
  solver.preconditioner().Check = check;
  solver.setTolerance(ResidualTolerance);
  solver.setMaxIterations(limit);
  solver.compute(copy);
  if (solver.info() != Eigen::Success)
  {
    throw std::runtime_error("The incomplete factorisation broke down: use the direct solver.");
  }
  std::vector<double> solution(rightHandSide.size());
  const auto size = static_cast<Eigen::Index>(rightHandSide.size());
  Eigen::Map<Eigen::VectorXd>(solution.data(), size) =
    solver.solve(Eigen::Map<const Eigen::VectorXd>(rightHandSide.data(), size));
  if (solver.info() != Eigen::Success)
  {
    throw std::runtime_error("BiCGSTAB did not converge: use the direct solver.");
  }
  return solution;
}

} // namespace

LinearSolution SolveLinearSystem(const SparseMatrix& matrix, std::span<const double> rightHandSide,
  SolverKind kind, const std::function<void()>& check)
{
  LinearSolution result;
  if (kind != SolverKind::Iterative)
  {
    try
    {
      result.Factor = Factorize(matrix,
        kind == SolverKind::Direct ? std::numeric_limits<double>::infinity()
                                   : MemoryShare * AvailableMemory());
    }
    catch (const std::bad_alloc&)
    {
      if (kind == SolverKind::Direct)
      {
        throw std::runtime_error("The factor of the system does not fit into memory: use the "
                                 "iterative solver, or a mesh with fewer vertices.");
      }
    }
  }
  result.Values = result.Factor ? SolveAndRefine(matrix, rightHandSide, *result.Factor)
                                : Iterate(matrix, rightHandSide, check);
  if (!std::all_of(result.Values.begin(), result.Values.end(),
        [](double value) { return std::isfinite(value); }))
  {
    throw std::runtime_error("The system cannot be solved in double precision: the solution has "
                             "values that are not finite.");
  }
  return result;
}

} // namespace pemesh

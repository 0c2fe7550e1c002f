// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SpectralCondition.h"

#include "ConjugateGradients.h"
#include "SparseMatrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace pemesh
{

namespace
{

constexpr int DenseLimit = 100;
constexpr double Tolerance = 1.0e-5;
constexpr int Restarts = 2000;
constexpr int LanczosVectors = 24;

// A symmetric operator in the form that Spectra wants.
class Operator
{
public:
  using Scalar = double;

  Operator(int size, std::function<void(std::span<const double>, std::span<double>)> apply)
    : Size(size)
    , Apply(std::move(apply))
  {
  }
  Eigen::Index rows() const { return this->Size; }
  Eigen::Index cols() const { return this->Size; }
  void perform_op(const double* in, double* out) const
  {
    const std::size_t size = static_cast<std::size_t>(this->Size);
    this->Apply({ in, size }, { out, size });
  }

private:
  int Size;
  std::function<void(std::span<const double>, std::span<double>)> Apply;
};

double LargestEigenvalue(Operator matrix)
{
  Spectra::SymEigsSolver<Operator> solver(matrix, 1, LanczosVectors);
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, Restarts, Tolerance);
  return found == 1 ? std::abs(solver.eigenvalues()(0)) : std::numeric_limits<double>::quiet_NaN();
}

double DenseConditionNumber(const SparseMatrix& matrix)
{
  const std::size_t n = static_cast<std::size_t>(matrix.Size());
  Eigen::MatrixXd dense(matrix.Size(), matrix.Size());
  std::vector<double> unit(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    unit[i] = 1.0;
    Multiply(matrix, unit, { dense.data() + i * n, n });
    unit[i] = 0.0;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(dense);
  return svd.singularValues()(0) / svd.singularValues()(matrix.Size() - 1);
}

} // namespace

double LanczosConditionNumber(const ConjugateGradients& run)
{
  const auto size = static_cast<Eigen::Index>(run.Diagonal.size());
  if (!run.Converged || size == 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum;
  spectrum.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(run.Diagonal.data(), size),
    Eigen::Map<const Eigen::VectorXd>(run.SubDiagonal.data(), size - 1), Eigen::EigenvaluesOnly);
  return spectrum.eigenvalues()(size - 1) / spectrum.eigenvalues()(0);
}

double ComputeSpectralConditionNumber(
  const SparseMatrix& matrix, const Factorization& factor, const std::function<void()>& check)
{
  const int n = matrix.Size();
  if (n < DenseLimit)
  {
    return DenseConditionNumber(matrix);
  }
  std::vector<double> middle(static_cast<std::size_t>(n));
  const auto goOn = [&check]
  {
    if (check)
    {
      check();
    }
  };
  const Operator product(n,
    [&](std::span<const double> in, std::span<double> out)
    {
      goOn();
      if (matrix.Symmetric)
      {
        return Multiply(matrix, in, out);
      }
      Multiply(matrix, in, middle);
      MultiplyTransposed(matrix, middle, out);
    });
  const Operator inverse(n,
    [&](std::span<const double> in, std::span<double> out)
    {
      goOn();
      std::vector<double> solution =
        matrix.Symmetric ? factor.Solve(in) : factor.Solve(factor.SolveTransposed(in));
      std::copy(solution.begin(), solution.end(), out.begin());
    });
  const double square = LargestEigenvalue(product) * LargestEigenvalue(inverse);
  return matrix.Symmetric ? square : std::sqrt(square);
}

} // namespace pemesh

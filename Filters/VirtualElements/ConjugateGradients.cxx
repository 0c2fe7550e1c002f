// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConjugateGradients.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cmath>

namespace pemesh
{

namespace
{

using Vector = Eigen::VectorXd;
using EigenMatrix = Eigen::SparseMatrix<double>;

class Preconditioner
{
public:
  Preconditioner(const SparseMatrix& matrix, CgPreconditioner kind)
    : Kind(kind)
  {
    const Eigen::Map<const EigenMatrix> view(matrix.Size(), matrix.Size(),
      static_cast<Eigen::Index>(matrix.Row.size()), matrix.ColumnStart.data(), matrix.Row.data(),
      matrix.Value.data());
    if (kind == CgPreconditioner::Jacobi)
    {
      this->Diagonal = EigenMatrix(view).diagonal();
    }
    else if (kind == CgPreconditioner::IncompleteCholesky)
    {
      this->Factor.compute(EigenMatrix(view));
    }
  }

  /** False where the incomplete factorisation breaks down, as it may if the matrix is indefinite.
   */
  bool IsThere() const
  {
    return this->Kind != CgPreconditioner::IncompleteCholesky ||
      this->Factor.info() == Eigen::Success;
  }

  void Apply(const Vector& residual, Vector& result) const
  {
    switch (this->Kind)
    {
      case CgPreconditioner::None:
        result = residual;
        return;
      case CgPreconditioner::Jacobi:
        result = residual.cwiseQuotient(this->Diagonal);
        return;
      case CgPreconditioner::IncompleteCholesky:
        result = this->Factor.solve(residual);
        return;
    }
  }

private:
  CgPreconditioner Kind;
  Vector Diagonal;
  Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> Factor;
};

} // namespace

ConjugateGradients RunConjugateGradients(const SparseMatrix& matrix,
  std::span<const double> rightHandSide, CgPreconditioner kind, double tolerance, int limit,
  const std::function<void()>& check)
{
  const auto size = static_cast<Eigen::Index>(rightHandSide.size());
  const Preconditioner preconditioner(matrix, kind);
  ConjugateGradients result;
  result.Solution.assign(rightHandSide.size(), 0.0);
  if (!preconditioner.IsThere())
  {
    return result;
  }
  Eigen::Map<Vector> x(result.Solution.data(), size);
  Vector residual = Eigen::Map<const Vector>(rightHandSide.data(), size);
  Vector direction(size);
  Vector preconditioned(size);
  std::vector<double> image(rightHandSide.size());
  const Eigen::Map<const Vector> product(image.data(), size);
  const double goal = tolerance * residual.norm();
  preconditioner.Apply(residual, preconditioned);
  direction = preconditioned;
  double old = residual.dot(preconditioned);
  result.Converged = residual.norm() <= goal;
  double carried = 0.0; // from the step before into the diagonal of Lanczos' matrix
  while (!result.Converged && result.Iterations < limit)
  {
    if (check)
    {
      check();
    }
    Multiply(matrix, { direction.data(), rightHandSide.size() }, image);
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0) || !std::isfinite(curvature))
    {
      return result; // not positive definite in double precision
    }
    const double step = old / curvature;
    x += step * direction;
    residual -= step * product;
    ++result.Iterations;
    result.Converged = residual.norm() <= goal;
    preconditioner.Apply(residual, preconditioned);
    const double next = residual.dot(preconditioned);
    result.Diagonal.push_back(1.0 / step + carried);
    result.SubDiagonal.push_back(std::sqrt(next / old) / step);
    carried = next / old / step;
    direction = preconditioned + next / old * direction;
    old = next;
  }
  return result;
}

} // namespace pemesh

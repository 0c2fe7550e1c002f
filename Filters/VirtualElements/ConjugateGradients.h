// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The method of conjugate gradients (M. R. Hestenes, E. Stiefel, J. Res. Natl. Bur. Stand. 49
 * (1952) 409-436), from zero, with a choice of preconditioners.
 */
#ifndef pemesh_ConjugateGradients_h
#define pemesh_ConjugateGradients_h

#include "SparseMatrix.h"

#include <functional>
#include <span>
#include <vector>

namespace pemesh
{

enum class CgPreconditioner
{
  None,
  Jacobi,            ///< the diagonal
  IncompleteCholesky ///< without fill, the diagonal shifted until it exists (C.-J. Lin, J. J. More,
                     ///< SIAM J. Sci. Comput. 21 (1999) 24-45)
};

struct ConjugateGradients
{
  std::vector<double> Solution;
  int Iterations = 0;
  bool Converged = false;
  /** The diagonal of Lanczos' tridiagonal matrix and what stands beside it, without preconditioner.
   */
  std::vector<double> Diagonal;
  std::vector<double> SubDiagonal;
};

/**
 * Ends at a residual of `tolerance` times the right-hand side, in the 2-norm, or at the limit.
 * `check`, if there is one, is called in every iteration and may throw.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT ConjugateGradients RunConjugateGradients(
  const SparseMatrix& matrix, std::span<const double> rightHandSide,
  CgPreconditioner preconditioner, double tolerance, int limit,
  const std::function<void()>& check = {});

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Solves the system, directly or iteratively. Private to the module.
 */
#ifndef pemesh_LinearSolver_h
#define pemesh_LinearSolver_h

#include "SparseMatrix.h"
#include "VirtualElementOptions.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pemesh
{

struct LinearSolution
{
  std::vector<double> Values;
  std::unique_ptr<Factorization> Factor; ///< null where an iteration was used
};

/**
 * Direct solutions have one step of refinement; iterations end at a residual of 1e-12 of the
 * right-hand side. `matrix` must live as long as the factor. Throws std::runtime_error, one
 * sentence, where there is no solution in double precision or in memory. `check` is called in every
 * iteration and may throw; factorisations, complete or not, do not call it.
 */
LinearSolution SolveLinearSystem(const SparseMatrix& matrix, std::span<const double> rightHandSide,
  SolverKind kind, const std::function<void()>& check = {});

} // namespace pemesh

#endif

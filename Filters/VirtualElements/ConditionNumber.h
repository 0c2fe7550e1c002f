// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The condition number in the 1-norm of a sparse matrix, from the
 * factor that solves the system.
 */
#ifndef pemesh_ConditionNumber_h
#define pemesh_ConditionNumber_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <functional>

namespace pemesh
{

class Factorization;
struct SparseMatrix;

/** Matrices with fewer unknowns than this have their condition number computed, not estimated. */
inline constexpr int ExactConditionNumberLimit = 500;

/** Beyond this a condition number means only "beyond double precision". */
inline constexpr double LargestMeaningfulConditionNumber = 1.0e16;

struct ConditionNumber
{
  double Value = 0.0;
  bool Exact = true; ///< else a lower bound, seldom more than a few per cent below
};

/**
 * ||A||_1 ||A^-1||_1: exact below ExactConditionNumberLimit unknowns, estimated above. `check`, if
 * there is one, is called between solutions and may throw, here and below.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT ConditionNumber ComputeConditionNumber(
  const SparseMatrix& matrix, const Factorization& factor, const std::function<void()>& check = {});

/** ||A^-1||_1 from all columns of the inverse. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double ExactInverseNorm(
  const Factorization& factor, const std::function<void()>& check = {});

/**
 * A lower bound of ||A^-1||_1 by the block 1-norm power method of N. J. Higham, F. Tisseur, SIAM
 * J. Matrix Anal. Appl. 21 (2000) 1185-1201, algorithm 2.4 with eight columns, two from 20,000
 * unknowns on, and at most five steps (the method of W. W. Hager, SIAM J. Sci. Stat. Comput. 5
 * (1984) 311-316, with several starts at once). The start is always the same, so the answer is too.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double EstimateInverseNorm(
  const Factorization& factor, const std::function<void()>& check = {});

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The condition number in the 1-norm of a sparse symmetric positive definite matrix, from the
 * factor that solves the system.
 */
#ifndef pemesh_ConditionNumber_h
#define pemesh_ConditionNumber_h

#include "pemeshFiltersSolversModule.h" // For export macro

namespace pemesh
{

class SparseCholesky;
struct SymmetricMatrix;

/** Matrices with fewer unknowns than this have their condition number computed, not estimated. */
inline constexpr int ExactConditionNumberLimit = 500;

/** Beyond this a condition number means only "beyond double precision". */
inline constexpr double LargestMeaningfulConditionNumber = 1.0e16;

struct ConditionNumber
{
  double Value = 0.0;
  bool Exact = true; ///< else a lower bound, seldom more than a few per cent below
};

/** ||A||_1 ||A^-1||_1: exact below ExactConditionNumberLimit unknowns, estimated above. */
PEMESHFILTERSSOLVERS_EXPORT ConditionNumber ComputeConditionNumber(
  const SymmetricMatrix& matrix, const SparseCholesky& factor);

/** ||A^-1||_1 from all columns of the inverse. */
PEMESHFILTERSSOLVERS_EXPORT double ExactInverseNorm(const SparseCholesky& factor);

/**
 * A lower bound of ||A^-1||_1 by the block 1-norm power method of N. J. Higham, F. Tisseur, SIAM
 * J. Matrix Anal. Appl. 21 (2000) 1185-1201, algorithm 2.4 with eight columns and at most five
 * steps (the method of W. W. Hager, SIAM J. Sci. Stat. Comput. 5 (1984) 311-316, with several
 * starts at once). The start is always the same, so the answer is too.
 */
PEMESHFILTERSSOLVERS_EXPORT double EstimateInverseNorm(const SparseCholesky& factor);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The condition number in the 2-norm: the largest over the smallest singular value.
 */
#ifndef pemesh_SpectralCondition_h
#define pemesh_SpectralCondition_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <functional>

namespace pemesh
{

class Factorization;
struct ConjugateGradients;
struct SparseMatrix;

/**
 * Both ends of the spectrum by Lanczos' method, thickly restarted (Spectra), on the matrix and,
 * through the factor, on its inverse, to a relative residual of 1e-5; exact below 100 unknowns. NaN
 * where it does not converge. `check`, if there is one, is called between the solutions and may
 * throw.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double ComputeSpectralConditionNumber(
  const SparseMatrix& matrix, const Factorization& factor, const std::function<void()>& check = {});

/**
 * Without a factor: the ends of the spectrum of Lanczos' matrix, which conjugate gradients without
 * preconditioner have made on their way. A lower bound, because an end to which the right-hand side
 * is orthogonal is not seen; NaN where they did not converge.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double LanczosConditionNumber(const ConjugateGradients& run);

} // namespace pemesh

#endif

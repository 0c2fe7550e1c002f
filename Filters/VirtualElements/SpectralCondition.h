// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The condition number in the 2-norm: the largest over the smallest singular value.
 */
#ifndef pemesh_SpectralCondition_h
#define pemesh_SpectralCondition_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

namespace pemesh
{

class Factorization;
struct SparseMatrix;

/**
 * Both ends of the spectrum by Lanczos' method, thickly restarted (Spectra), on the matrix and,
 * through the factor, on its inverse, to a relative residual of 1e-5; exact below 100 unknowns. NaN
 * where it does not converge.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double ComputeSpectralConditionNumber(
  const SparseMatrix& matrix, const Factorization& factor);

} // namespace pemesh

#endif

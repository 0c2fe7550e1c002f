// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Gauss' rules on [0, 1], to full precision for any number of points: Newton's method on Legendre's
 * polynomials and their derivatives. The weights sum to one.
 */
#ifndef pemesh_GaussRules_h
#define pemesh_GaussRules_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <vector>

namespace pemesh
{

struct GaussRule
{
  std::vector<double> Points; ///< ascending, symmetric about 1/2 to the bit
  std::vector<double> Weights;
};

/** n >= 1 points, exact for polynomials of degree 2n - 1. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT GaussRule GaussLegendre(int n);

/** n >= 2 points, 0 and 1 among them, exact for polynomials of degree 2n - 3. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT GaussRule GaussLobatto(int n);

/**
 * The values at a place of the polynomials of degree nodes.size() - 1 that are one at one node and
 * zero at the others.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::vector<double> LagrangeValues(
  const std::vector<double>& nodes, double place);

} // namespace pemesh

#endif

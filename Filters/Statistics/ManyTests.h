// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Corrections of p-values for the number of tests made.
 */
#ifndef pemesh_ManyTests_h
#define pemesh_ManyTests_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

/**
 * Holm's p-values: those below alpha hold all together but for a chance of alpha, however the
 * tests depend on each other. NaN stays NaN and counts as no test.
 *
 * Reference: S. Holm, A simple sequentially rejective multiple test procedure, Scand. J. Stat. 6
 * (1979) 65-70.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> HolmPValues(std::span<const double> p);

/**
 * Benjamini's and Hochberg's p-values: of those below alpha, a share of at most alpha is false on
 * average; for tests that are independent or positively dependent. NaN as above.
 *
 * Reference: Y. Benjamini, Y. Hochberg, Controlling the false discovery rate, J. R. Stat. Soc. B 57
 * (1995) 289-300, doi:10.1111/j.2517-6161.1995.tb02031.x.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> BenjaminiHochbergPValues(
  std::span<const double> p);

} // namespace pemesh

#endif

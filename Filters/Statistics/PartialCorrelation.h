// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Correlation of two quantities once others are held fixed: of what linear regression on them
 * leaves of each.
 */
#ifndef pemesh_PartialCorrelation_h
#define pemesh_PartialCorrelation_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

/**
 * What is left of a sample after regression, with a constant, on the samples given; exactly 0
 * everywhere where they determine it (to 1e-10 of its spread). All values finite, equal lengths.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> RegressionResiduals(
  std::span<const double> sample, const std::vector<std::vector<double>>& given);

/**
 * The partial correlation in [-1, 1]: Pearson's coefficient of the residuals of both. NaN where
 * the given samples determine one of them, where rows do not exceed the given samples by three,
 * or a value is not finite. With ranks in place of values it is Spearman's.
 *
 * Reference: M. G. Kendall, A. Stuart, The Advanced Theory of Statistics, vol. 2, 4th ed., Griffin
 * 1979, chapter 27.
 */
PEMESHFILTERSSTATISTICS_EXPORT double PartialCorrelation(std::span<const double> x,
  std::span<const double> y, const std::vector<std::vector<double>>& given);

} // namespace pemesh

#endif

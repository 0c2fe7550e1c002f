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

/**
 * Kendall's partial tau-b in [-1, 1]: what the matrix of tau-b leaves between both once the given
 * samples are taken out, as if it were one of linear correlations; for one given sample
 * (t_xy - t_xz t_yz) / sqrt((1 - t_xz^2) (1 - t_yz^2)). NaN where they determine the order of one
 * of them, or where rows do not exceed the given samples by three. Unlike a partial correlation of
 * residuals it need not be 0 where both depend on the given samples alone (Nelson, Yang).
 *
 * References: M. G. Kendall, Partial rank correlation, Biometrika 32 (1942) 277-283; P. I. Nelson,
 * S.-S. Yang, Some properties of Kendall's partial rank correlation coefficient, Stat. Probab.
 * Lett. 6 (1988) 147-150.
 */
PEMESHFILTERSSTATISTICS_EXPORT double PartialKendall(std::span<const double> x,
  std::span<const double> y, const std::vector<std::vector<double>>& given);

/**
 * Root of the partial distance correlation, in [0, 1] as DistanceCorrelation, 0 where it is
 * negative: cosine of the U-centred distances of both once those of the given samples (each at
 * standard deviation 1, all as one vector) are projected out. NaN for fewer than four rows, where a
 * value is not finite, and where nothing is left. O(n^2) time, O(n) memory.
 *
 * Reference: G. J. Szekely, M. L. Rizzo, Partial distance correlation with methods for
 * dissimilarities, Ann. Stat. 42 (2014) 2382-2412, doi:10.1214/14-AOS1255.
 */
PEMESHFILTERSSTATISTICS_EXPORT double PartialDistanceCorrelation(std::span<const double> x,
  std::span<const double> y, const std::vector<std::vector<double>>& given);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Coefficients of correlation of two samples x_1 … x_n and y_1 … y_n.
 *
 * All take samples without NaN (see RemoveMissing) and are NaN where undefined: fewer than two
 * pairs, or a sample that is constant. Infinite values have ranks like any other, but no Pearson
 * coefficient.
 */
#ifndef pemesh_Correlation_h
#define pemesh_Correlation_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <cstdint>
#include <span>
#include <vector>

namespace pemesh
{

/** Pairwise deletion: what is left of both samples where neither is NaN. */
PEMESHFILTERSSTATISTICS_EXPORT void RemoveMissing(std::span<const double> x,
  std::span<const double> y, std::vector<double>& keptX, std::vector<double>& keptY);

/** True for fewer than two values, and where all values are equal. */
PEMESHFILTERSSTATISTICS_EXPORT bool IsConstant(std::span<const double> sample);

/**
 * Twice the mid-ranks less (n + 1): integers that add up to zero, tied values share their average.
 * Twice, so that averages stay integers and sums of products are exact.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> CenteredRanks(std::span<const double> sample);

/** Product-moment coefficient in [-1, 1]: strength of a linear relation. */
PEMESHFILTERSSTATISTICS_EXPORT double PearsonCorrelation(
  std::span<const double> x, std::span<const double> y);

/** Spearman's rho in [-1, 1]: Pearson's coefficient of the mid-ranks, exact with ties. */
PEMESHFILTERSSTATISTICS_EXPORT double SpearmanCorrelation(
  std::span<const double> x, std::span<const double> y);

/** The pairs of observations, sorted by how they agree. */
struct KendallCounts
{
  std::int64_t Pairs = 0;      // n (n - 1) / 2
  std::int64_t TiesX = 0;      // pairs tied in x (also those tied in both)
  std::int64_t TiesY = 0;      // pairs tied in y (also those tied in both)
  std::int64_t TiesBoth = 0;   // pairs tied in x and in y
  std::int64_t Discordant = 0; // pairs that x and y order in opposite ways

  std::int64_t Concordant() const
  {
    return this->Pairs - this->TiesX - this->TiesY + this->TiesBoth - this->Discordant;
  }
  std::int64_t Score() const { return this->Concordant() - this->Discordant; }
};

/**
 * Counts the pairs in O(n log n).
 *
 * Reference: W. R. Knight, A computer method for calculating Kendall's tau with ungrouped data,
 * J. Am. Stat. Assoc. 61 (1966) 436-439, doi:10.1080/01621459.1966.10480879.
 */
PEMESHFILTERSSTATISTICS_EXPORT KendallCounts CountKendallPairs(
  std::span<const double> x, std::span<const double> y);

/** Kendall's tau-b in [-1, 1]: (C - D) / sqrt((P - T_x) (P - T_y)). */
PEMESHFILTERSSTATISTICS_EXPORT double KendallTauB(const KendallCounts& counts);

} // namespace pemesh

#endif

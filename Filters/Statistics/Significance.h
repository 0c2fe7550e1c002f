// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Two-sided p-values of coefficients of correlation: how often two unrelated samples would look as
 * related as these. They mean something only if the observations are independent of each other;
 * the meshes of one parametric family are not.
 *
 * Samples hold no NaN (see RemoveMissing). A p-value is NaN for fewer than three pairs or a
 * constant sample.
 */
#ifndef pemesh_Significance_h
#define pemesh_Significance_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <cstdint>
#include <span>

namespace pemesh
{

/** How a p-value was found. */
enum class PValueMethod
{
  Undefined,
  Exact,       // over all arrangements of the sample
  Permutation, // over a seeded sample of arrangements
  Asymptotic   // from a limiting distribution
};

/** "exact", "permutation", …: for notes beside the number. */
PEMESHFILTERSSTATISTICS_EXPORT const char* PValueMethodName(PValueMethod method);

struct PValue
{
  double Value; // NaN if undefined
  PValueMethod Method;
};

/**
 * What to do where the exact distribution is out of reach: draw that many arrangements (a p-value
 * is then (1 + hits) / (1 + Permutations)), or with 0 use the limiting distribution.
 */
struct PermutationOptions
{
  int Permutations = 0;
  std::uint64_t Seed = 1;
};

/** Student's t with n - 2 degrees of freedom; assumes normally distributed observations. */
PEMESHFILTERSSTATISTICS_EXPORT PValue PearsonPValue(
  std::span<const double> x, std::span<const double> y);

/**
 * Exact for up to 12 pairs without ties and up to 8 with ties, else by permutation or from
 * Student's t with n - 2 degrees of freedom for the coefficient of the mid-ranks.
 */
PEMESHFILTERSSTATISTICS_EXPORT PValue SpearmanPValue(
  std::span<const double> x, std::span<const double> y, const PermutationOptions& options = {});

/**
 * Exact for up to 50 pairs without ties and up to 8 with ties, else by permutation or from the
 * normal distribution with the variance corrected for ties.
 *
 * Reference: M. G. Kendall, Rank Correlation Methods, 4th ed., Griffin 1970, sections 4 and 5.
 */
PEMESHFILTERSSTATISTICS_EXPORT PValue KendallPValue(
  std::span<const double> x, std::span<const double> y, const PermutationOptions& options = {});

} // namespace pemesh

#endif

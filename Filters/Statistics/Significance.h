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

#include <span>

namespace pemesh
{

/** How a p-value was found. */
enum class PValueMethod
{
  Undefined,
  Exact,     // over all arrangements of the sample
  Asymptotic // from a limiting distribution
};

/** "exact", "asymptotic", …: for notes beside the number. */
PEMESHFILTERSSTATISTICS_EXPORT const char* PValueMethodName(PValueMethod method);

struct PValue
{
  double Value; // NaN if undefined
  PValueMethod Method;
};

/** Student's t with n - 2 degrees of freedom; assumes normally distributed observations. */
PEMESHFILTERSSTATISTICS_EXPORT PValue PearsonPValue(
  std::span<const double> x, std::span<const double> y);

/**
 * Exact for up to 12 pairs without ties and up to 8 with ties, else from Student's t with n - 2
 * degrees of freedom for the coefficient of the mid-ranks.
 */
PEMESHFILTERSSTATISTICS_EXPORT PValue SpearmanPValue(
  std::span<const double> x, std::span<const double> y);

/**
 * Exact for up to 50 pairs without ties and up to 8 with ties, else from the normal distribution
 * with the variance corrected for ties.
 *
 * Reference: M. G. Kendall, Rank Correlation Methods, 4th ed., Griffin 1970, sections 4 and 5.
 */
PEMESHFILTERSSTATISTICS_EXPORT PValue KendallPValue(
  std::span<const double> x, std::span<const double> y);

} // namespace pemesh

#endif

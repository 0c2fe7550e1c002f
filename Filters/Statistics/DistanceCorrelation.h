// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Distance correlation: zero in the limit only for independent quantities, whatever the form of the
 * relation, where Pearson's and the rank coefficients see a monotone one alone.
 */
#ifndef pemesh_DistanceCorrelation_h
#define pemesh_DistanceCorrelation_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>

namespace pemesh
{

/**
 * The sample distance correlation in [0, 1] (the V-statistic, dcor of R's package energy):
 * sqrt(dCov^2(x, y) / sqrt(dCov^2(x, x) dCov^2(y, y))), 1 for points on a straight line. Of
 * unrelated samples it is not 0 but falls with their length (about 0.35 for 20 pairs). Samples
 * hold no NaN. NaN where undefined: fewer than two pairs, a constant sample, an infinite value.
 * O(n log n) by a sweep over x with sums kept by the rank of y.
 *
 * References: G. J. Székely, M. L. Rizzo, N. K. Bakirov, Measuring and testing dependence by
 * correlation of distances, Ann. Stat. 35 (2007) 2769-2794, doi:10.1214/009053607000000505,
 * definition 2.3. X. Huo, G. J. Székely, Fast computing for distance covariance, Technometrics 58
 * (2016) 435-447, doi:10.1080/00401706.2015.1054435.
 */
PEMESHFILTERSSTATISTICS_EXPORT double DistanceCorrelation(
  std::span<const double> x, std::span<const double> y);

} // namespace pemesh

#endif

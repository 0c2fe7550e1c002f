// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The metrics of a performance, ranked alone and jointly, and in words.
 */
#ifndef pemesh_RankedMetrics_h
#define pemesh_RankedMetrics_h

#include "RowFamilies.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

/** One metric and what its correlation with the performance says. */
struct RankedMetric
{
  std::string Name;
  long long Pair = 0; // row of the table of correlations
  int Rank = 0;       // 0: undefined
  double Tested = std::numeric_limits<double>::quiet_NaN();
  double Fit = std::numeric_limits<double>::quiet_NaN();
  double Distance = std::numeric_limits<double>::quiet_NaN();
  std::string Words;
  int JointRank = 0; // 0: not part of a joint model
  double JointWeight = std::numeric_limits<double>::quiet_NaN();
};

/** Best first; those that are undefined last, without a rank. */
void RankMetrics(std::vector<RankedMetric>& metrics);

/**
 * Fits all metrics that have a rank jointly, and answers with a sentence on it. `values` are the
 * columns of the metrics in their order, NaN where missing; so is `response`.
 */
std::string RankJointly(std::vector<RankedMetric>& metrics,
  const std::vector<std::vector<double>>& values, std::span<const double> response,
  const RowFamilies& families);

/** How many metrics, from the first, have a coefficient of the same size as the first. */
std::size_t CountTiesAtTop(const std::vector<RankedMetric>& metrics);

} // namespace pemesh

#endif

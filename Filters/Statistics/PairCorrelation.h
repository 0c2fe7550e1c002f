// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Everything that is told of pairs of columns: coefficients, p-values, intervals, form and words.
 */
#ifndef pemesh_PairCorrelation_h
#define pemesh_PairCorrelation_h

#include "FamilyTests.h"
#include "TrendForm.h"
#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pemesh
{

struct CoefficientKind;

/** What the rows of a table are to each other: decides what may be claimed. */
enum class RowsAre
{
  OneFamily,  // each deforms into the next: no sample, so neither p-values nor intervals
  Families,   // several of these: whole families change places and are drawn
  Independent // each row by itself
};

struct PairOptions
{
  const CoefficientKind* Kind = nullptr; // null: the first one
  RowsAre Rows = RowsAre::OneFamily;
  RowFamilies Families; // where rows are families
  int Permutations = 999;
  int Bootstrap = 0;
  double Level = 0.95;
  std::uint64_t Seed = 1;
  double TrendThreshold = 0.7;
};

/** NaN is what is undefined or not asked for. */
struct PairCorrelation
{
  std::size_t Count = 0;    // rows where both are defined
  std::size_t Families = 0; // that these rows come from
  double Pearson = std::numeric_limits<double>::quiet_NaN();
  double Spearman = std::numeric_limits<double>::quiet_NaN();
  double Kendall = std::numeric_limits<double>::quiet_NaN();
  double Distance = std::numeric_limits<double>::quiet_NaN();
  double Partial = std::numeric_limits<double>::quiet_NaN();
  /** The one that p-values, the interval and the words go by. */
  double Tested = std::numeric_limits<double>::quiet_NaN();
  /** One with a sign: Tested if it has one, else Spearman's where that is at least moderate. */
  double Direction = std::numeric_limits<double>::quiet_NaN();
  double P = std::numeric_limits<double>::quiet_NaN();
  double PHolm = std::numeric_limits<double>::quiet_NaN();
  double PBenjaminiHochberg = std::numeric_limits<double>::quiet_NaN();
  Interval Bounds{ std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN() };
  std::string Trend = "undefined";
  TrendForm Form;
  std::string Words;
};

/**
 * Empty where `progress` ended the work. With columns given, all of Tested, P, the interval and
 * the strength are those of the partial coefficient, for kinds that have one.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<PairCorrelation> CorrelatePairs(
  const PairsOfColumns& pairs, const PairOptions& options, const TestProgress& progress = {});

/** What p-values and intervals of these pairs mean, in one or two sentences. */
PEMESHFILTERSSTATISTICS_EXPORT std::string DescribeTests(
  const PairsOfColumns& pairs, const PairOptions& options);

} // namespace pemesh

#endif

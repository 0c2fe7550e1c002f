// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * p-values and intervals of many pairs of columns whose rows come in families: rows of one family
 * depend on each other, families do not.
 */
#ifndef pemesh_FamilyTests_h
#define pemesh_FamilyTests_h

#include "RowFamilies.h"
#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace pemesh
{

struct CoefficientKind;

/** Columns of equal length, NaN where a value is missing, and which of them are to be compared. */
struct PairsOfColumns
{
  std::vector<std::vector<double>> Columns;
  std::vector<std::pair<std::size_t, std::size_t>> Pairs;
  /** Columns that are held fixed (see CoefficientGiven). */
  std::vector<std::size_t> Given;
};

/** Told the fraction done; false ends the work, and the answer is empty then. */
using TestProgress = std::function<bool(double)>;

/**
 * Two-sided p-values of every pair: the share of the arrangements of FamilyShuffle, the given one
 * included, whose coefficient is at least as far from zero. NaN where the coefficient is undefined
 * or no two families can change places. Ranks are those among all rows that have a value. With
 * columns given, the residuals of Y change places (P. E. Kennedy, Randomization tests in
 * econometrics, J. Bus. Econ. Stat. 13 (1995) 85-94). The same bits for any number of threads.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> FamilyPValues(const PairsOfColumns& pairs,
  const CoefficientKind& kind, const RowFamilies& families, int permutations, std::uint64_t seed,
  const TestProgress& progress = {});

/**
 * Whether there are such p-values: with columns given only for kinds that regression leaves
 * residuals for, which are what changes places.
 */
PEMESHFILTERSSTATISTICS_EXPORT bool HasArrangements(
  const PairsOfColumns& pairs, const CoefficientKind& kind);

struct Interval
{
  double Low;
  double High;
};

/**
 * Bootstrap percentile intervals of every pair: `samples` times as many families are drawn, with
 * replacement, as there are, and the interval leaves (1 - level) / 2 of the coefficients out on
 * either side. NaN for fewer than four families (with three, every ninth sample is one family
 * three times), or where more than a tenth of the samples have no coefficient.
 *
 * References: B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap, Chapman and Hall 1993,
 * chapter 13; whole families: A. C. Davison, D. V. Hinkley, Bootstrap Methods and their
 * Application, Cambridge 1997, section 3.8.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<Interval> FamilyIntervals(const PairsOfColumns& pairs,
  const CoefficientKind& kind, const RowFamilies& families, int samples, double level,
  std::uint64_t seed, const TestProgress& progress = {});

/** The fewest families that have an interval. */
inline constexpr std::size_t FewestFamilies = 4;

} // namespace pemesh

#endif

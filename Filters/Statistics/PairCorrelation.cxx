// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PairCorrelation.h"

#include "CoefficientKinds.h"
#include "Correlation.h"
#include "DistanceCorrelation.h"
#include "ManyTests.h"
#include "NumberText.h"
#include "ParallelLoop.h"
#include "RelationWords.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

const CoefficientKind& KindOf(const PairOptions& options)
{
  return options.Kind ? *options.Kind : CoefficientKinds().front();
}

std::string TrendOf(const KendallCounts& counts, double tau, double threshold)
{
  const bool isUp = counts.Concordant() > 0 && (counts.Discordant == 0 || tau >= threshold);
  const bool isDown = counts.Discordant > 0 && (counts.Concordant() == 0 || tau <= -threshold);
  // Both only for a threshold of zero.
  return isUp == isDown ? "mixed" : isUp ? "increasing" : "decreasing";
}

bool HasInfinity(const std::vector<double>& sample)
{
  return std::any_of(sample.begin(), sample.end(), [](double value) { return std::isinf(value); });
}

/** Why a coefficient of these rows is undefined. */
std::string WhyUndefined(const std::vector<double>& x, const std::vector<double>& y, bool partial)
{
  return x.size() < 2 ? "undefined: fewer than two rows have both values"
    : IsConstant(x)   ? "undefined: X has one value only"
    : IsConstant(y)   ? "undefined: Y has one value only"
    : HasInfinity(x)  ? "undefined: X has infinite values"
    : HasInfinity(y)  ? "undefined: Y has infinite values"
    : partial         ? "undefined: the columns given leave nothing of X or Y"
                      : "undefined";
}

std::size_t CountFamilies(
  const RowFamilies& families, const std::vector<double>& x, const std::vector<double>& y)
{
  return static_cast<std::size_t>(std::count_if(families.begin(), families.end(),
    [&](const std::vector<std::size_t>& rows)
    {
      return std::any_of(rows.begin(), rows.end(),
        [&](std::size_t row) { return !std::isnan(x[row]) && !std::isnan(y[row]); });
    }));
}

/**
 * Whether a weak coefficient hides a relation that is not monotone. Of 30 unrelated rows one in a
 * hundred has a distance correlation of 0.45; a parabola has 0.5.
 */
bool TurnsBack(const PairCorrelation& result)
{
  constexpr double least = 0.45;
  constexpr std::size_t fewestRows = 30;
  return std::fabs(result.Tested) < ModerateFrom && result.Distance >= least &&
    result.Count >= fewestRows;
}

/** All that needs no other pair. */
PairCorrelation CorrelatePair(
  const PairsOfColumns& pairs, std::size_t pair, const PairOptions& options)
{
  const std::vector<double>& allX = pairs.Columns[pairs.Pairs[pair].first];
  const std::vector<double>& allY = pairs.Columns[pairs.Pairs[pair].second];
  std::vector<double> x;
  std::vector<double> y;
  RemoveMissing(allX, allY, x, y);
  PairCorrelation result;
  result.Count = x.size();
  result.Families = options.Rows == RowsAre::Families ? CountFamilies(options.Families, allX, allY)
    : options.Rows == RowsAre::Independent            ? x.size()
                                                      : 1;
  result.Pearson = PearsonCorrelation(x, y);
  result.Spearman = SpearmanCorrelation(x, y);
  const KendallCounts counts = CountKendallPairs(x, y);
  result.Kendall = KendallTauB(counts);
  result.Distance = DistanceCorrelation(x, y);
  const CoefficientKind& kind = KindOf(options);
  std::vector<std::span<const double>> given;
  for (const std::size_t column : pairs.Given)
  {
    given.emplace_back(pairs.Columns[column]);
  }
  result.Tested = CoefficientGiven(kind, allX, allY, given);
  if (!given.empty())
  {
    result.Partial = result.Tested;
  }
  if (x.size() >= 3)
  {
    result.Trend = IsConstant(x) || IsConstant(y)
      ? "constant"
      : TrendOf(counts, result.Kendall, options.TrendThreshold);
  }
  result.Form = FindTrendForm(x, y);
  result.Direction = kind.HasSign                ? result.Tested
    : std::fabs(result.Spearman) >= ModerateFrom ? result.Spearman
                                                 : 0.0 * result.Tested;
  result.Words = std::isnan(result.Tested)
    ? WhyUndefined(x, y, !given.empty())
    : RelationWords(result.Tested, result.Direction, result.Form);
  if (given.empty() && kind.HasSign && TurnsBack(result))
  {
    result.Words += "; not monotone: distance correlation " + RoundedNumber(result.Distance);
  }
  if (options.Rows == RowsAre::Independent && kind.IndependentPValue && given.empty())
  {
    result.P = kind.IndependentPValue(x, y).Value;
  }
  return result;
}

/** What rows are drawn and arranged by. */
RowFamilies FamiliesOf(const PairsOfColumns& pairs, const PairOptions& options)
{
  const std::size_t rows = pairs.Columns.empty() ? 0 : pairs.Columns.front().size();
  return options.Rows == RowsAre::Families ? options.Families
    : options.Rows == RowsAre::Independent ? SingleRows(rows)
                                           : RowFamilies();
}

bool AddTests(const PairsOfColumns& pairs, const PairOptions& options,
  std::vector<PairCorrelation>& results, const TestProgress& progress)
{
  const CoefficientKind& kind = KindOf(options);
  const RowFamilies families = FamiliesOf(pairs, options);
  const bool arranged = options.Rows == RowsAre::Families ||
    (options.Rows == RowsAre::Independent && (!kind.IndependentPValue || !pairs.Given.empty()));
  if (arranged)
  {
    const auto third = [&](double done) { return !progress || progress((1.0 + done) / 3); };
    const std::vector<double> p =
      FamilyPValues(pairs, kind, families, options.Permutations, options.Seed, third);
    if (p.size() < results.size())
    {
      return false;
    }
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      results[i].P = p[i];
    }
  }
  if (options.Rows != RowsAre::OneFamily && options.Bootstrap > 0)
  {
    const auto third = [&](double done) { return !progress || progress((2.0 + done) / 3); };
    const std::vector<Interval> bounds =
      FamilyIntervals(pairs, kind, families, options.Bootstrap, options.Level, options.Seed, third);
    if (bounds.size() < results.size())
    {
      return false;
    }
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      results[i].Bounds = bounds[i];
    }
  }
  return true;
}

void AddCorrections(std::vector<PairCorrelation>& results)
{
  std::vector<double> p(results.size());
  std::transform(
    results.begin(), results.end(), p.begin(), [](const PairCorrelation& r) { return r.P; });
  const std::vector<double> holm = HolmPValues(p);
  const std::vector<double> rate = BenjaminiHochbergPValues(p);
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    results[i].PHolm = holm[i];
    results[i].PBenjaminiHochberg = rate[i];
  }
}

std::string DescribeFamilies(const PairOptions& options)
{
  const FamilyShuffle shuffle(options.Families, options.Permutations, options.Seed);
  const std::string number = std::to_string(options.Families.size());
  if (shuffle.GetCount() == 0)
  {
    return "no p-values: no two of the " + number +
      " families have the same number of rows, so that none can change places";
  }
  return "p by letting " + number + " families change places as a whole, " +
    (shuffle.IsExact() ? "all " : "") + std::to_string(shuffle.GetCount() + 1) + " arrangements" +
    (shuffle.IsExact() ? "" : " drawn (seed " + std::to_string(options.Seed) + ")") +
    ": it cannot be below " + RoundedNumber(1.0 / (1.0 + shuffle.GetCount()));
}

} // namespace

std::string DescribeTests(const PairsOfColumns& pairs, const PairOptions& options)
{
  if (options.Rows == RowsAre::OneFamily)
  {
    return "no p-values and no intervals: the rows belong to one family, where each mesh deforms "
           "into the next; they are no sample, and only the trend counts";
  }
  const std::string label = KindOf(options).Label;
  std::string text = !HasArrangements(pairs, KindOf(options))
    ? "no p-values: of partial coefficients only Spearman's and Pearson's have residuals that can "
      "change places, " +
      label + " has none"
    : options.Rows == RowsAre::Families ? DescribeFamilies(options)
                                        : std::string("p two-sided, for independent rows");
  text += "; p, interval and words go by " + label;
  if (options.Bootstrap > 0)
  {
    const bool few = options.Rows == RowsAre::Families && options.Families.size() < FewestFamilies;
    text += few ? "; no intervals: fewer than " + std::to_string(FewestFamilies) + " families"
                : "; intervals of " + RoundedNumber(100 * options.Level) + " % from " +
        std::to_string(options.Bootstrap) + " samples of whole " +
        (options.Rows == RowsAre::Families ? "families" : "rows");
  }
  return text;
}

std::vector<PairCorrelation> CorrelatePairs(
  const PairsOfColumns& pairs, const PairOptions& options, const TestProgress& progress)
{
  std::vector<PairCorrelation> results(pairs.Pairs.size());
  constexpr std::size_t portion = 256; // pairs between two reports of progress
  for (std::size_t first = 0; first < results.size(); first += portion)
  {
    const std::size_t last = std::min(first + portion, results.size());
    ParallelLoop(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 1,
      [&](vtkIdType from, vtkIdType to)
      {
        for (auto pair = static_cast<std::size_t>(from); pair < static_cast<std::size_t>(to);
             ++pair)
        {
          results[pair] = CorrelatePair(pairs, pair, options);
        }
      });
    const double done = static_cast<double>(last) / static_cast<double>(results.size());
    if (progress && !progress(done / 3))
    {
      return {};
    }
  }
  if (!AddTests(pairs, options, results, progress))
  {
    return {};
  }
  AddCorrections(results);
  return results;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FamilyTests.h"

#include "CoefficientKinds.h"
#include "Correlation.h"
#include "ParallelLoop.h"
#include "PartialCorrelation.h"
#include "SumOfProducts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/** Two samples as their coefficient wants them; zero where missing if that is Pearson's. */
struct PreparedPair
{
  std::vector<double> X;
  std::vector<double> Y;
  bool Complete = true;
};

PreparedPair PreparePair(const PairsOfColumns& pairs, std::size_t pair, const CoefficientKind& kind)
{
  PreparedPair prepared{ PrepareSample(kind, pairs.Columns[pairs.Pairs[pair].first]),
    PrepareSample(kind, pairs.Columns[pairs.Pairs[pair].second]) };
  std::vector<std::vector<double>> given;
  for (const std::size_t column : pairs.Given)
  {
    given.push_back(PrepareSample(kind, pairs.Columns[column]));
  }
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < prepared.X.size(); ++row)
  {
    bool present = !std::isnan(prepared.X[row]) && !std::isnan(prepared.Y[row]);
    for (const std::vector<double>& g : given)
    {
      present = present && !std::isnan(g[row]);
    }
    if (present)
    {
      rows.push_back(row);
    }
  }
  prepared.Complete = rows.size() == prepared.X.size();
  if (given.empty())
  {
    return prepared;
  }
  const auto pick = [&](const std::vector<double>& all)
  {
    std::vector<double> picked;
    for (const std::size_t row : rows)
    {
      picked.push_back(all[row]);
    }
    return picked;
  };
  std::transform(given.begin(), given.end(), given.begin(), pick);
  for (std::vector<double>* sample : { &prepared.X, &prepared.Y })
  {
    const std::vector<double> rest = RegressionResiduals(pick(*sample), given);
    std::fill(sample->begin(), sample->end(), Undefined);
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      (*sample)[rows[i]] = rest[i];
    }
  }
  return prepared;
}

std::vector<double> Centered(const std::vector<double>& sample)
{
  const double mean =
    std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
  std::vector<double> centered(sample.size());
  std::transform(
    sample.begin(), sample.end(), centered.begin(), [&](double value) { return value - mean; });
  return centered;
}

/** The statistic of one pair for one arrangement of Y after the other. */
class ArrangedStatistic
{
public:
  ArrangedStatistic(PreparedPair pair, const CoefficientKind& kind)
    : Pair(std::move(pair))
    , Compute(kind.Compute)
    , ByProducts(kind.IsPearson && this->Pair.Complete)
    , Y(this->Pair.Y.size())
  {
    this->Observed = this->Evaluate(this->Pair.Y);
    this->IsDefined = !std::isnan(this->Observed);
    if (this->ByProducts && this->IsDefined)
    {
      // Arrangements change neither means nor spreads: the sum of products tells them apart.
      this->Pair.X = Centered(this->Pair.X);
      this->Scale = std::sqrt(SumOfProducts(this->Pair.X, this->Pair.X) *
        SumOfProducts(Centered(this->Pair.Y), Centered(this->Pair.Y)));
      this->Observed = std::fabs(SumOfProducts(this->Pair.X, this->Pair.Y)) / this->Scale;
    }
  }

  bool HasValue() const { return this->IsDefined; }

  /** Y in an arrangement: the same for all pairs with that Y where no value is missing. */
  const std::vector<double>& Arrange(const std::vector<std::size_t>& rows)
  {
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      this->Y[i] = this->Pair.Y[rows[i]];
    }
    return this->Y;
  }
  bool SharesArrangements() const { return this->ByProducts; }

  bool IsHit(const std::vector<double>& y)
  {
    const double value = this->ByProducts ? std::fabs(SumOfProducts(this->Pair.X, y)) / this->Scale
                                          : this->Evaluate(y);
    return value >= this->Observed - 1e-12; // the same arrangement by another name is one too
  }

private:
  double Evaluate(const std::vector<double>& y)
  {
    RemoveMissing(this->Pair.X, y, this->KeptX, this->KeptY);
    return std::fabs(this->Compute(this->KeptX, this->KeptY));
  }

  PreparedPair Pair;
  double (*Compute)(std::span<const double>, std::span<const double>);
  bool ByProducts;
  bool IsDefined = false;
  double Observed = 0.0;
  double Scale = 1.0;
  std::vector<double> Y;
  std::vector<double> KeptX;
  std::vector<double> KeptY;
};

/** Pairs with the same Y, so that it is arranged once for all of them. */
using PairGroup = std::vector<std::size_t>;

std::vector<PairGroup> GroupByY(const PairsOfColumns& pairs, std::size_t most)
{
  std::map<std::size_t, std::size_t> last; // of Y, the group that is not full
  std::vector<PairGroup> groups;
  for (std::size_t pair = 0; pair < pairs.Pairs.size(); ++pair)
  {
    const auto [place, isNew] = last.emplace(pairs.Pairs[pair].second, groups.size());
    if (isNew || groups[place->second].size() == most)
    {
      place->second = groups.size();
      groups.emplace_back();
    }
    groups[place->second].push_back(pair);
  }
  return groups;
}

/** Calls `body(group)` for all groups, portion by portion; false where it was told to stop. */
bool ForEachGroup(const std::vector<PairGroup>& groups, std::size_t portion,
  const TestProgress& progress, const std::function<void(const PairGroup&)>& body)
{
  for (std::size_t first = 0; first < groups.size(); first += portion)
  {
    const std::size_t last = std::min(first + portion, groups.size());
    ParallelLoop(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 1,
      [&](vtkIdType from, vtkIdType to)
      {
        for (vtkIdType group = from; group < to; ++group)
        {
          body(groups[static_cast<std::size_t>(group)]);
        }
      });
    if (progress && !progress(static_cast<double>(last) / static_cast<double>(groups.size())))
    {
      return false;
    }
  }
  return true;
}

/** Adds to `hits` those of the pairs of a group in some arrangements; NaN without a coefficient. */
void CountHits(const PairsOfColumns& pairs, const CoefficientKind& kind, const PairGroup& group,
  const std::vector<std::vector<std::size_t>>& arrangements, std::vector<double>& hits)
{
  std::vector<ArrangedStatistic> statistics;
  for (const std::size_t pair : group)
  {
    statistics.emplace_back(PreparePair(pairs, pair, kind), kind);
  }
  for (const std::vector<std::size_t>& arrangement : arrangements)
  {
    const std::vector<double>* shared = nullptr;
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      ArrangedStatistic& statistic = statistics[i];
      if (!statistic.HasValue())
      {
        hits[group[i]] = Undefined;
        continue;
      }
      const bool isShared = statistic.SharesArrangements();
      const std::vector<double>* y = isShared && shared ? shared : &statistic.Arrange(arrangement);
      shared = isShared ? y : shared;
      hits[group[i]] += statistic.IsHit(*y) ? 1.0 : 0.0;
    }
  }
}

/** As many as are worth preparing the pairs for, and as memory holds; none at the end. */
std::vector<std::vector<std::size_t>> NextArrangements(FamilyShuffle& shuffle, std::size_t rows)
{
  constexpr std::size_t most = 512;
  std::vector<std::vector<std::size_t>> arrangements;
  std::vector<std::size_t> next(rows);
  while (arrangements.size() < most && shuffle.Next(next))
  {
    arrangements.push_back(next);
  }
  return arrangements;
}

} // namespace

bool HasArrangements(const PairsOfColumns& pairs, const CoefficientKind& kind)
{
  return pairs.Given.empty() || kind.IsPearson;
}

std::vector<double> FamilyPValues(const PairsOfColumns& pairs, const CoefficientKind& kind,
  const RowFamilies& families, int permutations, std::uint64_t seed, const TestProgress& progress)
{
  const std::size_t rows = pairs.Columns.empty() ? 0 : pairs.Columns.front().size();
  FamilyShuffle shuffle(families, permutations, seed); // every pair sees the same arrangements
  const int count = shuffle.GetCount();
  if (count == 0 || !HasArrangements(pairs, kind))
  {
    return std::vector<double>(pairs.Pairs.size(), Undefined);
  }
  std::vector<double> p(pairs.Pairs.size(), 1.0); // hits, the given arrangement being one
  const std::vector<PairGroup> groups = GroupByY(pairs, kind.IsPearson ? 32 : 1);
  const std::size_t portion = 8; // groups between two reports of progress, well within a second
  int done = 0;
  for (auto block = NextArrangements(shuffle, rows); !block.empty();
       block = NextArrangements(shuffle, rows))
  {
    const auto part = [&](double fraction)
    {
      return !progress ||
        progress(
          (done + fraction * static_cast<double>(block.size())) / static_cast<double>(count));
    };
    const bool goesOn = ForEachGroup(groups, portion, part,
      [&](const PairGroup& group) { CountHits(pairs, kind, group, block, p); });
    if (!goesOn)
    {
      return {};
    }
    done += static_cast<int>(block.size());
  }
  for (double& hits : p)
  {
    hits /= 1.0 + count;
  }
  return p;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Significance.h"

#include "Correlation.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

namespace pemesh
{

namespace
{

constexpr PValue UndefinedPValue{ std::numeric_limits<double>::quiet_NaN(),
  PValueMethod::Undefined };
constexpr std::size_t LargestExactSpearman = 12; // 2^n subsets are walked
constexpr std::size_t LargestExactKendall = 50;
constexpr std::size_t LargestExactWithTies = 8; // n! arrangements are walked

bool HasPValue(std::span<const double> x, std::span<const double> y)
{
  return x.size() >= 3 && !IsConstant(x) && !IsConstant(y);
}

bool HasTies(std::span<const double> sample)
{
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

PValue StudentPValue(double coefficient, std::size_t n)
{
  if (std::isnan(coefficient))
  {
    return UndefinedPValue;
  }
  const double freedom = static_cast<double>(n) - 2.0;
  const double rest = (1.0 - coefficient) * (1.0 + coefficient);
  if (rest <= 0.0)
  {
    return { 0.0, PValueMethod::Asymptotic };
  }
  const double t = std::fabs(coefficient) * std::sqrt(freedom / rest);
  const boost::math::students_t distribution(freedom);
  return { 2.0 * boost::math::cdf(boost::math::complement(distribution, t)),
    PValueMethod::Asymptotic };
}

/** A table for each n, made when first asked for, by whichever thread asks first. */
class TablesByCount
{
public:
  using Maker = std::vector<double> (*)(std::size_t);

  explicit TablesByCount(Maker make)
    : Make(make)
  {
  }

  /** Stays where it is, because a map never moves its values. */
  const std::vector<double>& Get(std::size_t n)
  {
    const std::lock_guard lock(this->Mutex);
    auto found = this->Tables.find(n);
    if (found == this->Tables.end())
    {
      found = this->Tables.emplace(n, this->Make(n)).first;
    }
    return found->second;
  }

private:
  Maker Make;
  std::mutex Mutex;
  std::map<std::size_t, std::vector<double>> Tables;
};

/**
 * Number of permutations of 1 … n with sum of i pi(i) = T, for every T. Positions are filled in
 * order; what matters of those before is only the set of values used.
 */
std::vector<double> CountSpearmanSums(std::size_t n)
{
  const std::size_t largest = n * (n + 1) * (2 * n + 1) / 6;
  const std::size_t sets = std::size_t{ 1 } << n;
  std::vector<std::vector<double>> counts(sets);
  counts[0].assign(largest + 1, 0.0);
  counts[0][0] = 1.0;
  for (std::size_t set = 0; set < sets; ++set)
  {
    std::size_t position = 1;
    for (std::size_t value = 0; value < n; ++value)
    {
      position += (set >> value) & 1U;
    }
    for (std::size_t value = 0; value < n; ++value)
    {
      if ((set >> value) & 1U)
      {
        continue;
      }
      std::vector<double>& next = counts[set | (std::size_t{ 1 } << value)];
      next.resize(largest + 1, 0.0);
      const std::size_t product = position * (value + 1);
      for (std::size_t sum = 0; sum + product <= largest; ++sum)
      {
        next[sum + product] += counts[set][sum];
      }
    }
    if (set + 1 < sets)
    {
      std::vector<double>().swap(counts[set]);
    }
  }
  return counts.back();
}

/** Share of the permutations of n things that have k inversions, for every k. */
std::vector<double> ShareOfInversions(std::size_t n)
{
  std::vector<double> shares{ 1.0 };
  for (std::size_t size = 2; size <= n; ++size)
  {
    // The new largest thing makes 0 … size - 1 inversions, each with the same chance.
    std::vector<double> next(shares.size() + size - 1, 0.0);
    for (std::size_t k = 0; k < shares.size(); ++k)
    {
      for (std::size_t more = 0; more < size; ++more)
      {
        next[k + more] += shares[k] / static_cast<double>(size);
      }
    }
    shares = std::move(next);
  }
  return shares;
}

/** `score` of the sums of products of centred ranks; all are exact integers. */
double ExactSpearman(std::size_t n, double score)
{
  static TablesByCount tables(CountSpearmanSums);
  const std::vector<double>& counts = tables.Get(n);
  const auto size = static_cast<double>(n);
  double hits = 0.0;
  double all = 0.0;
  for (std::size_t sum = 0; sum < counts.size(); ++sum)
  {
    const double centered = 4.0 * static_cast<double>(sum) - size * (size + 1.0) * (size + 1.0);
    hits += std::fabs(centered) >= std::fabs(score) ? counts[sum] : 0.0;
    all += counts[sum];
  }
  return hits / all;
}

double ExactKendall(std::size_t n, std::int64_t score)
{
  static TablesByCount tables(ShareOfInversions);
  const std::vector<double>& shares = tables.Get(n);
  const auto pairs = static_cast<std::int64_t>(shares.size()) - 1;
  double p = 0.0;
  for (std::int64_t k = 0; k <= pairs; ++k)
  {
    p += std::abs(pairs - 2 * k) >= std::abs(score) ? shares[static_cast<std::size_t>(k)] : 0.0;
  }
  return std::min(p, 1.0);
}

/** All distinct arrangements of y are equally likely, so ties cost nothing in exactness. */
template <typename Score>
double ExactByArrangements(std::span<const double> y, Score score)
{
  const double observed = std::fabs(score(y));
  std::vector<double> arrangement(y.begin(), y.end());
  std::sort(arrangement.begin(), arrangement.end());
  double hits = 0.0;
  double all = 0.0;
  do
  {
    hits += std::fabs(score(arrangement)) >= observed ? 1.0 : 0.0;
    all += 1.0;
  } while (std::next_permutation(arrangement.begin(), arrangement.end()));
  return hits / all;
}

/** The normal approximation of the score, its variance corrected for ties (Kendall 1970). */
double NormalKendall(std::span<const double> x, std::span<const double> y)
{
  const auto tieSums = [](std::span<const double> sample)
  {
    std::vector<double> sorted(sample.begin(), sample.end());
    std::sort(sorted.begin(), sorted.end());
    struct
    {
      double Two = 0.0;   // sum of t (t - 1)
      double Three = 0.0; // sum of t (t - 1) (t - 2)
      double Five = 0.0;  // sum of t (t - 1) (2 t + 5)
    } sums;
    for (auto first = sorted.begin(); first != sorted.end();)
    {
      const auto last = std::upper_bound(first, sorted.end(), *first);
      const auto t = static_cast<double>(last - first);
      sums.Two += t * (t - 1);
      sums.Three += t * (t - 1) * (t - 2);
      sums.Five += t * (t - 1) * (2 * t + 5);
      first = last;
    }
    return sums;
  };
  const auto n = static_cast<double>(x.size());
  const auto ofX = tieSums(x);
  const auto ofY = tieSums(y);
  const double variance = (n * (n - 1) * (2 * n + 5) - ofX.Five - ofY.Five) / 18 +
    ofX.Three * ofY.Three / (9 * n * (n - 1) * (n - 2)) + ofX.Two * ofY.Two / (2 * n * (n - 1));
  const double z =
    std::fabs(static_cast<double>(CountKendallPairs(x, y).Score())) / std::sqrt(variance);
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

/** With ties or many pairs: all arrangements, or the limit where these are out of reach. */
template <typename Score, typename Limit>
PValue PValueByArrangements(std::span<const double> y, Score score, Limit limit)
{
  if (y.size() <= LargestExactWithTies)
  {
    return { ExactByArrangements(y, score), PValueMethod::Exact };
  }
  return { limit(), PValueMethod::Asymptotic };
}

} // namespace

const char* PValueMethodName(PValueMethod method)
{
  switch (method)
  {
    case PValueMethod::Exact:
      return "exact";
    case PValueMethod::Asymptotic:
      return "asymptotic";
    default:
      return "undefined";
  }
}

PValue PearsonPValue(std::span<const double> x, std::span<const double> y)
{
  return HasPValue(x, y) ? StudentPValue(PearsonCorrelation(x, y), x.size()) : UndefinedPValue;
}

PValue SpearmanPValue(std::span<const double> x, std::span<const double> y)
{
  if (!HasPValue(x, y))
  {
    return UndefinedPValue;
  }
  const std::vector<double> ranksX = CenteredRanks(x);
  const std::vector<double> ranksY = CenteredRanks(y);
  const auto score = [&](std::span<const double> arrangement)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < ranksX.size(); ++i)
    {
      sum += ranksX[i] * arrangement[i];
    }
    return sum;
  };
  if (x.size() <= LargestExactSpearman && !HasTies(x) && !HasTies(y))
  {
    return { ExactSpearman(x.size(), score(ranksY)), PValueMethod::Exact };
  }
  return PValueByArrangements(
    ranksY, score, [&] { return StudentPValue(SpearmanCorrelation(x, y), x.size()).Value; });
}

PValue KendallPValue(std::span<const double> x, std::span<const double> y)
{
  if (!HasPValue(x, y))
  {
    return UndefinedPValue;
  }
  if (x.size() <= LargestExactKendall && !HasTies(x) && !HasTies(y))
  {
    return { ExactKendall(x.size(), CountKendallPairs(x, y).Score()), PValueMethod::Exact };
  }
  const auto score = [&](std::span<const double> arrangement)
  { return static_cast<double>(CountKendallPairs(x, arrangement).Score()); };
  return PValueByArrangements(y, score, [&] { return NormalKendall(x, y); });
}

} // namespace pemesh

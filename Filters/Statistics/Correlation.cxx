// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/** The deviations from the mean, scaled so that squares neither overflow nor vanish. */
std::vector<double> Deviations(std::span<const double> sample)
{
  const auto [least, greatest] = std::minmax_element(sample.begin(), sample.end());
  // Halves, because the difference of the extremes may overflow.
  const double middle = *least / 2 + *greatest / 2;
  const double width = *greatest / 2 - *least / 2;
  std::vector<double> deviations(sample.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    deviations[i] = (sample[i] - middle) / width;
    sum += deviations[i];
  }
  const double mean = sum / static_cast<double>(sample.size());
  for (double& deviation : deviations)
  {
    deviation -= mean;
  }
  return deviations;
}

/** sum u v / sqrt(sum u^2 sum v^2) of deviations. */
double Cosine(const std::vector<double>& u, const std::vector<double>& v)
{
  double uv = 0.0;
  double uu = 0.0;
  double vv = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    uv += u[i] * v[i];
    uu += u[i] * u[i];
    vv += v[i] * v[i];
  }
  return std::clamp(uv / std::sqrt(uu * vv), -1.0, 1.0);
}

std::int64_t PairsOf(std::size_t n)
{
  const auto count = static_cast<std::int64_t>(n);
  return count * (count - 1) / 2;
}

/** Pairs within runs of observations that `same` says are tied with their predecessor. */
template <typename Same>
std::int64_t CountTies(std::size_t n, Same same)
{
  std::int64_t ties = 0;
  std::size_t run = 1;
  for (std::size_t i = 1; i <= n; ++i)
  {
    if (i < n && same(i - 1, i))
    {
      ++run;
      continue;
    }
    ties += PairsOf(run);
    run = 1;
  }
  return ties;
}

/** Sorts, and counts the exchanges of neighbours that a bubble sort would need. */
std::int64_t SortCountingExchanges(std::span<double> values, std::span<double> scratch)
{
  const std::size_t n = values.size();
  if (n < 2)
  {
    return 0;
  }
  const std::size_t half = n / 2;
  std::int64_t exchanges = SortCountingExchanges(values.first(half), scratch.first(half)) +
    SortCountingExchanges(values.subspan(half), scratch.subspan(half));
  std::size_t left = 0;
  std::size_t right = half;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (right == n || (left < half && values[left] <= values[right]))
    {
      scratch[i] = values[left++];
    }
    else
    {
      exchanges += static_cast<std::int64_t>(half - left);
      scratch[i] = values[right++];
    }
  }
  std::copy(scratch.begin(), scratch.end(), values.begin());
  return exchanges;
}

} // namespace

void RemoveMissing(std::span<const double> x, std::span<const double> y, std::vector<double>& keptX,
  std::vector<double>& keptY)
{
  keptX.clear();
  keptY.clear();
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
  {
    if (!std::isnan(x[i]) && !std::isnan(y[i]))
    {
      keptX.push_back(x[i]);
      keptY.push_back(y[i]);
    }
  }
}

bool IsConstant(std::span<const double> sample)
{
  return std::all_of(
    sample.begin(), sample.end(), [&](double value) { return value == sample.front(); });
}

std::vector<double> CenteredRanks(std::span<const double> sample)
{
  const std::size_t n = sample.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return sample[a] < sample[b]; });
  std::vector<double> ranks(n);
  for (std::size_t first = 0; first < n;)
  {
    std::size_t last = first;
    while (last + 1 < n && sample[order[last + 1]] == sample[order[first]])
    {
      ++last;
    }
    // Ranks first + 1 … last + 1: twice their average is first + last + 2.
    const double rank = static_cast<double>(first + last + 2) - static_cast<double>(n + 1);
    for (std::size_t i = first; i <= last; ++i)
    {
      ranks[order[i]] = rank;
    }
    first = last + 1;
  }
  return ranks;
}

double PearsonCorrelation(std::span<const double> x, std::span<const double> y)
{
  const auto infinite = [](double value) { return !std::isfinite(value); };
  if (IsConstant(x) || IsConstant(y) || std::any_of(x.begin(), x.end(), infinite) ||
    std::any_of(y.begin(), y.end(), infinite))
  {
    return Undefined;
  }
  return Cosine(Deviations(x), Deviations(y));
}

double SpearmanCorrelation(std::span<const double> x, std::span<const double> y)
{
  if (IsConstant(x) || IsConstant(y))
  {
    return Undefined;
  }
  return Cosine(CenteredRanks(x), CenteredRanks(y));
}

KendallCounts CountKendallPairs(std::span<const double> x, std::span<const double> y)
{
  const std::size_t n = x.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return x[a] != x[b] ? x[a] < x[b] : y[a] < y[b]; });
  KendallCounts counts;
  counts.Pairs = PairsOf(n);
  counts.TiesX =
    CountTies(n, [&](std::size_t i, std::size_t j) { return x[order[i]] == x[order[j]]; });
  counts.TiesBoth = CountTies(n,
    [&](std::size_t i, std::size_t j)
    { return x[order[i]] == x[order[j]] && y[order[i]] == y[order[j]]; });
  std::vector<double> sorted(n);
  std::transform(order.begin(), order.end(), sorted.begin(), [&](std::size_t i) { return y[i]; });
  std::vector<double> scratch(n);
  counts.Discordant = SortCountingExchanges(sorted, scratch);
  counts.TiesY = CountTies(n, [&](std::size_t i, std::size_t j) { return sorted[i] == sorted[j]; });
  return counts;
}

double KendallTauB(const KendallCounts& counts)
{
  const auto untiedX = static_cast<double>(counts.Pairs - counts.TiesX);
  const auto untiedY = static_cast<double>(counts.Pairs - counts.TiesY);
  if (untiedX == 0.0 || untiedY == 0.0)
  {
    return Undefined;
  }
  return std::clamp(static_cast<double>(counts.Score()) / std::sqrt(untiedX * untiedY), -1.0, 1.0);
}

} // namespace pemesh

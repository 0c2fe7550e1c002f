// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace pemesh
{

namespace
{

/** Places with weights that add up to one. */
struct WeightedSample
{
  std::vector<double> X;
  std::vector<double> Weights;
};

WeightedSample ShareOut(std::span<const double> sorted)
{
  constexpr std::size_t most = 1000;
  const std::size_t n = sorted.size();
  WeightedSample sample;
  if (n <= most)
  {
    sample.X.assign(sorted.begin(), sorted.end());
    sample.Weights.assign(n, 1.0 / static_cast<double>(n));
    return sample;
  }
  const double step = (sorted.back() - sorted.front()) / (most - 1);
  sample.Weights.assign(most, 0.0);
  for (std::size_t i = 0; i < most; ++i)
  {
    sample.X.push_back(sorted.front() + static_cast<double>(i) * step);
  }
  for (const double value : sorted)
  {
    const double place = (value - sorted.front()) / step;
    const auto before = std::min(static_cast<std::size_t>(place), most - 2);
    const double part = place - static_cast<double>(before);
    sample.Weights[before] += (1.0 - part) / static_cast<double>(n);
    sample.Weights[before + 1] += part / static_cast<double>(n);
  }
  return sample;
}

double ChooseBandwidth(std::span<const double> sorted)
{
  const auto n = static_cast<double>(sorted.size());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / n;
  double sum = 0.0;
  for (const double value : sorted)
  {
    sum += (value - mean) * (value - mean);
  }
  const double deviation = std::sqrt(sum / (n - 1.0));
  const double box = (SortedQuantile(sorted, 0.75) - SortedQuantile(sorted, 0.25)) / 1.34;
  return 0.9 * (box > 0.0 ? std::min(deviation, box) : deviation) * std::pow(n, -0.2);
}

} // namespace

double SortedQuantile(std::span<const double> sorted, double probability)
{
  if (sorted.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), sorted.size() - 1);
  const std::size_t after = std::min(before + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(before);
  return (1.0 - part) * sorted[before] + part * sorted[after];
}

BoxStatistics DescribeBox(std::span<const double> sorted)
{
  BoxStatistics box = {};
  box.LowerQuartile = SortedQuantile(sorted, 0.25);
  box.Median = SortedQuantile(sorted, 0.5);
  box.UpperQuartile = SortedQuantile(sorted, 0.75);
  const double reach = 1.5 * (box.UpperQuartile - box.LowerQuartile);
  box.LowerWhisker = box.LowerQuartile;
  box.UpperWhisker = box.UpperQuartile;
  for (const double value : sorted)
  {
    if (value >= box.LowerQuartile - reach && value <= box.UpperQuartile + reach)
    {
      box.LowerWhisker = std::min(box.LowerWhisker, value);
      box.UpperWhisker = std::max(box.UpperWhisker, value);
    }
  }
  return box;
}

int ChooseBins(std::span<const double> sorted)
{
  // Halves, because the whole range may be more than a number holds.
  const double range = sorted.empty() ? 0.0 : 0.5 * sorted.back() - 0.5 * sorted.front();
  if (!(range > 0.0))
  {
    return 1;
  }
  const auto n = static_cast<double>(sorted.size());
  const double box = 0.5 * SortedQuantile(sorted, 0.75) - 0.5 * SortedQuantile(sorted, 0.25);
  const double bins =
    box > 0.0 ? range / (2.0 * box * std::pow(n, -1.0 / 3.0)) : std::log2(n) + 1.0;
  return static_cast<int>(std::clamp(std::ceil(bins), 1.0, 200.0));
}

double BinStart(int bin, double low, double high, int bins)
{
  const double part = static_cast<double>(bin) / bins;
  return (1.0 - part) * low + part * high;
}

int BinOf(double value, double low, double high, int bins)
{
  const double part = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low);
  return std::clamp(static_cast<int>(part * bins), 0, bins - 1);
}

DensityCurve EstimateDensity(std::span<const double> sorted, int points, bool cut)
{
  DensityCurve curve;
  if (sorted.size() < 2 || !(sorted.back() > sorted.front()))
  {
    return curve;
  }
  const double bandwidth = ChooseBandwidth(sorted);
  constexpr double most = 1e300; // of what can be added and subtracted
  if (!(bandwidth > 0.0) || !(std::fabs(sorted.front()) < most) ||
    !(std::fabs(sorted.back()) < most))
  {
    return curve;
  }
  curve.Bandwidth = bandwidth;
  const WeightedSample sample = ShareOut(sorted);
  const double margin = cut ? 0.0 : 3.0 * curve.Bandwidth;
  const double low = sorted.front() - margin;
  const double step = (sorted.back() + margin - low) / (points - 1);
  const double scale = 1.0 / (curve.Bandwidth * std::sqrt(2.0 * std::numbers::pi));
  for (int i = 0; i < points; ++i)
  {
    const double x = low + i * step;
    double density = 0.0;
    for (std::size_t j = 0; j < sample.X.size(); ++j)
    {
      const double z = (x - sample.X[j]) / curve.Bandwidth;
      density += sample.Weights[j] * std::exp(-0.5 * z * z);
    }
    curve.X.push_back(x);
    curve.Y.push_back(scale * density);
  }
  return curve;
}

} // namespace pemesh

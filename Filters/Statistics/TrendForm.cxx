// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TrendForm.h"

#include "Correlation.h"
#include "RelationWords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<FormKind, 3> Kinds{ {
  { "linear", "a straight line", "slope", false, false },
  { "power-law", "a power law", "exponent", true, true },
  { "exponential", "an exponential", "rate", false, true },
} };

/** The sample, or its logarithms; nothing where they do not exist. */
std::optional<std::vector<double>> InScale(std::span<const double> sample, bool isLog)
{
  std::vector<double> scaled(sample.begin(), sample.end());
  if (!isLog)
  {
    return scaled;
  }
  for (double& value : scaled)
  {
    if (value <= 0.0)
    {
      return std::nullopt;
    }
    value = std::log(value);
  }
  return scaled;
}

double MeanOf(const std::vector<double>& sample)
{
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

/** The length of what is left of the sample without its mean. */
double SpreadOf(const std::vector<double>& sample)
{
  const double mean = MeanOf(sample);
  double squares = 0.0;
  for (const double value : sample)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares);
}

double LargestSize(std::span<const double> sample)
{
  double largest = 0.0;
  for (const double value : sample)
  {
    largest = std::max(largest, std::fabs(value));
  }
  return largest;
}

/** In units of `unit`, so that neither sums nor squares overflow. */
std::vector<double> InUnits(std::span<const double> sample, double unit)
{
  std::vector<double> scaled(sample.begin(), sample.end());
  for (double& value : scaled)
  {
    value /= unit;
  }
  return scaled;
}

bool IsUsable(std::span<const double> sample)
{
  return sample.size() >= 3 && !IsConstant(sample) &&
    std::all_of(sample.begin(), sample.end(), [](double value) { return std::isfinite(value); });
}

bool IsMonotone(std::span<const double> x, std::span<const double> y)
{
  const KendallCounts counts = CountKendallPairs(x, y);
  return counts.Discordant == 0 || counts.Concordant() == 0 ||
    std::fabs(SpearmanCorrelation(x, y)) >= StrongFrom;
}

} // namespace

std::span<const FormKind> FormKinds()
{
  return Kinds;
}

TrendForm FindTrendForm(std::span<const double> x, std::span<const double> y)
{
  TrendForm form{ "undefined", Undefined, Undefined };
  if (!IsUsable(x) || !IsUsable(y))
  {
    return form;
  }
  form.Name = IsMonotone(x, y) ? "monotone" : "none";
  const double unitX = LargestSize(x); // not 0, because x is not constant
  const double unitY = LargestSize(y);
  const std::vector<double> scaledX = InUnits(x, unitX);
  const std::vector<double> scaledY = InUnits(y, unitY);
  double least = std::numeric_limits<double>::infinity();
  for (const FormKind& kind : Kinds)
  {
    const auto u = InScale(scaledX, kind.LogX);
    const auto v = InScale(scaledY, kind.LogY);
    if (!u || !v || IsConstant(*u) || IsConstant(*v)) // logarithms of neighbours may coincide
    {
      continue;
    }
    const double r = PearsonCorrelation(*u, *v);
    const double spread = SpreadOf(*v);
    const double mean = kind.LogY ? std::exp(MeanOf(*v)) : 1.0; // geometric, as Box and Cox ask
    const double distance = mean * spread * std::sqrt(std::max(0.0, (1.0 - r) * (1.0 + r)));
    if (r * r >= NamedFit && distance < least)
    {
      const double slope = r * spread / SpreadOf(*u);
      form = { kind.Name, slope * (kind.LogY ? 1.0 : unitY) / (kind.LogX ? 1.0 : unitX), r * r };
      least = distance;
    }
  }
  return form;
}

} // namespace pemesh

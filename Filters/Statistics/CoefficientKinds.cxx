// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CoefficientKinds.h"

#include "Correlation.h"
#include "DistanceCorrelation.h"
#include "PartialCorrelation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pemesh
{

namespace
{

double Kendall(std::span<const double> x, std::span<const double> y)
{
  return KendallTauB(CountKendallPairs(x, y));
}

constexpr std::array<CoefficientKind, 4> Kinds{ {
  { "spearman", "Spearman", "monotone relation, from ranks", true, true, true, PearsonCorrelation,
    SpearmanPValue, PartialCorrelation },
  { "pearson", "Pearson", "linear relation", false, true, true, PearsonCorrelation, PearsonPValue,
    PartialCorrelation },
  { "kendall", "Kendall", "monotone relation, from the order of pairs (tau-b)", false, true, false,
    Kendall, KendallPValue, PartialKendall },
  { "distance", "distance correlation", "any relation; no direction", false, false, false,
    DistanceCorrelation, nullptr, PartialDistanceCorrelation },
} };

} // namespace

std::span<const CoefficientKind> CoefficientKinds()
{
  return Kinds;
}

const CoefficientKind* FindCoefficientKind(const std::string& name)
{
  const auto found = std::find_if(
    Kinds.begin(), Kinds.end(), [&](const CoefficientKind& kind) { return name == kind.Name; });
  return found == Kinds.end() ? nullptr : &*found;
}

double ComputeCoefficient(
  const CoefficientKind& kind, std::span<const double> x, std::span<const double> y)
{
  return kind.OfRanks ? kind.Compute(CenteredRanks(x), CenteredRanks(y)) : kind.Compute(x, y);
}

std::vector<double> PrepareSample(const CoefficientKind& kind, std::span<const double> sample)
{
  std::vector<double> prepared(sample.begin(), sample.end());
  if (!kind.OfRanks)
  {
    return prepared;
  }
  std::vector<double> present;
  std::copy_if(sample.begin(), sample.end(), std::back_inserter(present),
    [](double value) { return !std::isnan(value); });
  const std::vector<double> ranks = CenteredRanks(present);
  std::size_t next = 0;
  for (double& value : prepared)
  {
    value = std::isnan(value) ? value : ranks[next++];
  }
  return prepared;
}

double CoefficientGiven(const CoefficientKind& kind, std::span<const double> x,
  std::span<const double> y, const std::vector<std::span<const double>>& given)
{
  std::vector<double> keptX;
  std::vector<double> keptY;
  std::vector<std::vector<double>> kept(given.size());
  for (std::size_t row = 0; row < x.size(); ++row)
  {
    const bool missing = std::isnan(x[row]) || std::isnan(y[row]) ||
      std::any_of(given.begin(), given.end(), [&](const auto& g) { return std::isnan(g[row]); });
    if (missing)
    {
      continue;
    }
    keptX.push_back(x[row]);
    keptY.push_back(y[row]);
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      kept[i].push_back(given[i][row]);
    }
  }
  if (given.empty())
  {
    return ComputeCoefficient(kind, keptX, keptY);
  }
  if (kind.OfRanks)
  {
    keptX = CenteredRanks(keptX);
    keptY = CenteredRanks(keptY);
    std::transform(
      kept.begin(), kept.end(), kept.begin(), [](const auto& g) { return CenteredRanks(g); });
  }
  return kind.Partial(keptX, keptY, kept);
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TrendForm.h"

#include "Correlation.h"
#include "CurveFit.h"
#include "RelationWords.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

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

TrendForm FindTrendForm(std::span<const double> x, std::span<const double> y)
{
  TrendForm form{ "undefined", Undefined, Undefined };
  if (!IsUsable(x) || !IsUsable(y))
  {
    return form;
  }
  const std::optional<CurveFit> fit = FitBestCurve(x, y, NamedFit);
  if (fit && fit->LeftOut == 0)
  {
    return { fit->Kind().Name, fit->B, fit->RSquared };
  }
  form.Name = IsMonotone(x, y) ? "monotone" : "none";
  return form;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RelationWords.h"

#include "CurveFit.h"
#include "NumberText.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

std::string StrengthWord(double coefficient)
{
  const double size = std::fabs(coefficient);
  return std::isnan(coefficient) ? "undefined"
    : size >= StrongFrom         ? "strong"
    : size >= ModerateFrom       ? "moderate"
                                 : "weak";
}

std::string DirectionWord(double coefficient)
{
  constexpr double rounding = 1e-12;
  return std::isnan(coefficient) ? "undefined"
    : coefficient > rounding     ? "positive"
    : coefficient < -rounding    ? "negative"
                                 : "none";
}

std::string RoundedNumber(double value)
{
  if (!std::isfinite(value) || value == 0.0)
  {
    return FormatNumber(value);
  }
  // The shortest text of a number with two digits, so that no locale has a say.
  const double exponent = std::floor(std::log10(std::fabs(value)));
  const double unit = std::pow(10.0, std::fabs(exponent - 1.0));
  const double rounded =
    exponent >= 1.0 ? std::round(value / unit) * unit : std::round(value * unit) / unit;
  return FormatNumber(rounded);
}

std::string RelationWords(double strength, double direction, const TrendForm& form)
{
  if (std::isnan(strength))
  {
    return "undefined";
  }
  std::string words = StrengthWord(strength);
  const std::string sign = DirectionWord(direction);
  words += sign == "positive" || sign == "negative" ? " " + sign : ", of no direction";
  const auto kinds = FormKinds();
  const auto kind = std::find_if(
    kinds.begin(), kinds.end(), [&](const FormKind& known) { return form.Name == known.Name; });
  if (kind != kinds.end())
  {
    words += std::string(form.Fit >= ExactFit ? ", " : ", close to ") + kind->Label + " with " +
      kind->Parameter + " " + RoundedNumber(form.Parameter);
  }
  else if (form.Name == "monotone")
  {
    words += ", monotone but of no simple form";
  }
  return words;
}

} // namespace pemesh

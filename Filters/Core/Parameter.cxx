// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Parameter.h"

#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

/** 100000 rather than 1e+05. */
std::string Show(double value)
{
  const bool isInteger = value == std::trunc(value) && std::abs(value) <= 0x1p53;
  return isInteger ? std::to_string(static_cast<long long>(value)) : FormatNumber(value);
}

std::string RangeText(const Parameter& parameter)
{
  const std::string least = Show(parameter.Least);
  return std::isfinite(parameter.Greatest) ? "between " + least + " and " + Show(parameter.Greatest)
                                           : "at least " + least;
}

} // namespace

std::string Parameter::WhyInvalid(double value) const
{
  // False for NaN as well.
  const bool isInRange = value >= this->Least && value <= this->Greatest;
  const bool isRightKind = !this->IsInteger || value == std::trunc(value);
  return isInRange && isRightKind ? std::string()
                                  : std::string(this->Name) + " is " + Show(value) +
      "; it must be " + (this->IsInteger ? "an integer " : "") + RangeText(*this) + ".";
}

const Parameter* FindParameter(std::span<const Parameter> parameters, std::string_view name)
{
  const auto found = std::find_if(parameters.begin(), parameters.end(),
    [name](const Parameter& parameter) { return name == parameter.Name; });
  return found == parameters.end() ? nullptr : &*found;
}

ParameterValues::ParameterValues(std::span<const Parameter> parameters)
  : Parameters(parameters)
{
  for (const Parameter& parameter : parameters)
  {
    this->Values.push_back(parameter.Default);
  }
}

std::string ParameterValues::Set(std::string_view name, double value)
{
  const Parameter* parameter = FindParameter(this->Parameters, name);
  if (!parameter)
  {
    std::vector<std::string> names;
    for (const Parameter& known : this->Parameters)
    {
      names.emplace_back(known.Name);
    }
    return "There is no parameter \"" + std::string(name) + "\" here" +
      (names.empty()
          ? "."
          : "; did you mean \"" + std::string(NearestWord(std::string(name), names)) + "\"?");
  }
  std::string why = parameter->WhyInvalid(value);
  if (why.empty())
  {
    this->Values[static_cast<std::size_t>(parameter - this->Parameters.data())] = value;
  }
  return why;
}

double ParameterValues::Get(std::string_view name) const
{
  const Parameter* parameter = FindParameter(this->Parameters, name);
  return parameter ? this->Values[static_cast<std::size_t>(parameter - this->Parameters.data())]
                   : std::numeric_limits<double>::quiet_NaN();
}

} // namespace pemesh

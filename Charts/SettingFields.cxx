// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SettingFields.h"

#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

std::string List(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string DescribeRange(const SettingLimits& limits)
{
  const bool least = std::isfinite(limits.Least);
  const bool greatest = std::isfinite(limits.Greatest);
  return least && greatest
    ? " from " + FormatNumber(limits.Least) + " to " + FormatNumber(limits.Greatest)
    : least    ? " of at least " + FormatNumber(limits.Least)
    : greatest ? " of at most " + FormatNumber(limits.Greatest)
               : "";
}

[[noreturn]] void Fail(
  const SettingLimits& limits, const std::string& text, const std::string& expected)
{
  throw std::runtime_error(
    "The setting " + limits.Name + " is \"" + text + "\"; it must be " + expected + ".");
}

bool IsColorText(const std::string& text)
{
  return text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

} // namespace

std::string SettingText(double value)
{
  return FormatNumber(value);
}

std::string SettingText(int value)
{
  return std::to_string(value);
}

std::string SettingText(bool value)
{
  return value ? "true" : "false";
}

std::string SettingText(const std::string& value)
{
  return value;
}

void ReadSetting(const SettingLimits& limits, const std::string& text, double& value)
{
  const auto number = ParseNumber(text);
  // Where a number may be left unset, NaN is how that is said.
  const bool inside = number && *number >= limits.Least && *number <= limits.Greatest;
  if (!number || !(inside || (std::isnan(*number) && std::isnan(value))))
  {
    Fail(limits, text, "a number" + DescribeRange(limits));
  }
  value = *number;
}

void ReadSetting(const SettingLimits& limits, const std::string& text, int& value)
{
  const auto number = ParseInteger(text);
  if (!number || static_cast<double>(*number) < limits.Least ||
    static_cast<double>(*number) > limits.Greatest)
  {
    Fail(limits, text, "an integer" + DescribeRange(limits));
  }
  value = static_cast<int>(*number);
}

void ReadSetting(const SettingLimits& limits, const std::string& text, bool& value)
{
  if (text != "true" && text != "false")
  {
    Fail(limits, text, "true or false");
  }
  value = text == "true";
}

void ReadSetting(const SettingLimits& limits, const std::string& text, std::string& value)
{
  const auto& choices = limits.Choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end())
  {
    Fail(limits, text,
      "one of " + List(choices) + "; the nearest is \"" + NearestWord(text, choices) + "\"");
  }
  if (limits.IsColor && !IsColorText(text))
  {
    Fail(limits, text, "a colour like #1f77b4");
  }
  value = text;
}

std::string DescribeSetting(const SettingLimits& limits, int memberIndex)
{
  const std::string kinds[] = { "number" + DescribeRange(limits), "integer" + DescribeRange(limits),
    "true or false",
    limits.IsColor             ? "colour #rrggbb"
      : limits.Choices.empty() ? "text"
                               : "one of " + List(limits.Choices) };
  return kinds[memberIndex];
}

void FailUnknownSetting(const std::string& name, const std::vector<std::string>& known)
{
  throw std::runtime_error(
    "There is no setting \"" + name + "\"; the nearest is \"" + NearestWord(name, known) + "\".");
}

} // namespace pemesh

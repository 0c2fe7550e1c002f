// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementSelection.h"

#include "MetricSelection.h"
#include "NumberText.h"

#include <cmath>

namespace pemesh
{

namespace
{

/** A bound; false if the text is no number. An empty text leaves it as it is. */
bool ReadBound(const std::string& text, double& bound)
{
  if (text.empty())
  {
    return true;
  }
  const std::optional<double> number = ParseNumber(text);
  bound = number.value_or(bound);
  return number && !std::isnan(*number);
}

} // namespace

ElementSelection ParseElementSelection(const std::string& text, std::string& fault)
{
  ElementSelection selection;
  const std::size_t second = text.rfind(':');
  const std::size_t first =
    second == std::string::npos || second == 0 ? std::string::npos : text.rfind(':', second - 1);
  const bool isComparison = text.find_first_of("<>=") != std::string::npos;
  if (second == std::string::npos && !isComparison)
  {
    selection.Array = text;
    return selection;
  }
  selection.HasRange = true;
  selection.Array = first == std::string::npos ? std::string() : text.substr(0, first);
  if (selection.Array.empty() || isComparison ||
    !ReadBound(text.substr(first + 1, second - first - 1), selection.Minimum) ||
    !ReadBound(text.substr(second + 1), selection.Maximum))
  {
    fault = "The selection \"" + text + "\" is not " + ElementSelectionForm +
      ": write it like MinAngle:0.1:0.5, or MinAngle::0.5 for all values up to 0.5.";
    return {};
  }
  if (selection.Minimum > selection.Maximum)
  {
    fault = "The selection \"" + text + "\" is empty: it begins at " +
      FormatNumber(selection.Minimum) + " and ends at " + FormatNumber(selection.Maximum) + ".";
    return {};
  }
  return selection;
}

std::string DescribeMissingSelection(const std::string& array)
{
  return "The mesh has no cell array \"" + array +
    "\" to select elements by, and there is no such metric; the nearest metric is \"" +
    MetricNameChoices().Nearest(array) + "\".";
}

} // namespace pemesh

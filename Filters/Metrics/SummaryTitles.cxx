// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SummaryTitles.h"

#include "MeshMetrics.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "ValueStatistics.h"

#include <algorithm>

namespace pemesh
{

namespace
{

std::string WithUnit(const std::string& title, const std::string& unit)
{
  return unit.empty() || unit == "1" ? title : title + " (" + unit + ")";
}

/** "minimum angle MA" */
std::string WordsOf(const Metric& metric)
{
  const std::string label = LowerFirst(metric.Label);
  const std::string symbol = metric.Symbol;
  return symbol.empty() || label.find(symbol) != std::string::npos ? label : label + " " + symbol;
}

/** What a column tells of the values of a metric. */
struct Told
{
  std::string Words; // before the name of the metric; empty: nothing that is known
  bool HasUnit = true;
};

/** Of the part of a column between the metric and the group: "min_element", "q0.05", "bin3". */
Told WhatIsTold(std::string_view part)
{
  constexpr std::string_view ElementEnding = "_element";
  constexpr std::string_view BinStart = "bin";
  if (const Statistic* statistic = FindStatisticBySuffix(part))
  {
    return { statistic->Label, !statistic->IsCount };
  }
  if (part.ends_with(ElementEnding))
  {
    const Statistic* statistic =
      FindStatisticBySuffix(part.substr(0, part.size() - ElementEnding.size()));
    return statistic && statistic->Element
      ? Told{ "element of the " + std::string(statistic->Label), false }
      : Told{};
  }
  if (part.starts_with('q'))
  {
    const std::optional<double> fraction = ParseNumber(part.substr(1));
    return fraction ? Told{ FormatNumber(*fraction) + "-quantile of" } : Told{};
  }
  if (part.starts_with(BinStart) && ParseInteger(part.substr(BinStart.size())))
  {
    return { "elements in bin " + std::string(part.substr(BinStart.size())) + " of", false };
  }
  return {};
}

/** A column of the summary, taken apart. */
struct SummaryColumn
{
  const Metric* OfMetric = nullptr; // null: no such column
  const ElementGroup* Group = nullptr;
  Told What;
};

SummaryColumn TakeApart(std::string_view column)
{
  const std::size_t line = column.find('_');
  const Metric* metric =
    line == std::string_view::npos ? nullptr : FindMetric(column.substr(0, line));
  if (!metric)
  {
    return {};
  }
  const std::string_view ending = column.substr(line + 1);
  for (const ElementGroup& group : ElementGroups())
  {
    const std::string_view suffix = group.Suffix;
    if (ending.ends_with(suffix))
    {
      const Told told = WhatIsTold(ending.substr(0, ending.size() - suffix.size()));
      if (!told.Words.empty())
      {
        return { metric, &group, told };
      }
    }
  }
  return {};
}

} // namespace

std::string LowerFirst(std::string text)
{
  constexpr std::string_view person = "Frobenius"; // keeps its capital
  if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z' &&
    !text.starts_with(person))
  {
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  }
  return text;
}

std::string TitleOfSummaryColumn(std::string_view column)
{
  if (const MeshMetric* metric = FindMeshMetric(column))
  {
    return WithUnit(LowerFirst(metric->Label), metric->Unit);
  }
  if (const Metric* metric = FindMetric(column))
  {
    return WithUnit(WordsOf(*metric), metric->Unit);
  }
  const SummaryColumn parts = TakeApart(column);
  if (!parts.OfMetric)
  {
    return {};
  }
  const std::string where =
    *parts.Group->Label ? ", " + std::string(parts.Group->Label) : std::string();
  return WithUnit(parts.What.Words + " " + WordsOf(*parts.OfMetric) + where,
    parts.What.HasUnit ? parts.OfMetric->Unit : "");
}

bool IsOfSummary(std::string_view column)
{
  return FindMeshMetric(column) || TakeApart(column).OfMetric;
}

bool IsStatisticOfMetric(std::string_view column)
{
  const SummaryColumn parts = TakeApart(column);
  return parts.OfMetric && parts.What.HasUnit;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricRegistry.h"

#include "MetricTables.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace pemesh
{

namespace
{

std::vector<Metric> JoinTables()
{
  std::vector<Metric> all;
  const auto Append = [&all](std::span<const Metric> table, MetricSet set)
  {
    for (const Metric& metric : table)
    {
      all.push_back(metric);
      all.back().Set = set;
    }
  };
  Append(ElementMetricTable(), MetricSet::Measure);
  Append(IndicatorMetricTable(), MetricSet::Indicator);
  const std::vector<Metric> ofElements = all;
  Append(NeighbourMetricTable(), MetricSet::Neighbourhood);
  for (const Metric& metric : ofElements)
  {
    if (metric.Function)
    {
      const Metric jump = MakeJumpMetric(metric);
      Append({ &jump, 1 }, MetricSet::Neighbourhood);
    }
  }
  Append(SolverMetricTable(), MetricSet::Solver);
  return all;
}

constexpr MetricCollection Collections[] = {
  { "all", "Metrics of the shape of elements; what is measured if nothing is said.",
    [](const Metric& metric)
    { return metric.Set == MetricSet::Measure || metric.Set == MetricSet::Indicator; } },
  { "neighbourhood", "Metrics of an element and its neighbours, except jumps.",
    [](const Metric& metric)
    {
      return metric.Set == MetricSet::Neighbourhood &&
        !std::string_view(metric.Name).ends_with("Jump");
    } },
  { "jumps", "The largest jump of each metric of \"all\" to a neighbour.",
    [](const Metric& metric) { return std::string_view(metric.Name).ends_with("Jump"); } },
  { "solver", "Metrics of the stiffness matrix of elements.",
    [](const Metric& metric) { return metric.Set == MetricSet::Solver; } },
};

constexpr const char* NeedWords[] = { "area", "edges", "angles", "distances", "enclosing-circle",
  "inscribed-circle", "kernel-area", "kernel-radius", "corners", "sides", "box", "stiffness",
  "mesh", "neighbours" };

/** Number of letters to change, add or take away (V. I. Levenshtein), case aside. */
std::size_t EditDistance(std::string_view a, std::string_view b)
{
  const auto Lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t change = diagonal + (Lower(a[i]) == Lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ change, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

} // namespace

std::vector<std::string> DescribeNeeds(unsigned int needs)
{
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::size(NeedWords); ++i)
  {
    if ((needs & (1U << i)) != 0)
    {
      words.emplace_back(NeedWords[i]);
    }
  }
  return words;
}

std::span<const Metric> Metrics()
{
  static const std::vector<Metric> metrics = JoinTables();
  return metrics;
}

const Metric* FindMetric(std::string_view name)
{
  const auto found = std::ranges::find_if(Metrics(),
    [name](const Metric& metric)
    { return name == metric.Name || (!name.empty() && name == metric.Alias); });
  return found == Metrics().end() ? nullptr : &*found;
}

const Metric* FindElementMetric(std::string_view name)
{
  const Metric* metric = FindMetric(name);
  return metric && metric->Function ? metric : nullptr;
}

std::vector<std::string> MetricNames()
{
  std::vector<std::string> names;
  for (const Metric& metric : Metrics())
  {
    if (Collections[0].Contains(metric))
    {
      names.emplace_back(metric.Name);
    }
  }
  return names;
}

std::span<const MetricCollection> MetricCollections()
{
  return Collections;
}

std::string MetricTest(const Metric& metric)
{
  return "FiltersMetrics.Metrics/KnownValues.Agree/" + std::string(metric.Name);
}

std::string DescribeUnknownMetric(std::string_view name)
{
  // A symbol ("KAR") is a likely thing to type for a name, so it counts as near.
  const auto Distance = [name](const Metric& metric)
  { return name == metric.Symbol ? std::size_t{ 0 } : EditDistance(name, metric.Name); };
  const auto nearest = std::ranges::min_element(
    Metrics(), [&](const Metric& a, const Metric& b) { return Distance(a) < Distance(b); });
  return "There is no metric \"" + std::string(name) + "\"; the nearest is \"" + nearest->Name +
    "\".";
}

} // namespace pemesh

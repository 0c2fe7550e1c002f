// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricRegistry.h"

#include "MetricTables.h"

#include <algorithm>

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
  const auto AppendJumps = [&Append](std::span<const Metric> table)
  {
    for (const Metric& metric : table)
    {
      if (metric.Function)
      {
        const Metric jump = MakeJumpMetric(metric);
        Append({ &jump, 1 }, MetricSet::Jump);
      }
    }
  };
  Append(ElementMetricTable(), MetricSet::Measure);
  Append(IndicatorMetricTable(), MetricSet::Indicator);
  Append(NeighbourMetricTable(), MetricSet::Neighbourhood);
  AppendJumps(ElementMetricTable());
  AppendJumps(IndicatorMetricTable());
  Append(SolverMetricTable(), MetricSet::Solver);
  AppendJumps(SolverMetricTable());
  return all;
}

constexpr MetricCollection Collections[] = {
  { "all", "Metrics of the shape of elements; what is measured if nothing is said.",
    [](const Metric& metric)
    { return metric.Set == MetricSet::Measure || metric.Set == MetricSet::Indicator; } },
  { "neighbourhood", "Metrics of an element and its neighbours, except jumps.",
    [](const Metric& metric) { return metric.Set == MetricSet::Neighbourhood; } },
  { "jumps", "The largest jump of each metric of \"all\" to a neighbour.",
    [](const Metric& metric)
    { return metric.Set == MetricSet::Jump && (metric.Needs & NeedsStiffness) == 0; } },
  { "solver", "Metrics of the stiffness matrix of elements, and their jumps.",
    [](const Metric& metric) { return (metric.Needs & NeedsStiffness) != 0; } },
};

constexpr const char* NeedWords[] = { "area", "edges", "angles", "distances", "enclosing-circle",
  "inscribed-circle", "kernel-area", "kernel-radius", "corners", "sides", "box", "stiffness",
  "mesh", "neighbours" };

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

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A choice of metrics by name, as the filters of this module keep it.
 */
#ifndef pemesh_MetricSelection_h
#define pemesh_MetricSelection_h

#include "MetricRegistry.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/** The collection of that name; null if there is none. */
inline const MetricCollection* FindMetricCollection(std::string_view name)
{
  for (const MetricCollection& collection : MetricCollections())
  {
    if (name == collection.Name)
    {
      return &collection;
    }
  }
  return nullptr;
}

/** Empty if all names are known, else one sentence about the first that is not. */
inline std::string WhyUnknownMetric(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (!FindMetric(name) && !FindMetricCollection(name))
    {
      return DescribeUnknownMetric(name);
    }
  }
  return {};
}

/** The metrics named, also by alias or collection, each once, in the order of the registry. */
inline std::vector<const Metric*> SelectMetrics(const std::vector<std::string>& names)
{
  std::vector<const Metric*> selected;
  for (const Metric& metric : Metrics())
  {
    const auto isMeant = [&metric](const std::string& name)
    {
      const MetricCollection* collection = FindMetricCollection(name);
      return collection ? collection->Contains(metric) : FindMetric(name) == &metric;
    };
    if (std::ranges::any_of(names, isMeant))
    {
      selected.push_back(&metric);
    }
  }
  return selected;
}

/** The names in the order of the registry, each once: what the filters store. */
inline std::vector<std::string> NormalizeMetricNames(const std::vector<std::string>& names)
{
  std::vector<std::string> normalized;
  for (const Metric* metric : SelectMetrics(names))
  {
    normalized.emplace_back(metric->Name);
  }
  return normalized;
}

} // namespace pemesh

#endif

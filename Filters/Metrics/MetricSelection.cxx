// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricSelection.h"

#include "MeshMetrics.h"
#include "NumberText.h"
#include "ValueStatistics.h"

#include <algorithm>
#include <cctype>

namespace pemesh
{

namespace
{

constexpr const char* AllWord = "all";
constexpr const char* UsualWord = "usual";

std::string ToLower(std::string_view text)
{
  std::string lower(text);
  std::ranges::transform(
    lower, lower.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return lower;
}

template <typename Table>
std::vector<std::string> NamesIn(const Table& table)
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

/** The collection of that name; null if there is none. */
const MetricCollection* FindMetricCollection(std::string_view name)
{
  const auto found = std::ranges::find_if(MetricCollections(),
    [name](const MetricCollection& collection) { return name == collection.Name; });
  return found == MetricCollections().end() ? nullptr : &*found;
}

NameChoices MakeMetricNameChoices()
{
  NameChoices choices{ "metric", NamesIn(Metrics()), {} };
  for (const Metric& metric : Metrics())
  {
    choices.Hints.emplace_back(metric.Symbol, metric.Name);
    if (*metric.Alias)
    {
      choices.Known.emplace_back(metric.Alias);
    }
  }
  return choices;
}

/** Whether a metric is cheap enough to be measured for a number of the mesh that needs it. */
bool IsCheap(const Metric& metric)
{
  constexpr unsigned int Cheap = NeedsArea | NeedsEdges | NeedsDistances;
  return (metric.Needs & ~Cheap) == 0;
}

bool IsUsual(const MeshMetric& metric, const std::vector<std::string>& metrics)
{
  const Metric* base = FindMetric(metric.Base);
  return !base || IsCheap(*base) || std::ranges::count(metrics, metric.Base) > 0;
}

void AddOnce(std::vector<std::string>& names, const std::string& name)
{
  if (std::ranges::count(names, name) == 0)
  {
    names.push_back(name);
  }
}

NamesTaken Take(std::vector<std::string>& own, std::vector<std::string> names)
{
  if (own == names)
  {
    return {};
  }
  own = std::move(names);
  return { .IsChange = true, .Fault = {} };
}

} // namespace

bool NameChoices::Has(std::string_view name) const
{
  return std::ranges::count(this->Known, name) > 0;
}

std::string NameChoices::Nearest(std::string_view name) const
{
  for (const auto& [written, meant] : this->Hints)
  {
    if (name == written)
    {
      return meant;
    }
  }
  std::vector<std::string> lower;
  for (const std::string& known : this->Known)
  {
    lower.push_back(ToLower(known));
  }
  const auto place = std::ranges::find(lower, NearestWord(ToLower(name), lower)) - lower.begin();
  return this->Known[static_cast<std::size_t>(place)];
}

std::string NameChoices::WhyUnknown(const std::vector<std::string>& names) const
{
  for (const std::string& name : names)
  {
    if (!this->Has(name))
    {
      return "There is no " + this->What + " \"" + name + "\"; the nearest is \"" +
        this->Nearest(name) + "\".";
    }
  }
  return {};
}

const NameChoices& MetricNameChoices()
{
  static const NameChoices choices = MakeMetricNameChoices();
  return choices;
}

const NameChoices& MetricChoices()
{
  static const NameChoices choices = []
  {
    NameChoices made = MetricNameChoices();
    for (const MetricCollection& collection : MetricCollections())
    {
      made.Known.emplace_back(collection.Name);
    }
    return made;
  }();
  return choices;
}

const NameChoices& MeshMetricChoices()
{
  static const NameChoices choices = []
  {
    NameChoices made{ "metric of a mesh", MeshMetricNames(), { { "rho", "MeshRho" } } };
    made.Known.insert(made.Known.end(), { UsualWord, AllWord });
    return made;
  }();
  return choices;
}

const NameChoices& StatisticChoices()
{
  static const NameChoices choices{ "statistic", NamesIn(Statistics()), {} };
  return choices;
}

const NameChoices& ElementGroupChoices()
{
  static const NameChoices choices{ "group of elements", NamesIn(ElementGroups()), {} };
  return choices;
}

std::string DescribeUnknownMetric(std::string_view name)
{
  return MetricNameChoices().WhyUnknown({ std::string(name) });
}

std::vector<const Metric*> SelectMetrics(const std::vector<std::string>& names)
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

std::vector<std::string> SelectMeshMetrics(
  const std::vector<std::string>& names, const std::vector<std::string>& metrics)
{
  std::vector<std::string> selected;
  for (const std::string& name : names)
  {
    for (const MeshMetric& metric : MeshMetrics())
    {
      if (name == metric.Name || name == AllWord || (name == UsualWord && IsUsual(metric, metrics)))
      {
        AddOnce(selected, metric.Name);
      }
    }
  }
  return selected;
}

NamesTaken TakeMetricNames(std::vector<std::string>& own, const std::vector<std::string>& names)
{
  std::string fault = MetricChoices().WhyUnknown(names);
  if (!fault.empty())
  {
    return { .IsChange = false, .Fault = std::move(fault) };
  }
  std::vector<std::string> normalized;
  for (const Metric* metric : SelectMetrics(names))
  {
    normalized.emplace_back(metric->Name);
  }
  return Take(own, std::move(normalized));
}

NamesTaken TakeNames(
  std::vector<std::string>& own, const std::vector<std::string>& names, const NameChoices& choices)
{
  std::string fault = choices.WhyUnknown(names);
  if (!fault.empty())
  {
    return { .IsChange = false, .Fault = std::move(fault) };
  }
  std::vector<std::string> once;
  for (const std::string& name : names)
  {
    AddOnce(once, name);
  }
  return Take(own, std::move(once));
}

} // namespace pemesh

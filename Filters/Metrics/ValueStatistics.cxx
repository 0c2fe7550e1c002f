// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ValueStatistics.h"

#include "CompensatedSum.h"
#include "ElementAccess.h"
#include "MeshConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

constexpr Statistic StatisticTable[] = {
  { "min", "min", "smallest", "Smallest value, and the first element that has it.", false, false,
    [](const ValueSummary& values) { return values.Minimum; },
    [](const ValueSummary& values) { return values.MinimumElement; } },
  { "max", "max", "largest", "Largest value, and the first element that has it.", false, false,
    [](const ValueSummary& values) { return values.Maximum; },
    [](const ValueSummary& values) { return values.MaximumElement; } },
  { "mean", "mean", "mean", "Mean over the elements.", false, false,
    [](const ValueSummary& values) { return values.Mean; }, nullptr },
  { "standard-deviation", "deviation", "standard deviation of",
    "Root of the mean square difference from the mean (divided by the number of elements).", false,
    true, [](const ValueSummary& values) { return values.StandardDeviation; }, nullptr },
  { "area-mean", "area_mean", "area-weighted mean",
    "Mean with the areas of the elements as weights.", false, true,
    [](const ValueSummary& values) { return values.AreaMean; }, nullptr },
  { "undefined", "undefined", "elements with undefined",
    "Number of elements where the metric is undefined.", true, false,
    [](const ValueSummary& values) { return static_cast<double>(values.Undefined); }, nullptr },
};

constexpr ElementGroup GroupTable[] = {
  { "all", "", "", "All elements.", [](int, int, bool) { return true; } },
  { "triangles", "_triangles", "triangles", "Elements of three vertices.",
    [](int vertices, int, bool) { return vertices == 3; } },
  { "polygons", "_polygons", "polygons", "Elements of more than three vertices.",
    [](int vertices, int, bool) { return vertices > 3; } },
  { "placed", "_placed", "placed polygons",
    "Elements of a placed polygon (PolygonId is not negative).",
    [](int, int polygon, bool) { return polygon >= 0; } },
  { "filler", "_filler", "around placed polygons",
    "Elements around the placed polygons (PolygonId is -1).",
    [](int, int polygon, bool) { return polygon == -1; } },
  { "selected", "_selected", "selected elements", "Elements of the selection.",
    [](int, int, bool selected) { return selected; } },
};

template <typename Table>
auto FindIn(const Table& table, std::string_view name)
{
  const auto found =
    std::ranges::find_if(table, [name](const auto& entry) { return name == entry.Name; });
  return found == std::end(table) ? nullptr : &*found;
}

bool IsMember(std::span<const unsigned char> members, std::size_t element)
{
  return members.empty() || members[element] != 0;
}

/** Differences from the mean, and weights: what needs a second pass. */
void AddSpread(ValueSummary& summary, std::span<const double> values,
  std::span<const unsigned char> members, std::span<const double> areas)
{
  CompensatedSum squares;
  CompensatedSum weighted;
  CompensatedSum weights;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!IsMember(members, i) || !std::isfinite(values[i]))
    {
      continue;
    }
    const double difference = values[i] - summary.Mean;
    squares.Add(difference * difference);
    if (!areas.empty() && std::isfinite(areas[i]))
    {
      weighted.Add(areas[i] * difference);
      weights.Add(areas[i]);
    }
  }
  summary.StandardDeviation = std::sqrt(squares.Get() / static_cast<double>(summary.Count));
  if (weights.Get() > 0.0)
  {
    summary.AreaMean = summary.Mean + weighted.Get() / weights.Get();
  }
}

} // namespace

std::span<const Statistic> Statistics()
{
  return StatisticTable;
}

const Statistic* FindStatistic(std::string_view name)
{
  return FindIn(StatisticTable, name);
}

const Statistic* FindStatisticBySuffix(std::string_view suffix)
{
  const auto* found = std::ranges::find_if(
    StatisticTable, [suffix](const Statistic& entry) { return suffix == entry.Suffix; });
  return found == std::end(StatisticTable) ? nullptr : found;
}

std::span<const ElementGroup> ElementGroups()
{
  return GroupTable;
}

const ElementGroup* FindElementGroup(std::string_view name)
{
  return FindIn(GroupTable, name);
}

std::vector<unsigned char> FindMembers(
  vtkPolyData* mesh, const ElementGroup& group, std::span<const unsigned char> selected)
{
  vtkDataArray* polygons = mesh->GetCellData()->GetArray(PolygonIdArray);
  polygons =
    polygons && polygons->GetNumberOfTuples() == mesh->GetNumberOfPolys() ? polygons : nullptr;
  ElementAccess access(mesh);
  std::vector<unsigned char> members(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const auto element = static_cast<vtkIdType>(i);
    constexpr int NoPolygonId = -2; // in neither group
    const int polygon =
      polygons ? static_cast<int>(polygons->GetComponent(element, 0)) : NoPolygonId;
    const auto vertices = static_cast<int>(access.CountVertices(element));
    const bool isSelected = !selected.empty() && selected[i] != 0;
    members[i] = group.Contains(vertices, polygon, isSelected) ? 1 : 0;
  }
  return members;
}

ValueSummary SummarizeValues(std::span<const double> values, std::span<const unsigned char> members,
  std::span<const double> areas, bool spread)
{
  ValueSummary summary{ 0, 0, NotANumber, NotANumber, NotANumber, NotANumber, NotANumber, -1, -1 };
  CompensatedSum sum;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double value = values[i];
    if (!IsMember(members, i))
    {
      continue;
    }
    if (!std::isfinite(value))
    {
      ++summary.Undefined;
      continue;
    }
    if (summary.MinimumElement < 0 || value < summary.Minimum)
    {
      summary.Minimum = value;
      summary.MinimumElement = static_cast<vtkIdType>(i);
    }
    if (summary.MaximumElement < 0 || value > summary.Maximum)
    {
      summary.Maximum = value;
      summary.MaximumElement = static_cast<vtkIdType>(i);
    }
    sum.Add(value);
    ++summary.Count;
  }
  if (summary.Count > 0)
  {
    summary.Mean = sum.Get() / static_cast<double>(summary.Count);
    if (spread)
    {
      AddSpread(summary, values, members, areas);
    }
  }
  return summary;
}

std::vector<double> SortValues(
  std::span<const double> values, std::span<const unsigned char> members)
{
  std::vector<double> sorted;
  sorted.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (IsMember(members, i) && std::isfinite(values[i]))
    {
      sorted.push_back(values[i]);
    }
  }
  std::ranges::sort(sorted);
  return sorted;
}

double Quantile(std::span<const double> sorted, double fraction)
{
  if (sorted.empty())
  {
    return NotANumber;
  }
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

std::vector<vtkIdType> Histogram(std::span<const double> sorted, int bins)
{
  std::vector<vtkIdType> counts(static_cast<std::size_t>(bins), 0);
  if (sorted.empty())
  {
    return counts;
  }
  const double width = (sorted.back() - sorted.front()) / bins;
  auto begin = sorted.begin();
  for (int bin = 0; bin < bins; ++bin)
  {
    const double end = sorted.front() + width * (bin + 1);
    const auto last = bin + 1 == bins ? sorted.end() : std::lower_bound(begin, sorted.end(), end);
    counts[static_cast<std::size_t>(bin)] = last - begin;
    begin = last;
  }
  return counts;
}

} // namespace pemesh

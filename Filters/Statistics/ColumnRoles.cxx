// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnRoles.h"

#include "CaseStatus.h"
#include "NumberText.h"
#include "SummaryTitles.h"
#include "ValueStatistics.h"

#include <vtkDataArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>

namespace pemesh
{

namespace
{

std::string NotFound(const std::string& name, const std::vector<std::string>& known)
{
  const std::string nearest = NearestWord(name, known);
  return "The table has no column \"" + name + "\"" +
    (nearest.empty() ? std::string(".") : "; did you mean \"" + nearest + "\"?");
}

std::vector<std::string> AllColumns(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    names.emplace_back(table->GetColumnName(i) ? table->GetColumnName(i) : "");
  }
  return names;
}

} // namespace

/** Also of metrics that are not in the registry: a table may hold somebody's own. */
bool IsMetricColumn(const std::string& name)
{
  if (IsStatisticOfMetric(name))
  {
    return true;
  }
  return std::ranges::any_of(ElementGroups(),
    [&](const ElementGroup& group)
    {
      const std::string suffix = group.Suffix;
      return std::ranges::any_of(std::array{ "_min", "_max", "_mean", "_deviation" },
        [&](const char* statistic) { return name.ends_with(statistic + suffix); });
    });
}

bool IsPerformanceColumn(vtkTable* table, const std::string& name)
{
  if (IsInFieldList(table, PerformancesList, name))
  {
    return true;
  }
  const std::size_t underscore = name.find('_');
  return underscore != std::string::npos && underscore > 0 && underscore + 1 < name.size() &&
    name.find("_element") == std::string::npos && !IsMetricColumn(name) && !IsOfSummary(name) &&
    !IsInFieldList(table, MeasuredList, name);
}

std::vector<std::string> NumericColumns(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumn(i)) && table->GetColumnName(i))
    {
      names.emplace_back(table->GetColumnName(i));
    }
  }
  return names;
}

std::vector<std::string> MetricColumns(vtkTable* table)
{
  std::vector<std::string> names = NumericColumns(table);
  std::erase_if(names,
    [&](const std::string& name)
    { return !IsMetricColumn(name) || IsInFieldList(table, PerformancesList, name); });
  return names;
}

std::vector<std::string> PerformanceColumns(vtkTable* table)
{
  std::vector<std::string> names = NumericColumns(table);
  std::erase_if(names, [&](const std::string& name) { return !IsPerformanceColumn(table, name); });
  return names;
}

std::string WhyNotNumeric(vtkTable* table, const std::vector<std::string>& names)
{
  const std::vector<std::string> known = NumericColumns(table);
  for (const std::string& name : names)
  {
    if (std::find(known.begin(), known.end(), name) != known.end())
    {
      continue;
    }
    return table->GetColumnByName(name.c_str())
      ? "The column \"" + name + "\" holds text: name columns that hold numbers."
      : NotFound(name, known);
  }
  return {};
}

std::string WhyNoColumn(vtkTable* table, const std::string& name)
{
  return table->GetColumnByName(name.c_str()) ? std::string() : NotFound(name, AllColumns(table));
}

std::vector<double> ColumnNumbers(vtkTable* table, const std::string& name)
{
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
  std::vector<double> values(static_cast<std::size_t>(column->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = column->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

std::vector<std::string> ColumnTexts(vtkTable* table, const std::string& name)
{
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  auto* numbers = vtkDataArray::SafeDownCast(column);
  std::vector<std::string> texts;
  for (vtkIdType row = 0; row < column->GetNumberOfTuples(); ++row)
  {
    texts.push_back(numbers ? FormatNumber(numbers->GetComponent(row, 0))
                            : column->GetVariantValue(row).ToString());
  }
  return texts;
}

} // namespace pemesh

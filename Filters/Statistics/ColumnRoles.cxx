// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnRoles.h"

#include "CaseStatus.h"
#include "NumberText.h"

#include <vtkDataArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>

namespace pemesh
{

namespace
{

constexpr std::array<const char*, 5> Groups{ "_placed", "_filler", "_polygons", "_triangles",
  "_selected" };
constexpr std::array<const char*, 4> Statistics{ "_min", "_max", "_mean", "_deviation" };

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

bool IsElementId(const std::string& name)
{
  return name.find("_element") != std::string::npos;
}

/** Neither what a metric is nor how often its values fall into a bin says what a solver did. */
bool IsBin(const std::string& name)
{
  const std::size_t bin = name.rfind("_bin");
  return bin != std::string::npos && bin + 4 < name.size() && name[bin + 4] >= '0' &&
    name[bin + 4] <= '9';
}

} // namespace

bool IsMetricColumn(const std::string& name)
{
  std::string base = name;
  for (const char* group : Groups)
  {
    if (base.ends_with(group))
    {
      base.resize(base.size() - std::string(group).size());
      break;
    }
  }
  const std::size_t quantile = base.rfind("_q");
  return std::any_of(Statistics.begin(), Statistics.end(),
           [&](const char* statistic) { return base.ends_with(statistic); }) ||
    (quantile != std::string::npos && ParseNumber(base.substr(quantile + 2)));
}

bool IsPerformanceColumn(vtkTable* table, const std::string& name)
{
  if (IsInFieldList(table, PerformancesList, name))
  {
    return true;
  }
  const std::size_t underscore = name.find('_');
  return underscore != std::string::npos && underscore > 0 && underscore + 1 < name.size() &&
    !IsElementId(name) && !IsBin(name) && !IsMetricColumn(name) &&
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartRequest.h"

#include "NumberText.h"

#include <vtkDataArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pemesh
{

namespace
{

vtkAbstractArray* FindColumn(vtkTable* table, const std::string& name)
{
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  if (!column)
  {
    std::vector<std::string> names;
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      const char* candidate = table->GetColumnName(i);
      names.emplace_back(candidate ? candidate : "");
    }
    const std::string nearest = NearestWord(name, names);
    throw std::runtime_error("The table has no column \"" + name + "\"" +
      (nearest.empty() ? ": it has no columns." : "; the nearest is \"" + nearest + "\"."));
  }
  return column;
}

} // namespace

std::string ChartRequest::TitleOf(const std::string& column) const
{
  const auto found = this->Titles.find(column);
  return found == this->Titles.end() ? column : found->second;
}

std::string ChartRequest::TitleOfX() const
{
  return !this->XTitle.empty() ? this->XTitle : this->X.empty() ? "Row" : this->TitleOf(this->X);
}

std::string ChartRequest::TitleOfY() const
{
  return !this->YTitle.empty() || this->AllSeries.size() != 1 ? this->YTitle
                                                              : this->LabelOf(this->AllSeries[0]);
}

std::string ChartRequest::LabelOf(const Series& series) const
{
  return !series.Label.empty() ? series.Label : this->TitleOf(series.Line);
}

std::vector<double> ReadNumbers(vtkTable* table, const std::string& name)
{
  std::vector<double> numbers(static_cast<std::size_t>(table->GetNumberOfRows()));
  if (name.empty())
  {
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
  }
  auto* column = vtkDataArray::SafeDownCast(FindColumn(table, name));
  if (!column && table->GetNumberOfRows() == 0)
  {
    return {}; // which a file without rows does not tell from numbers
  }
  if (!column)
  {
    throw std::runtime_error(
      "The column \"" + name + "\" holds text: a chart needs a column of numbers.");
  }
  for (std::size_t row = 0; row < numbers.size(); ++row)
  {
    numbers[row] = column->GetComponent(static_cast<vtkIdType>(row), 0);
  }
  return numbers;
}

bool IsTextColumn(vtkTable* table, const std::string& name)
{
  return vtkStringArray::SafeDownCast(FindColumn(table, name)) != nullptr;
}

std::vector<RowClass> ReadClasses(vtkTable* table, const std::string& name)
{
  vtkAbstractArray* column = FindColumn(table, name);
  auto* text = vtkStringArray::SafeDownCast(column);
  auto* numbers = vtkDataArray::SafeDownCast(column);
  // Texts sort as texts, numbers as numbers; what is undefined comes last.
  using Key = std::pair<double, std::string>;
  std::map<Key, std::vector<vtkIdType>> rows;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    Key key{ 0.0, "" };
    if (text)
    {
      key.second = text->GetValue(row);
    }
    else if (numbers)
    {
      const double value = numbers->GetComponent(row, 0);
      key.first = std::isnan(value) ? HUGE_VAL : value;
      key.second = std::isnan(value) ? "undefined" : ReadableNumber(value);
    }
    rows[key].push_back(row);
  }
  std::vector<RowClass> classes;
  for (auto& [key, ids] : rows)
  {
    classes.push_back({ key.second.empty() ? "(none)" : key.second, std::move(ids) });
  }
  return classes;
}

Sample ReadSample(const std::vector<double>& column, const std::vector<vtkIdType>& rows)
{
  Sample sample;
  for (const vtkIdType row : rows)
  {
    const double value = column[static_cast<std::size_t>(row)];
    if (std::isfinite(value))
    {
      sample.Values.push_back(value);
      sample.Rows.push_back(row);
    }
  }
  return sample;
}

std::vector<vtkIdType> AllRows(vtkTable* table)
{
  std::vector<vtkIdType> rows(static_cast<std::size_t>(table->GetNumberOfRows()));
  std::iota(rows.begin(), rows.end(), vtkIdType{ 0 });
  return rows;
}

void CheckRequest(const ChartRequest& request, std::size_t leastSeries)
{
  if (!request.Table)
  {
    throw std::runtime_error("The chart has no table.");
  }
  if (request.AllSeries.empty())
  {
    throw std::runtime_error("The chart has no y column.");
  }
  if (request.AllSeries.size() < leastSeries)
  {
    throw std::runtime_error("This kind of chart needs at least " + std::to_string(leastSeries) +
      " columns, and has " + std::to_string(request.AllSeries.size()) + ".");
  }
}

} // namespace pemesh

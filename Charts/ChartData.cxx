// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartData.h"

#include "NumberText.h"

#include <vtkDataArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

vtkAbstractArray* FindColumn(vtkTable* table, const std::string& name)
{
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  if (!column)
  {
    std::vector<std::string> names;
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      const char* candidate = table->GetColumnName(i);
      names.push_back(candidate ? candidate : "");
    }
    const std::string nearest = NearestWord(name, names);
    throw std::runtime_error("The table has no column \"" + name + "\"" +
      (nearest.empty() ? ": it has no columns." : "; the nearest is \"" + nearest + "\"."));
  }
  return column;
}

std::vector<double> ReadNumbers(vtkTable* table, const std::string& name)
{
  std::vector<double> numbers(static_cast<std::size_t>(table->GetNumberOfRows()));
  if (name.empty())
  {
    for (std::size_t row = 0; row < numbers.size(); ++row)
    {
      numbers[row] = static_cast<double>(row);
    }
    return numbers;
  }
  auto* column = vtkDataArray::SafeDownCast(FindColumn(table, name));
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

/** Brings values to the coordinates of an axis; counts those that have none there. */
void ToAxis(std::vector<double>& values, bool logarithmic, ChartData& data)
{
  for (double& value : values)
  {
    if (!std::isfinite(value))
    {
      value = Undefined;
      ++data.Undefined;
    }
    else if (logarithmic && value <= 0.0)
    {
      value = Undefined;
      ++data.NotPositive;
    }
    else if (logarithmic)
    {
      value = std::log10(value);
    }
  }
}

/** Where x has no place, nothing else of the row counts as missing once more. */
void DropRows(std::vector<double>& values, const std::vector<double>& x)
{
  for (std::size_t row = 0; row < values.size(); ++row)
  {
    values[row] = std::isnan(x[row]) ? Undefined : values[row];
  }
}

void Extend(double range[2], const std::vector<double>& values, const std::vector<double>& x)
{
  for (std::size_t row = 0; row < values.size(); ++row)
  {
    if (!std::isnan(values[row]) && !std::isnan(x[row]))
    {
      range[0] = std::fmin(range[0], values[row]);
      range[1] = std::fmax(range[1], values[row]);
    }
  }
}

ChartSeries ReadSeries(vtkTable* table, const ChartColumns& columns,
  const ChartColumns::Series& asked, const std::vector<double>& x, ChartData& data)
{
  ChartSeries series;
  series.Label = asked.Label.empty() ? asked.Line : asked.Label;
  series.X = x;
  const auto read = [&](const std::string& name, std::vector<double>& values)
  {
    if (!name.empty())
    {
      values = ReadNumbers(table, name);
      ToAxis(values, columns.LogY, data);
      DropRows(values, x);
    }
  };
  read(asked.Line, series.Y);
  if (asked.Lower.empty() != asked.Upper.empty())
  {
    throw std::runtime_error(
      "The band \"" + series.Label + "\" needs a lower and an upper column.");
  }
  read(asked.Lower, series.Lower);
  read(asked.Upper, series.Upper);
  return series;
}

/** One series for every text of the colour column, in the order of the texts. */
std::vector<ChartSeries> SplitByClass(const ChartSeries& whole, vtkStringArray* classes)
{
  std::vector<std::string> names;
  for (vtkIdType row = 0; row < classes->GetNumberOfValues(); ++row)
  {
    names.push_back(classes->GetValue(row));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::vector<ChartSeries> parts;
  for (const std::string& name : names)
  {
    ChartSeries part = whole;
    part.Label = name.empty() ? "(none)" : name;
    part.Style = static_cast<int>(parts.size());
    for (std::size_t row = 0; row < part.Y.size(); ++row)
    {
      if (classes->GetValue(static_cast<vtkIdType>(row)) != name)
      {
        part.Y[row] = Undefined;
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

void ReadColors(vtkTable* table, const ChartColumns& columns, ChartData& data)
{
  if (columns.Color.empty())
  {
    return;
  }
  auto* classes = vtkStringArray::SafeDownCast(FindColumn(table, columns.Color));
  if (!classes)
  {
    data.Colors = ReadNumbers(table, columns.Color);
    return;
  }
  if (data.AllSeries.size() != 1 || data.AllSeries[0].Y.empty())
  {
    throw std::runtime_error("The column \"" + columns.Color +
      "\" holds text, and colours by classes need exactly one y column.");
  }
  data.AllSeries = SplitByClass(data.AllSeries[0], classes);
  data.HasClasses = true;
}

} // namespace

ChartData ReadChartData(vtkTable* table, const ChartColumns& columns)
{
  if (!table)
  {
    throw std::runtime_error("The chart has no table.");
  }
  if (columns.AllSeries.empty())
  {
    throw std::runtime_error("The chart has no y column.");
  }
  ChartData data;
  std::vector<double> x = ReadNumbers(table, columns.X);
  ToAxis(x, columns.LogX, data);
  double rangeX[2] = { Undefined, Undefined };
  double rangeY[2] = { Undefined, Undefined };
  for (const ChartColumns::Series& asked : columns.AllSeries)
  {
    ChartSeries series = ReadSeries(table, columns, asked, x, data);
    series.Style = static_cast<int>(data.AllSeries.size());
    for (const auto* values : { &series.Y, &series.Lower, &series.Upper })
    {
      Extend(rangeY, *values, x);
      if (!values->empty())
      {
        Extend(rangeX, x, *values);
      }
    }
    data.AllSeries.push_back(std::move(series));
  }
  data.IsEmpty = std::isnan(rangeY[0]);
  data.X = columns.LogX ? PadLogRange(rangeX[0], rangeX[1]) : PadLinearRange(rangeX[0], rangeX[1]);
  data.Y = columns.LogY ? PadLogRange(rangeY[0], rangeY[1]) : PadLinearRange(rangeY[0], rangeY[1]);
  ReadColors(table, columns, data);
  return data;
}

std::string DescribeMissing(const ChartData& data, const ChartColumns& columns)
{
  if (data.NotPositive == 0 && data.Undefined == 0)
  {
    return {};
  }
  const auto values = [](long count)
  { return std::to_string(count) + (count == 1 ? " value" : " values"); };
  std::string text = "Not drawn: ";
  if (data.NotPositive > 0)
  {
    text += values(data.NotPositive) + " not positive (logarithmic " +
      (columns.LogX ? (columns.LogY ? "axes" : "x axis") : "y axis") + ")";
  }
  if (data.Undefined > 0)
  {
    text += (data.NotPositive > 0 ? ", " : "") + values(data.Undefined) + " undefined";
  }
  return text + ".";
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The third part of vtkPEMChart: the numbers that it draws, as a table.
#include "ChartPlot.h"
#include "vtkPEMChart.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <array>
#include <stdexcept>

namespace
{

/** Rows of the table of numbers; columns without any number are left out. */
class DataRows
{
public:
  DataRows()
  {
    this->Plot->SetName("Plot");
    this->Series->SetName("Series");
    for (std::size_t i = 0; i < Names.size(); ++i)
    {
      this->Numbers[i]->SetName(Names[i]);
    }
  }

  static constexpr std::array<const char*, 9> Names = { "Row", "X", "Y", "Lower", "Upper", "Value",
    "XTo", "YTo", "Points" };
  using Values = std::array<double, Names.size()>;
  static Values Empty()
  {
    Values values;
    values.fill(pemesh::NoValue);
    return values;
  }

  void Add(const std::string& plot, const std::string& series, const Values& values)
  {
    this->Plot->InsertNextValue(plot);
    this->Series->InsertNextValue(series);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Numbers[i]->InsertNextValue(values[i]);
      this->IsUsed[i] = this->IsUsed[i] || !std::isnan(values[i]);
    }
  }

  vtkSmartPointer<vtkTable> Finish()
  {
    auto table = vtkSmartPointer<vtkTable>::New();
    table->AddColumn(this->Plot);
    table->AddColumn(this->Series);
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      if (this->IsUsed[i])
      {
        table->AddColumn(this->Numbers[i]);
      }
    }
    return table;
  }

private:
  vtkNew<vtkStringArray> Plot;
  vtkNew<vtkStringArray> Series;
  std::array<vtkNew<vtkDoubleArray>, Names.size()> Numbers;
  std::array<bool, Names.size()> IsUsed{};
};

void AddSeries(const std::string& plot, const pemesh::ChartSeries& series, DataRows& rows)
{
  const auto at = [](const std::vector<double>& values, std::size_t i)
  { return values.empty() ? pemesh::NoValue : values[i]; };
  for (std::size_t i = 0; i < series.X.size(); ++i)
  {
    const double row = series.OfRows ? static_cast<double>(series.RowOf(i)) : pemesh::NoValue;
    rows.Add(plot, series.Label,
      { row, series.X[i], at(series.Y, i), at(series.Lower, i), at(series.Upper, i),
        at(series.Values, i), pemesh::NoValue, pemesh::NoValue, pemesh::NoValue });
  }
}

void AddPlot(const pemesh::ChartPlot& plot, const std::string& name, DataRows& rows)
{
  for (const pemesh::ChartSeries& series : plot.AllSeries)
  {
    AddSeries(name, series, rows);
  }
  for (const pemesh::ChartBar& bar : plot.Bars)
  {
    DataRows::Values values = DataRows::Empty();
    values[1] = bar.Low[0];
    values[2] = bar.Low[1];
    values[5] = bar.Value;
    values[6] = bar.High[0];
    values[7] = bar.High[1];
    values[8] = static_cast<double>(bar.Rows.size());
    rows.Add(name, bar.Name, values);
  }
  for (const pemesh::ChartShape& shape : plot.Shapes)
  {
    for (std::size_t i = 0; i < shape.X.size() && !shape.Grey; ++i)
    {
      DataRows::Values values = DataRows::Empty();
      values[1] = shape.X[i];
      values[2] = shape.Y[i];
      rows.Add(name, "outline " + std::to_string(shape.Style + 1), values);
    }
  }
}

} // namespace

vtkSmartPointer<vtkTable> vtkPEMChart::MakeDataTable()
{
  DataRows rows;
  if (this->WhyNotDrawable().empty())
  {
    for (std::size_t i = 0; i < this->Picture->Plots.size(); ++i)
    {
      const pemesh::ChartPlot& plot = this->Picture->Plots[i];
      AddPlot(plot, plot.Title.empty() ? std::to_string(i + 1) : plot.Title, rows);
    }
  }
  return rows.Finish();
}

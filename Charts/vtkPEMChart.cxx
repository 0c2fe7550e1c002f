// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMChart.h"

#include "ChartPainter.h"

#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMChart);

namespace
{

constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

bool IsGiven(const double range[2])
{
  return std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1];
}

/** The range that was asked for, if it makes sense on this axis; else that of the data. */
bool UseRange(const double asked[2], bool logarithmic, pemesh::AxisRange& range)
{
  if (!IsGiven(asked) || (logarithmic && asked[0] <= 0.0))
  {
    return false;
  }
  range.Low = logarithmic ? std::log10(asked[0]) : asked[0];
  range.High = logarithmic ? std::log10(asked[1]) : asked[1];
  return true;
}

} // namespace

vtkPEMChart::vtkPEMChart()
  : XRange{ Automatic, Automatic }
  , YRange{ Automatic, Automatic }
{
}

vtkPEMChart::~vtkPEMChart() = default;

void vtkPEMChart::SetText(std::string& member, const std::string& value)
{
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

void vtkPEMChart::SetTable(vtkTable* table)
{
  if (this->Table != table)
  {
    this->Table = table;
    this->Modified();
  }
}

vtkTable* vtkPEMChart::GetTable() const
{
  return this->Table;
}

bool vtkPEMChart::SetKindByName(const std::string& name)
{
  if (name != "line" && name != "scatter")
  {
    return false;
  }
  this->SetKind(name == "line" ? KIND_LINE : KIND_SCATTER);
  return true;
}

bool vtkPEMChart::SetLogAxes(const std::string& axes)
{
  if (!axes.empty() && axes != "x" && axes != "y" && axes != "xy")
  {
    return false;
  }
  this->SetLogX(axes.find('x') != std::string::npos);
  this->SetLogY(axes.find('y') != std::string::npos);
  return true;
}

void vtkPEMChart::SetXColumn(const std::string& name)
{
  this->SetText(this->XColumn, name);
}

std::string vtkPEMChart::GetXColumn() const
{
  return this->XColumn;
}

void vtkPEMChart::AddYColumn(const std::string& name, const std::string& label)
{
  this->AllSeries.push_back({ name, "", "", label });
  this->Modified();
}

void vtkPEMChart::SetYColumns(const std::vector<std::string>& names)
{
  this->SetYColumns(names, {});
}

void vtkPEMChart::SetYColumns(
  const std::vector<std::string>& names, const std::vector<std::string>& labels)
{
  this->RemoveAllYColumns();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    this->AddYColumn(names[i], i < labels.size() ? labels[i] : std::string());
  }
}

void vtkPEMChart::AddBand(const std::string& lower, const std::string& upper,
  const std::string& middle, const std::string& label)
{
  this->AllSeries.push_back({ middle, lower, upper, label });
  this->Modified();
}

void vtkPEMChart::RemoveAllYColumns()
{
  if (!this->AllSeries.empty())
  {
    this->AllSeries.clear();
    this->Modified();
  }
}

int vtkPEMChart::GetNumberOfSeries() const
{
  return static_cast<int>(this->AllSeries.size());
}

void vtkPEMChart::SetColorColumn(const std::string& name)
{
  this->SetText(this->ColorColumn, name);
}

std::string vtkPEMChart::GetColorColumn() const
{
  return this->ColorColumn;
}

void vtkPEMChart::SetColorTitle(const std::string& title)
{
  this->SetText(this->ColorTitle, title);
}

std::string vtkPEMChart::GetColorTitle() const
{
  return this->ColorTitle;
}

void vtkPEMChart::SetXTitle(const std::string& title)
{
  this->SetText(this->XTitle, title);
}

std::string vtkPEMChart::GetXTitle() const
{
  return this->XTitle;
}

void vtkPEMChart::SetYTitle(const std::string& title)
{
  this->SetText(this->YTitle, title);
}

std::string vtkPEMChart::GetYTitle() const
{
  return this->YTitle;
}

pemesh::ChartColumns vtkPEMChart::GetColumns() const
{
  pemesh::ChartColumns columns;
  columns.X = this->XColumn;
  for (const Series& series : this->AllSeries)
  {
    columns.AllSeries.push_back({ series.Column, series.Lower, series.Upper, series.Label });
  }
  columns.Color = this->ColorColumn;
  columns.LogX = this->LogX;
  columns.LogY = this->LogY;
  return columns;
}

std::string vtkPEMChart::WhyNotDrawable()
{
  try
  {
    pemesh::ReadChartData(this->Table, this->GetColumns());
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

std::string vtkPEMChart::GetNote()
{
  try
  {
    const pemesh::ChartColumns columns = this->GetColumns();
    return pemesh::DescribeMissing(pemesh::ReadChartData(this->Table, columns), columns);
  }
  catch (const std::exception&)
  {
    return {};
  }
}

double vtkPEMChart::GetDeviceX(double x) const
{
  const double place = this->LogX ? std::log10(x) : x;
  const double part = (place - this->PlotRange[0]) / (this->PlotRange[1] - this->PlotRange[0]);
  return this->PlotArea[0] + part * this->PlotArea[2];
}

double vtkPEMChart::GetDeviceY(double y) const
{
  const double place = this->LogY ? std::log10(y) : y;
  const double part = (place - this->PlotRange[2]) / (this->PlotRange[3] - this->PlotRange[2]);
  return this->PlotArea[1] + part * this->PlotArea[3];
}

bool vtkPEMChart::Paint(vtkContext2D* context)
{
  try
  {
    const pemesh::ChartColumns columns = this->GetColumns();
    pemesh::ChartData data = pemesh::ReadChartData(this->Table, columns);
    pemesh::ChartStyle style;
    style.Title = this->GetTitle();
    style.XTitle = !this->XTitle.empty() ? this->XTitle
      : !this->XColumn.empty()           ? this->XColumn
                                         : "Row";
    const bool single = this->AllSeries.size() == 1;
    style.YTitle = this->YTitle;
    if (style.YTitle.empty() && single)
    {
      const Series& series = this->AllSeries[0];
      style.YTitle = series.Label.empty() ? series.Column : series.Label;
    }
    style.ColorTitle = this->ColorTitle.empty() ? this->ColorColumn : this->ColorTitle;
    style.Note = pemesh::DescribeMissing(data, columns);
    style.JoinPoints = this->Kind == KIND_LINE && !data.HasClasses;
    style.LogX = this->LogX;
    style.LogY = this->LogY;
    style.LogColor = this->LogColor;
    style.ShowLegend = this->ShowLegend;
    const bool givenX = UseRange(this->XRange, this->LogX, data.X);
    const bool givenY = UseRange(this->YRange, this->LogY, data.Y);
    style.ClipToRange = givenX || givenY;

    const double* rectangle = this->GetRectangle();
    pemesh::ChartPainter painter(context, this->GetFontSize(), data, style);
    painter.Paint({ rectangle[0], rectangle[1], rectangle[2], rectangle[3] });
    const pemesh::Box& plot = painter.PlotArea();
    const double area[4] = { plot.X, plot.Y, plot.Width, plot.Height };
    const double range[4] = { data.X.Low, data.X.High, data.Y.Low, data.Y.High };
    std::copy_n(area, 4, this->PlotArea);
    std::copy_n(range, 4, this->PlotRange);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  return true;
}

void vtkPEMChart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table.Get() << "\n";
  os << indent << "Kind: " << this->Kind << "\n";
  os << indent << "XColumn: " << this->XColumn << "\n";
  os << indent << "AllSeries:\n";
  for (const Series& series : this->AllSeries)
  {
    os << indent.GetNextIndent() << series.Label << ": " << series.Column << " [" << series.Lower
       << ", " << series.Upper << "]\n";
  }
  os << indent << "ColorColumn: " << this->ColorColumn << "\n";
  os << indent << "ColorTitle: " << this->ColorTitle << "\n";
  os << indent << "XTitle: " << this->XTitle << "\n";
  os << indent << "YTitle: " << this->YTitle << "\n";
  os << indent << "LogX: " << this->LogX << "\n";
  os << indent << "LogY: " << this->LogY << "\n";
  os << indent << "LogColor: " << this->LogColor << "\n";
  os << indent << "ShowLegend: " << this->ShowLegend << "\n";
  os << indent << "XRange: " << this->XRange[0] << " " << this->XRange[1] << "\n";
  os << indent << "YRange: " << this->YRange[0] << " " << this->YRange[1] << "\n";
  os << indent << "PlotArea: " << this->PlotArea[0] << " " << this->PlotArea[1] << " "
     << this->PlotArea[2] << " " << this->PlotArea[3] << "\n";
  os << indent << "PlotRange: " << this->PlotRange[0] << " " << this->PlotRange[1] << " "
     << this->PlotRange[2] << " " << this->PlotRange[3] << "\n";
}

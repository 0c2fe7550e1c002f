// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMChart.h"

#include "ChartKinds.h"
#include "ChartOptions.h"
#include "ChartPlot.h"
#include "ChartViewState.h"

#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMChart);

namespace
{

constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

} // namespace

vtkPEMChart::vtkPEMChart()
  : Options(std::make_unique<pemesh::ChartOptions>())
  , XRange{ Automatic, Automatic }
  , YRange{ Automatic, Automatic }
  , View(std::make_unique<pemesh::ChartViewState>())
{
}

vtkPEMChart::~vtkPEMChart() = default;

void vtkPEMChart::Modified()
{
  this->DataTime.Modified();
  this->ViewModified();
}

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

void vtkPEMChart::SetKind(int kind)
{
  const int last = static_cast<int>(pemesh::ChartKinds().size()) - 1;
  const int clamped = std::clamp(kind, 0, last);
  if (this->Kind != clamped)
  {
    this->Kind = clamped;
    this->Modified();
  }
}

bool vtkPEMChart::SetKindByName(const std::string& name)
{
  const pemesh::ChartKind* kind = pemesh::FindChartKind(name);
  if (kind)
  {
    this->SetKind(static_cast<int>(kind - pemesh::ChartKinds().data()));
  }
  return kind != nullptr;
}

std::string vtkPEMChart::GetKindName() const
{
  return pemesh::ChartKinds()[static_cast<std::size_t>(this->Kind)].Name;
}

std::vector<std::string> vtkPEMChart::GetKindNames()
{
  return pemesh::ChartKindNames();
}

double vtkPEMChart::GetPreferredAspect()
{
  const double usual = pemesh::ChartKinds()[static_cast<std::size_t>(this->Kind)].Aspect;
  if (!this->WhyNotDrawable().empty() || this->GetPicture().IsMatrix)
  {
    return usual;
  }
  // Of several plots each needs room for its title and labels.
  constexpr double aspectOfOne = 1.1;
  const pemesh::ChartPicture& picture = this->GetPicture();
  const auto count = static_cast<int>(picture.Plots.size());
  const int columns = std::clamp(picture.Columns, 1, std::max(count, 1));
  const int rows = (count + columns - 1) / columns;
  return rows > 1 ? std::max(usual, aspectOfOne * rows / columns) : usual;
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

void vtkPEMChart::SetColumnTitle(const std::string& column, const std::string& title)
{
  if (this->GetColumnTitle(column) != title)
  {
    this->ColumnTitles[column] = title;
    this->Modified();
  }
}

std::string vtkPEMChart::GetColumnTitle(const std::string& column) const
{
  const auto found = this->ColumnTitles.find(column);
  return found == this->ColumnTitles.end() ? column : found->second;
}

void vtkPEMChart::SetOptions(const pemesh::ChartOptions& options)
{
  *this->Options = options;
  this->Modified();
}

const pemesh::ChartOptions& vtkPEMChart::GetOptions() const
{
  return *this->Options;
}

std::string vtkPEMChart::SetOption(const std::string& name, const std::string& value)
{
  try
  {
    const std::string before = this->GetOption(name);
    pemesh::SetSetting(pemesh::ChartOptionFields(), *this->Options, name, value);
    if (this->GetOption(name) != before)
    {
      this->Modified();
    }
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

std::string vtkPEMChart::GetOption(const std::string& name) const
{
  const auto* field = pemesh::FindSetting(pemesh::ChartOptionFields(), name);
  return field ? pemesh::GetSetting(*field, *this->Options) : std::string();
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
  os << indent << "ColumnTitles:\n";
  for (const auto& [column, title] : this->ColumnTitles)
  {
    os << indent.GetNextIndent() << column << ": " << title << "\n";
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
  os << indent << "Options:\n";
  for (const auto& field : pemesh::ChartOptionFields())
  {
    os << indent.GetNextIndent() << field.Name << ": " << pemesh::GetSetting(field, *this->Options)
       << "\n";
  }
  os << indent << "IsZoomed: " << this->IsZoomed() << "\n";
}

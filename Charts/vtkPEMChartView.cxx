// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The second half of vtkPEMChart: making the marks, painting them, and interaction.
#include "vtkPEMChart.h"

#include "ChartKinds.h"
#include "ChartPainter.h"
#include "ChartPicking.h"
#include "ChartRequest.h"
#include "ChartViewState.h"

#include <vtkContext2D.h>
#include <vtkDataArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

pemesh::Box BoxBetween(double x0, double y0, double x1, double y1)
{
  return { std::min(x0, x1), std::min(y0, y1), std::fabs(x1 - x0), std::fabs(y1 - y0) };
}

/** Ranges that ticks can be made for, and between which numbers can be told apart. */
bool IsUsable(const pemesh::AxisRange& range, const pemesh::AxisRange& all)
{
  const double size = std::max(std::fabs(range.Low), std::fabs(range.High));
  const double span = range.High - range.Low;
  return std::isfinite(span) && span > 1e-10 * size && span > 1e-9 * (all.High - all.Low) &&
    span < 1e4 * (all.High - all.Low) && size < 1e307;
}

std::string DescribeRange(
  const pemesh::ChartAxis& axis, const char* otherwise, double low, double high)
{
  const std::string& name =
    axis.Title.find_first_not_of(' ') == std::string::npos ? std::string(otherwise) : axis.Title;
  return name + " from " + pemesh::ReadableNumber(low) + " to " + pemesh::ReadableNumber(high);
}

} // namespace

pemesh::ChartRequest vtkPEMChart::GetRequest() const
{
  pemesh::ChartRequest request;
  request.Table = this->Table;
  request.X = this->XColumn;
  for (const Series& series : this->AllSeries)
  {
    request.AllSeries.push_back({ series.Column, series.Lower, series.Upper, series.Label });
  }
  request.Color = this->ColorColumn;
  request.LogX = this->LogX;
  request.LogY = this->LogY;
  request.LogColor = this->LogColor;
  request.XTitle = this->XTitle;
  request.YTitle = this->YTitle;
  request.ColorTitle = this->ColorTitle;
  request.Titles = this->ColumnTitles;
  request.Options = *this->Options;
  const auto orElse = [](double option, double limit)
  { return std::isnan(option) ? limit : option; };
  request.Options.XMin = orElse(request.Options.XMin, this->XRange[0]);
  request.Options.XMax = orElse(request.Options.XMax, this->XRange[1]);
  request.Options.YMin = orElse(request.Options.YMin, this->YRange[0]);
  request.Options.YMax = orElse(request.Options.YMax, this->YRange[1]);
  return request;
}

const pemesh::ChartPicture& vtkPEMChart::GetPicture()
{
  const vtkMTimeType tableTime = this->Table ? this->Table->GetMTime() : 0;
  const vtkMTimeType made = this->PictureTime.GetMTime();
  if (!this->Picture || made < this->DataTime.GetMTime() || made < tableTime)
  {
    this->Picture.reset();
    const pemesh::ChartKind& kind = pemesh::ChartKinds()[static_cast<std::size_t>(this->Kind)];
    this->Picture = std::make_unique<pemesh::ChartPicture>(kind.Make(this->GetRequest()));
    this->PictureTime.Modified();
    this->View->Placements.clear();
  }
  return *this->Picture;
}

std::string vtkPEMChart::WhyNotDrawable()
{
  try
  {
    this->GetPicture();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

std::string vtkPEMChart::GetNote()
{
  return this->WhyNotDrawable().empty() ? pemesh::DescribePicture(*this->Picture) : std::string();
}

double vtkPEMChart::GetDeviceX(double x) const
{
  return this->View->Placements.empty()
    ? std::nan("")
    : this->View->Placements[0].DeviceX(this->Picture->Plots[0].X.PlaceOf(x));
}

double vtkPEMChart::GetDeviceY(double y) const
{
  return this->View->Placements.empty()
    ? std::nan("")
    : this->View->Placements[0].DeviceY(this->Picture->Plots[0].Y.PlaceOf(y));
}

bool vtkPEMChart::Paint(vtkContext2D* context)
{
  try
  {
    const pemesh::ChartPicture& picture = this->GetPicture();
    pemesh::ChartView view;
    view.Title = this->GetTitle();
    view.Note = pemesh::DescribePicture(picture);
    view.ShowLegend = this->ShowLegend;
    view.Ranges = this->View->Ranges;
    view.Highlighted = this->GetHighlightedRows();
    pemesh::PanelPainter painter(context, this->GetFontSize(), this->GetStyle());
    const double* box = this->GetRectangle();
    this->View->Placements =
      pemesh::ChartPainter(painter, picture, view).Paint({ box[0], box[1], box[2], box[3] });
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  return true;
}

//----------------------------------------------------------------------------------------------
pemesh::ChartPick vtkPEMChart::Pick(double deviceX, double deviceY, double tolerance)
{
  const int index = pemesh::FindPlot(this->View->Placements, deviceX, deviceY);
  if (index < 0)
  {
    return {};
  }
  const auto at = static_cast<std::size_t>(index);
  pemesh::ChartPick pick = pemesh::PickMark(this->Picture->Plots[at], this->View->Placements[at],
    deviceX, deviceY, tolerance * this->GetFontSize());
  pick.Plot = index;
  if (pick)
  {
    this->DescribePick(pick);
  }
  return pick;
}

void vtkPEMChart::DescribePick(pemesh::ChartPick& pick)
{
  const pemesh::ChartPlot& plot = this->Picture->Plots[static_cast<std::size_t>(pick.Plot)];
  if (pick.Row >= 0 && pick.Row < this->Table->GetNumberOfRows())
  {
    auto* meshes = vtkStringArray::SafeDownCast(this->Table->GetColumnByName("Mesh"));
    auto* elements = vtkDataArray::SafeDownCast(this->Table->GetColumnByName("Element"));
    pick.Mesh = meshes ? meshes->GetValue(pick.Row) : std::string();
    pick.Element = elements ? static_cast<vtkIdType>(elements->GetComponent(pick.Row, 0)) : -1;
  }
  const auto add = [&pick](const std::string& part)
  { pick.Text += part.empty() ? "" : (pick.Text.empty() ? "" : ", ") + part; };
  add(pick.Mesh.empty() ? "" : "mesh " + pick.Mesh);
  add(pick.Element < 0 ? "" : "element " + std::to_string(pick.Element));
  add(pick.Series);
  if (pick.What == pemesh::ChartPick::Kind::Area)
  {
    return; // the name of a bar says all of it
  }
  const bool named = plot.X.Title.find_first_not_of(' ') != std::string::npos;
  add((named ? plot.X.Title : "x") + " = " + pemesh::ReadableNumber(pick.X));
  add((pick.Series.empty() ? plot.Y.Title : "y") + " = " + pemesh::ReadableNumber(pick.Y));
}

std::vector<vtkIdType> vtkPEMChart::SelectRectangle(double x0, double y0, double x1, double y1)
{
  std::vector<vtkIdType> rows;
  const pemesh::Box rectangle = BoxBetween(x0, y0, x1, y1);
  for (std::size_t i = 0; i < this->View->Placements.size(); ++i)
  {
    pemesh::SelectRows(this->Picture->Plots[i], this->View->Placements[i], rectangle, rows);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

//----------------------------------------------------------------------------------------------
bool vtkPEMChart::SetView(int index, const double places[4])
{
  const pemesh::ChartPlot& plot = this->Picture->Plots[static_cast<std::size_t>(index)];
  const pemesh::AxisRange x = { places[0], places[1] };
  const pemesh::AxisRange y = { places[2], places[3] };
  if (!IsUsable(x, plot.X.Range) || !IsUsable(y, plot.Y.Range))
  {
    return false;
  }
  this->View->Ranges[plot.X.Group] = x;
  this->View->Ranges[plot.Y.Group] = y;
  // The next picks must meet what is seen then, even before it is painted.
  for (std::size_t i = 0; i < this->View->Placements.size(); ++i)
  {
    pemesh::PlotPlacement& place = this->View->Placements[i];
    const pemesh::ChartPlot& each = this->Picture->Plots[i];
    for (const auto& [axis, range] :
      { std::pair{ &each.X, &place.X }, std::pair{ &each.Y, &place.Y } })
    {
      const auto seen = this->View->Ranges.find(axis->Group);
      *range = seen == this->View->Ranges.end() ? axis->Range : seen->second;
    }
  }
  this->ViewModified();
  return true;
}

bool vtkPEMChart::Zoom(double deviceX, double deviceY, double factorX, double factorY)
{
  const int index = pemesh::FindPlot(this->View->Placements, deviceX, deviceY);
  if (index < 0 || !(factorX > 0.0) || !(factorY > 0.0))
  {
    return false;
  }
  const pemesh::PlotPlacement& place = this->View->Placements[static_cast<std::size_t>(index)];
  const double x = place.PlaceX(deviceX);
  const double y = place.PlaceY(deviceY);
  const double places[4] = { x + (place.X.Low - x) / factorX, x + (place.X.High - x) / factorX,
    y + (place.Y.Low - y) / factorY, y + (place.Y.High - y) / factorY };
  return this->SetView(index, places);
}

bool vtkPEMChart::Pan(double deviceX, double deviceY, double dx, double dy)
{
  const int index = pemesh::FindPlot(this->View->Placements, deviceX, deviceY);
  if (index < 0)
  {
    return false;
  }
  const pemesh::PlotPlacement& place = this->View->Placements[static_cast<std::size_t>(index)];
  const double x = dx / place.Area.Width * (place.X.High - place.X.Low);
  const double y = dy / place.Area.Height * (place.Y.High - place.Y.Low);
  const double places[4] = { place.X.Low - x, place.X.High - x, place.Y.Low - y, place.Y.High - y };
  return this->SetView(index, places);
}

bool vtkPEMChart::ZoomToRectangle(double x0, double y0, double x1, double y1)
{
  const pemesh::Box box = BoxBetween(x0, y0, x1, y1);
  const int index = pemesh::FindPlot(this->View->Placements, box.MiddleX(), box.MiddleY());
  if (index < 0)
  {
    return false;
  }
  const pemesh::PlotPlacement& place = this->View->Placements[static_cast<std::size_t>(index)];
  const double places[4] = { place.PlaceX(box.X), place.PlaceX(box.Right()), place.PlaceY(box.Y),
    place.PlaceY(box.Top()) };
  return this->SetView(index, places);
}

void vtkPEMChart::ResetView()
{
  if (this->IsZoomed())
  {
    this->View->Ranges.clear();
    for (std::size_t i = 0; i < this->View->Placements.size(); ++i)
    {
      this->View->Placements[i].X = this->Picture->Plots[i].X.Range;
      this->View->Placements[i].Y = this->Picture->Plots[i].Y.Range;
    }
    this->ViewModified();
  }
}

bool vtkPEMChart::IsZoomed() const
{
  return !this->View->Ranges.empty();
}

bool vtkPEMChart::GetVisibleRange(double deviceX, double deviceY, double range[4])
{
  const int index = pemesh::FindPlot(this->View->Placements, deviceX, deviceY);
  if (index < 0)
  {
    return false;
  }
  const pemesh::ChartPlot& plot = this->Picture->Plots[static_cast<std::size_t>(index)];
  const pemesh::PlotPlacement& place = this->View->Placements[static_cast<std::size_t>(index)];
  range[0] = plot.X.ValueAt(place.X.Low);
  range[1] = plot.X.ValueAt(place.X.High);
  range[2] = plot.Y.ValueAt(place.Y.Low);
  range[3] = plot.Y.ValueAt(place.Y.High);
  return true;
}

std::string vtkPEMChart::DescribeVisibleRange(double deviceX, double deviceY)
{
  double range[4];
  if (!this->GetVisibleRange(deviceX, deviceY, range))
  {
    return {};
  }
  const int index = pemesh::FindPlot(this->View->Placements, deviceX, deviceY);
  const pemesh::ChartPlot& plot = this->Picture->Plots[static_cast<std::size_t>(index)];
  std::string text;
  if (plot.X.Categories.empty())
  {
    text = DescribeRange(plot.X, "x", range[0], range[1]);
  }
  if (plot.Y.Categories.empty())
  {
    text += (text.empty() ? "" : ", ") + DescribeRange(plot.Y, "y", range[2], range[3]);
  }
  return text;
}

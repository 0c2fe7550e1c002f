// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPainter.h"

#include "ColorBar.h"
#include "MarkPainter.h"

#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkRenderingCoreEnums.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

ChartPainter::ChartPainter(
  PanelPainter& painter, const ChartPicture& picture, const ChartView& view)
  : Painter(painter)
  , Picture(picture)
  , View(view)
  , Em(painter.Em())
{
  for (const ChartPlot& plot : picture.Plots)
  {
    this->Axes.emplace_back(painter, plot, view.RangeOf(plot.X), view.RangeOf(plot.Y));
  }
}

void ChartPainter::MakeColorScale()
{
  AxisRange range = { NoValue, NoValue };
  const ChartPlot& first = this->Picture.Plots.front();
  bool isCounted = false;
  for (const ChartPlot& plot : this->Picture.Plots)
  {
    range.Low = std::fmin(range.Low, plot.Values.Low);
    range.High = std::fmax(range.High, plot.Values.High);
    if (CountsPoints(plot))
    {
      isCounted = true;
      range.Low = 1.0;
      range.High = static_cast<double>(plot.AllSeries[0].X.size()); // until they are counted
    }
  }
  const std::string& name =
    first.ColorMap.empty() ? this->Painter.Style().ColorMap : first.ColorMap;
  this->Colors.Map = FindColorMap(name) ? FindColorMap(name) : FindColorMap("viridis");
  this->Colors.Logarithmic = first.LogColor || isCounted;
  const bool any = !std::isnan(range.Low);
  const bool fixed = std::isfinite(first.ColorRange[0]);
  this->Colors.Low = fixed ? first.ColorRange[0] : any ? range.Low : 1.0;
  this->Colors.High = fixed ? first.ColorRange[1] : any ? range.High : 1.0;
  this->HasColorBar = any && first.HasColorBar && this->Painter.Style().ColorBar;
}

/** Once the plots have their places, a density knows its greatest count. */
void ChartPainter::CountDensest()
{
  int largest = 0;
  for (std::size_t i = 0; i < this->Axes.size(); ++i)
  {
    if (CountsPoints(this->Picture.Plots[i]))
    {
      const PointDensity density = CountPoints(this->Picture.Plots[i].AllSeries[0],
        this->Axes[i].Placement(), MarkPainter::DensityCell * this->Em);
      largest = std::max(largest, density.Largest);
    }
  }
  this->Colors.High = largest > 0 ? largest : this->Colors.High;
}

std::vector<LegendEntry> ChartPainter::MakeLegend() const
{
  std::vector<LegendEntry> entries;
  const ChartPlot& plot = this->Picture.Plots.front();
  const auto shown = std::count_if(plot.AllSeries.begin(), plot.AllSeries.end(),
    [](const ChartSeries& series) { return series.InLegend; });
  if (!this->View.ShowLegend || this->Painter.Style().Legend == "none" ||
    !(shown > 1 || plot.LegendIsNeeded))
  {
    return entries;
  }
  for (const ChartSeries& series : plot.AllSeries)
  {
    const bool isCounted = CountsPoints(plot) && series.OfRows; // told by the colour bar
    if (series.InLegend && !isCounted)
    {
      LegendEntry entry;
      entry.Text = series.Label;
      entry.Color = this->Painter.ColorOfSeries(series.Style);
      entry.Band = !series.Lower.empty();
      entry.LineType = MarkPainter::LineTypeOf(this->Painter, plot, series);
      entry.Marker = MarkPainter::MarkerOf(this->Painter, plot, series);
      entry.Patch = series.X.empty() || (plot.IsDensity && series.OfRows);
      entries.push_back(entry);
    }
  }
  return entries;
}

void ChartPainter::TakeLegend(Box& box)
{
  this->Legend = this->MakeLegend();
  if (this->Legend.empty())
  {
    return;
  }
  const std::string& where = this->Painter.Style().Legend;
  this->LegendBox = box;
  if (where == "right")
  {
    const double width = std::min(0.4 * box.Width, this->Painter.LegendWidth(this->Legend));
    this->LegendBox.X = box.Right() - width;
    this->LegendBox.Width = width;
    box.Width -= width + this->Em;
    return;
  }
  const double height = this->Painter.LegendHeight(this->Legend, box.Width);
  const double taken = height + 0.3 * this->Em;
  this->LegendBox.Height = height;
  this->LegendBox.Y = where == "bottom" ? box.Y : box.Top() - height;
  box.Height -= taken;
  box.Y += where == "bottom" ? taken : 0.0;
}

void ChartPainter::DrawLegend()
{
  if (this->Legend.empty())
  {
    return;
  }
  Box box = this->LegendBox;
  if (this->Painter.Style().Legend != "right")
  {
    // In line with the plot area, unless that costs a row that was not reckoned with.
    const double left = this->Axes.front().Placement().Area.X;
    const double fromPlot = box.Right() - left;
    if (this->Painter.LegendHeight(this->Legend, fromPlot) <=
      this->Painter.LegendHeight(this->Legend, box.Width))
    {
      box.X = left;
      box.Width = fromPlot;
    }
  }
  this->Painter.DrawLegend(box, this->Legend);
}

void ChartPainter::LayOutPlots(const Box& box)
{
  const std::size_t count = this->Axes.size();
  if (count == 1)
  {
    this->Axes[0].LayOut(box);
    return;
  }
  // All plots are equally large; labels get the room that the widest of their row or column needs.
  const auto columns =
    std::clamp(static_cast<std::size_t>(this->Picture.Columns), std::size_t{ 1 }, count);
  const std::size_t rows = (count + columns - 1) / columns;
  const double gap = (this->Picture.IsMatrix ? 0.9 : 0.5) * this->Em; // for the last labels
  const double gapBelow = (this->Picture.IsMatrix ? 0.2 : 0.5) * this->Em;
  std::vector<PlotMargins> across(columns);
  std::vector<PlotMargins> down(rows);
  // Which labels fit depends on the size of the plots, and that on the labels.
  for (int pass = 0; pass < 3; ++pass)
  {
    double width = box.Width - gap * static_cast<double>(columns - 1);
    double height = box.Height - gapBelow * static_cast<double>(rows - 1);
    for (const PlotMargins& margins : across)
    {
      width -= margins.Left + margins.Right;
    }
    for (const PlotMargins& margins : down)
    {
      height -= margins.Bottom + margins.Top;
    }
    width = std::max(this->Em, width / static_cast<double>(columns));
    height = std::max(this->Em, height / static_cast<double>(rows));
    double top = box.Top();
    for (std::size_t row = 0; row < rows; ++row)
    {
      const double cellHeight = height + down[row].Bottom + down[row].Top;
      double left = box.X;
      for (std::size_t column = 0; column < columns && row * columns + column < count; ++column)
      {
        const double cellWidth = width + across[column].Left + across[column].Right;
        this->Axes[row * columns + column].LayOut({ left, top - cellHeight, cellWidth, cellHeight },
          { across[column].Left, across[column].Right, down[row].Bottom, down[row].Top });
        left += cellWidth + gap;
      }
      top -= cellHeight + gapBelow;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      across[i % columns].Include(this->Axes[i].Margins());
      down[i / columns].Include(this->Axes[i].Margins());
    }
  }
}

void ChartPainter::DrawPlot(std::size_t index)
{
  const ChartPlot& plot = this->Picture.Plots[index];
  PlotAxes& axes = this->Axes[index];
  const Box& area = axes.Placement().Area;
  axes.DrawGrid();
  vtkContextDevice2D* device = this->Painter.Context()->GetDevice();
  // A hair more than the plot, so that marks at its very end are whole.
  const double slack = 0.15 * this->Em;
  int clip[4] = { static_cast<int>(std::floor(area.X - slack)),
    static_cast<int>(std::floor(area.Y - slack)),
    static_cast<int>(std::ceil(area.Width + 2.0 * slack)),
    static_cast<int>(std::ceil(area.Height + 2.0 * slack)) };
  device->SetClipping(clip);
  device->EnableClipping(true);
  MarkPainter(this->Painter, plot, axes.Placement(), this->Colors, this->View.Highlighted).Draw();
  device->EnableClipping(false);
  axes.DrawAxes();
  const std::string message = !plot.Message.empty() ? plot.Message
    : plot.IsEmpty ? (area.Width < 8.0 * this->Em ? "no values" : "no values to draw")
                   : "";
  if (!message.empty())
  {
    PanelText style;
    style.Horizontal = 0;
    style.Ink = FaintInk;
    this->Painter.Text(area.MiddleX(), area.MiddleY(),
      this->Painter.Fit(message, 0.95 * area.Width, 3, style), style);
  }
}

std::string ChartPainter::ColorTitle() const
{
  const ChartPlot& plot = this->Picture.Plots.front();
  return CountsPoints(plot) ? "points" : plot.ColorTitle;
}

std::vector<PlotPlacement> ChartPainter::Paint(const Box& box)
{
  Box rest = box;
  this->Painter.FillBackground(box);
  this->Painter.TakeTitle(rest, this->View.Title);
  this->Painter.TakeNote(rest, this->View.Note);
  if (this->Picture.Plots.empty())
  {
    return {};
  }
  this->MakeColorScale();
  this->TakeLegend(rest);
  Box plots = rest;
  if (this->HasColorBar)
  {
    plots.Width -=
      ColorBarWidth(this->Painter, this->Colors, this->ColorTitle(), rest.Height) - 0.6 * this->Em;
  }
  this->LayOutPlots(plots);
  this->CountDensest();
  this->DrawLegend();
  std::vector<PlotPlacement> placements;
  for (std::size_t i = 0; i < this->Axes.size(); ++i)
  {
    this->DrawPlot(i);
    placements.push_back(this->Axes[i].Placement());
  }
  if (this->HasColorBar)
  {
    const double bottom = placements.back().Area.Y;
    const double top = placements.front().Area.Top();
    DrawColorBar(this->Painter, this->Colors, this->ColorTitle(),
      { rest.X, bottom, rest.Width, std::max(this->Em, top - bottom) });
  }
  return placements;
}

} // namespace pemesh

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

namespace
{

/** The least and greatest of the values that colour the marks. */
struct ValueRange
{
  double Low = NoValue;
  double High = NoValue;
  bool Logarithmic = false;

  void Add(double value)
  {
    if (std::isfinite(value) && (!this->Logarithmic || value > 0.0))
    {
      this->Low = std::fmin(this->Low, value);
      this->High = std::fmax(this->High, value);
    }
  }
};

} // namespace

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

bool ChartPainter::IsCounted(const ChartPlot& plot) const
{
  return plot.IsDensity && !plot.LegendIsNeeded && !plot.AllSeries.empty() &&
    plot.AllSeries[0].Values.empty();
}

void ChartPainter::MakeColorScale()
{
  ValueRange range;
  const ChartPlot& first = this->Picture.Plots.front();
  range.Logarithmic = first.LogColor;
  for (const ChartPlot& plot : this->Picture.Plots)
  {
    for (const ChartSeries& series : plot.AllSeries)
    {
      std::for_each(
        series.Values.begin(), series.Values.end(), [&range](double value) { range.Add(value); });
    }
    for (const ChartBar& bar : plot.Bars)
    {
      range.Add(bar.HasValue ? bar.Value : NoValue);
    }
    if (this->IsCounted(plot))
    {
      range.Add(1.0);
      range.Add(static_cast<double>(plot.AllSeries[0].X.size())); // until they are counted
      range.Logarithmic = true;
    }
  }
  const std::string& name =
    first.ColorMap.empty() ? this->Painter.Style().ColorMap : first.ColorMap;
  this->Colors.Map = FindColorMap(name) ? FindColorMap(name) : FindColorMap("viridis");
  this->Colors.Logarithmic = range.Logarithmic;
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
    if (this->IsCounted(this->Picture.Plots[i]))
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
    if (series.InLegend)
    {
      LegendEntry entry;
      entry.Text = series.Label;
      entry.Color = this->Painter.ColorOfSeries(series.Style);
      entry.Band = !series.Lower.empty();
      entry.LineType = MarkPainter::LineTypeOf(this->Painter, plot, series);
      entry.Marker = MarkPainter::MarkerOf(this->Painter, plot, series);
      entry.Patch = plot.IsDensity;
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
  const auto count = static_cast<int>(this->Axes.size());
  const int columns = std::max(1, std::min(this->Picture.Columns, count));
  const int rows = (count + columns - 1) / columns;
  const double gap = this->Picture.IsMatrix ? 0.0 : 0.6 * this->Em;
  const double height = std::max(this->Em, (box.Height - gap * (rows - 1)) / rows);
  const double width = std::max(this->Em, (box.Width - gap * (columns - 1)) / columns);
  if (!this->Picture.IsMatrix)
  {
    const auto cell = [&](int i)
    {
      return Box{ box.X + (i % columns) * (width + gap),
        box.Top() - (i / columns) * (height + gap) - height, width, height };
    };
    PlotMargins margins; // alike for all, so that the plots are in line
    for (int pass = 0; pass < 2; ++pass)
    {
      for (int i = 0; i < count; ++i)
      {
        PlotAxes& axes = this->Axes[static_cast<std::size_t>(i)];
        axes.LayOut(cell(i), margins);
      }
      for (const PlotAxes& axes : this->Axes)
      {
        margins.Include(axes.Margins());
      }
    }
    return;
  }
  // In a matrix only the left and lower plots have labels: these get more room.
  PlotMargins outer;
  for (int i = 0; i < count; ++i)
  {
    this->Axes[static_cast<std::size_t>(i)].LayOut({ box.X, box.Y, width, height });
    outer.Include(this->Axes[static_cast<std::size_t>(i)].Margins());
  }
  const double inner = 0.35 * this->Em;
  const double plotWidth = std::max(this->Em, (box.Width - outer.Left) / columns - 2.0 * inner);
  const double plotHeight = std::max(this->Em, (box.Height - outer.Bottom) / rows - 2.0 * inner);
  for (int i = 0; i < count; ++i)
  {
    const double left = i % columns == 0 ? outer.Left : inner;
    const double bottom = i / columns == rows - 1 ? outer.Bottom : inner;
    const double x = box.X + outer.Left + (i % columns) * (plotWidth + 2.0 * inner);
    const double y = box.Top() - (i / columns + 1) * (plotHeight + 2.0 * inner) + inner;
    this->Axes[static_cast<std::size_t>(i)].LayOut(
      { x - left, y - bottom, plotWidth + left + inner, plotHeight + bottom + inner },
      { left, inner, bottom, inner });
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
    : plot.IsEmpty                                  ? "no values to draw"
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
  return this->IsCounted(plot) ? "points" : plot.ColorTitle;
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

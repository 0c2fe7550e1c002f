// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPainter.h"

#include "ColorBar.h"

#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkRenderingCoreEnums.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

// In ems.
constexpr double TickLength = 0.35;
constexpr double MinorTickLength = 0.2;
constexpr double TickGap = 0.25;
constexpr double TitleGap = 0.45;
constexpr double AxisWidth = 0.08;
constexpr double GridWidth = 0.06;
constexpr double LineWidth = 0.16;

PanelText TickStyle(int horizontal, int vertical)
{
  PanelText style;
  style.Size = 0.9;
  style.Horizontal = horizontal;
  style.Vertical = vertical;
  return style;
}

PanelText AxisTitleStyle(double angle)
{
  PanelText style;
  style.Horizontal = 0;
  style.Vertical = angle == 0.0 ? -1 : 1;
  style.Angle = angle;
  return style;
}

/** A reader of a multiplier sees it at the end of its axis. */
constexpr double MultiplierHeight = 1.2;

} // namespace

ChartPainter::ChartPainter(
  vtkContext2D* context, double em, const ChartData& data, const ChartStyle& style)
  : Painter(context, em)
  , Data(data)
  , Style(style)
  , Em(em)
{
}

double ChartPainter::DeviceX(double x) const
{
  const AxisRange& range = this->Data.X;
  return this->Plot.X + this->Plot.Width * (x - range.Low) / (range.High - range.Low);
}

double ChartPainter::DeviceY(double y) const
{
  const AxisRange& range = this->Data.Y;
  return this->Plot.Y + this->Plot.Height * (y - range.Low) / (range.High - range.Low);
}

void ChartPainter::MakeColorScale()
{
  this->Colors.Map = FindColorMap("viridis");
  this->Colors.Logarithmic = this->Style.LogColor;
  double low = NAN;
  double high = NAN;
  for (const double value : this->Data.Colors)
  {
    if (std::isfinite(value) && (!this->Style.LogColor || value > 0.0))
    {
      low = std::fmin(low, value);
      high = std::fmax(high, value);
    }
  }
  this->HasColorBar = !std::isnan(low);
  this->Colors.Low = this->HasColorBar ? low : 1.0;
  this->Colors.High = this->HasColorBar ? high : 1.0;
}

std::vector<LegendEntry> ChartPainter::MakeLegend() const
{
  std::vector<LegendEntry> entries;
  const bool hasBand = std::any_of(this->Data.AllSeries.begin(), this->Data.AllSeries.end(),
    [](const ChartSeries& series) { return !series.Lower.empty(); });
  const bool isTold = this->Data.AllSeries.size() > 1 || this->Data.HasClasses || hasBand;
  if (!this->Style.ShowLegend || !isTold)
  {
    return entries;
  }
  for (const ChartSeries& series : this->Data.AllSeries)
  {
    LegendEntry entry;
    entry.Text = series.Label;
    entry.Color = SeriesColor(series.Style);
    entry.Band = !series.Lower.empty();
    if (!series.Y.empty())
    {
      entry.LineType = this->Style.JoinPoints ? this->LineType(series) : int(vtkPen::NO_PEN);
      entry.Marker = this->MarksPoints() ? SeriesMarker(series.Style) : int(VTK_MARKER_NONE);
    }
    entries.push_back(entry);
  }
  return entries;
}

int ChartPainter::LineType(const ChartSeries& series) const
{
  // Markers already tell series apart, and dashes between them are hard to follow.
  return this->MarksPoints() ? int(vtkPen::SOLID_LINE) : SeriesLineType(series.Style);
}

bool ChartPainter::MarksPoints() const
{
  constexpr std::size_t many = 60;
  return !this->Style.JoinPoints || this->Data.AllSeries.empty() ||
    this->Data.AllSeries[0].X.size() <= many;
}

double ChartPainter::MarkerSize() const
{
  const double rows =
    this->Data.AllSeries.empty() ? 1.0 : static_cast<double>(this->Data.AllSeries[0].X.size());
  const double size = this->Style.JoinPoints ? 0.55 : 0.7;
  return std::clamp(size * std::pow(50.0 / std::max(rows, 1.0), 0.25), 0.25, size);
}

void ChartPainter::LayOut(Box box)
{
  const double em = this->Em;
  this->Painter.TakeTitle(box, this->Style.Title);
  this->Painter.TakeNote(box, this->Style.Note);
  const double legendHeight = this->Painter.LegendHeight(this->Legend, box.Width);
  this->LegendTop = box.Top();
  box.Height -= legendHeight > 0.0 ? legendHeight + 0.3 * em : 0.0;
  // Heights first: they decide how many labels the y axis has, and so its width.
  this->LayOutHeights(box);
  this->LayOutWidths(box);
}

void ChartPainter::LayOutHeights(const Box& box)
{
  const double em = this->Em;
  const PanelText labels = TickStyle(0, 0);
  const PanelText titles = AxisTitleStyle(0.0);
  this->FittedXTitle = this->Painter.Fit(this->Style.XTitle, box.Width, 2, titles);
  const double below = (TickLength + TickGap) * em + labels.Size * LineSpacing * em +
    (this->FittedXTitle.empty()
        ? 0.0
        : TitleGap * em + this->Painter.TextHeight(this->FittedXTitle, titles));
  this->Plot.Y = box.Y + below;
  // Half a label of the y axis stands out above.
  this->Plot.Height = std::max(em, box.Top() - this->Plot.Y - 0.5 * em);
  const auto chooseYTicks = [this, em]()
  {
    const int maximum = std::clamp(static_cast<int>(this->Plot.Height / (2.2 * em)), 2, 8);
    this->YTicks = this->Style.LogY ? MakeLogTicks(this->Data.Y.Low, this->Data.Y.High, maximum)
                                    : MakeLinearTicks(this->Data.Y.Low, this->Data.Y.High, maximum);
  };
  chooseYTicks();
  if (!this->YTicks.Multiplier.empty())
  {
    this->Plot.Height = std::max(em, this->Plot.Height - (MultiplierHeight - 0.5) * em);
    chooseYTicks();
  }
}

void ChartPainter::LayOutWidths(const Box& box)
{
  const double em = this->Em;
  const PanelText labels = TickStyle(0, 0);
  const PanelText titles = AxisTitleStyle(0.0);
  this->YLabelWidth = 0.0;
  for (const AxisTick& tick : this->YTicks.Ticks)
  {
    this->YLabelWidth = std::max(this->YLabelWidth, this->Painter.TextWidth(tick.Label, labels));
  }
  this->FittedYTitle = this->Painter.Fit(this->Style.YTitle, this->Plot.Height, 2, titles);
  const double left = (TickLength + TickGap) * em + this->YLabelWidth +
    (this->FittedYTitle.empty()
        ? 0.0
        : TitleGap * em + this->Painter.TextHeight(this->FittedYTitle, titles));
  this->Plot.X = box.X + left;
  this->ColorBarRight = box.Right();
  const double right = this->HasColorBar
    ? ColorBarWidth(this->Painter, this->Colors, this->Style.ColorTitle, this->Plot.Height)
    : 0.6 * em;
  this->Plot.Width = std::max(em, box.Width - left - right);
  this->ChooseXTicks();
  // The last label may stand out on the right.
  double end = 0.0;
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    end = std::max(
      end, this->DeviceX(tick.Position) + 0.5 * this->Painter.TextWidth(tick.Label, labels));
  }
  if (end > box.Right())
  {
    this->Plot.Width = std::max(em, this->Plot.Width - (end - box.Right()));
    this->ChooseXTicks();
  }
  const double multiplier = this->Painter.TextWidth(this->XTicks.Multiplier, labels);
  if (multiplier > 0.0)
  {
    // It stands beside the title, which must not need more lines for that.
    const double room = this->Plot.Width - 2.0 * (multiplier + em);
    const auto titleLines =
      1 + static_cast<int>(std::count(this->FittedXTitle.begin(), this->FittedXTitle.end(), '\n'));
    this->FittedXTitle =
      this->Painter.Fit(this->Style.XTitle, std::max(room, em), titleLines, titles);
  }
}

void ChartPainter::ChooseXTicks()
{
  // As many as leave a gap between neighbouring labels.
  const double gap = 0.9 * this->Em;
  for (int maximum = std::clamp(static_cast<int>(this->Plot.Width / (3.0 * this->Em)), 2, 10);;
       --maximum)
  {
    this->XTicks = this->Style.LogX ? MakeLogTicks(this->Data.X.Low, this->Data.X.High, maximum)
                                    : MakeLinearTicks(this->Data.X.Low, this->Data.X.High, maximum);
    double end = -1e30;
    bool fits = true;
    for (AxisTick& tick : this->XTicks.Ticks)
    {
      if (!tick.Label.empty())
      {
        const double half = 0.5 * this->Painter.TextWidth(tick.Label, TickStyle(0, 1));
        const double middle = this->DeviceX(tick.Position);
        fits = fits && middle - half >= end;
        end = middle + half + gap;
      }
    }
    if (fits || maximum <= 2)
    {
      return;
    }
  }
}

void ChartPainter::DrawGrid()
{
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    const double x = this->DeviceX(tick.Position);
    if (tick.Major && x > this->Plot.X + 1e-3 * this->Em)
    {
      this->Painter.Line(x, this->Plot.Y, x, this->Plot.Top(), GridWidth, GridInk);
    }
  }
  for (const AxisTick& tick : this->YTicks.Ticks)
  {
    const double y = this->DeviceY(tick.Position);
    if (tick.Major && y > this->Plot.Y + 1e-3 * this->Em)
    {
      this->Painter.Line(this->Plot.X, y, this->Plot.Right(), y, GridWidth, GridInk);
    }
  }
}

void ChartPainter::DrawXAxis()
{
  const Box& plot = this->Plot;
  this->Painter.Line(plot.X, plot.Y, plot.Right(), plot.Y, AxisWidth, AxisInk);
  const double labelTop = plot.Y - (TickLength + TickGap) * this->Em;
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    const double x = this->DeviceX(tick.Position);
    const double length = (tick.Major ? TickLength : MinorTickLength) * this->Em;
    this->Painter.Line(x, plot.Y, x, plot.Y - length, AxisWidth, AxisInk);
    this->Painter.Text(x, labelTop, tick.Label, TickStyle(0, 1));
  }
  const PanelText labels = TickStyle(1, 1);
  const double titleTop = labelTop - (labels.Size * LineSpacing + TitleGap) * this->Em;
  this->Painter.Text(
    plot.Right(), labelTop - labels.Size * LineSpacing * this->Em, this->XTicks.Multiplier, labels);
  PanelText title = AxisTitleStyle(0.0);
  title.Vertical = 1;
  this->Painter.Text(plot.MiddleX(), titleTop, this->FittedXTitle, title);
}

void ChartPainter::DrawYAxis()
{
  const Box& plot = this->Plot;
  this->Painter.Line(plot.X, plot.Y, plot.X, plot.Top(), AxisWidth, AxisInk);
  const double labelRight = plot.X - (TickLength + TickGap) * this->Em;
  for (const AxisTick& tick : this->YTicks.Ticks)
  {
    const double y = this->DeviceY(tick.Position);
    const double length = (tick.Major ? TickLength : MinorTickLength) * this->Em;
    this->Painter.Line(plot.X, y, plot.X - length, y, AxisWidth, AxisInk);
    this->Painter.Text(labelRight, y, tick.Label, TickStyle(1, 0));
  }
  this->Painter.Text(plot.X - TickLength * this->Em, plot.Top() + 0.15 * this->Em,
    this->YTicks.Multiplier, TickStyle(-1, -1));
  PanelText title = AxisTitleStyle(90.0);
  title.Vertical = -1;
  this->Painter.Text(labelRight - this->YLabelWidth - TitleGap * this->Em, plot.MiddleY(),
    this->FittedYTitle, title);
}

void ChartPainter::DrawBand(const ChartSeries& series)
{
  // One polygon for every run of rows without a gap: there along the lower values, back along the
  // upper ones.
  ChartColor color = SeriesColor(series.Style);
  color[3] = 60;
  std::vector<float> there;
  std::vector<float> back;
  const auto finish = [&]()
  {
    for (std::size_t i = back.size(); i > 0; i -= 2)
    {
      there.push_back(back[i - 2]);
      there.push_back(back[i - 1]);
    }
    if (there.size() >= 8)
    {
      this->Painter.SetPen(0.0, color, vtkPen::NO_PEN);
      this->Painter.SetBrush(color);
      this->Painter.Context()->DrawPolygon(there.data(), static_cast<int>(there.size() / 2));
    }
    there.clear();
    back.clear();
  };
  for (std::size_t row = 0; row < series.Lower.size(); ++row)
  {
    if (std::isnan(series.X[row]) || std::isnan(series.Lower[row]) || std::isnan(series.Upper[row]))
    {
      finish();
      continue;
    }
    const auto x = static_cast<float>(this->DeviceX(series.X[row]));
    there.push_back(x);
    there.push_back(static_cast<float>(this->DeviceY(series.Lower[row])));
    back.push_back(x);
    back.push_back(static_cast<float>(this->DeviceY(series.Upper[row])));
  }
  finish();
}

void ChartPainter::DrawLines(const ChartSeries& series)
{
  const ChartColor color = SeriesColor(series.Style);
  const int lineType = this->LineType(series);
  std::vector<float> run;
  const auto finish = [&]()
  {
    if (run.size() == 2 && !this->MarksPoints())
    {
      // A value between two gaps has no line to be seen by.
      this->Painter.Marker(SeriesMarker(series.Style), run[0], run[1], this->MarkerSize(), color);
    }
    this->Painter.Poly(run, LineWidth, color, lineType);
    run.clear();
  };
  for (std::size_t row = 0; row < series.Y.size(); ++row)
  {
    if (std::isnan(series.X[row]) || std::isnan(series.Y[row]))
    {
      finish();
      continue;
    }
    run.push_back(static_cast<float>(this->DeviceX(series.X[row])));
    run.push_back(static_cast<float>(this->DeviceY(series.Y[row])));
  }
  finish();
}

void ChartPainter::DrawMarkers(const ChartSeries& series)
{
  const double size = this->MarkerSize();
  constexpr std::size_t many = 1000; // where edges would be most of what is seen
  const bool edge = series.X.size() <= many;
  for (std::size_t row = 0; row < series.Y.size(); ++row)
  {
    if (!std::isnan(series.X[row]) && !std::isnan(series.Y[row]))
    {
      const ChartColor color = this->Data.Colors.empty()
        ? SeriesColor(series.Style)
        : this->Colors.ColorOf(this->Data.Colors[row]);
      this->Painter.Marker(SeriesMarker(series.Style), this->DeviceX(series.X[row]),
        this->DeviceY(series.Y[row]), size, color, edge);
    }
  }
}

void ChartPainter::Paint(const Box& box)
{
  this->MakeColorScale();
  this->Legend = this->MakeLegend();
  this->LayOut(box);
  // In line with the plot area, unless that costs a row that was not reckoned with.
  const double fromPlot = box.Right() - this->Plot.X;
  const bool inLine = this->Painter.LegendHeight(this->Legend, fromPlot) <=
    this->Painter.LegendHeight(this->Legend, box.Width);
  const double legendX = inLine ? this->Plot.X : box.X;
  this->Painter.DrawLegend({ legendX, 0.0, box.Right() - legendX, this->LegendTop }, this->Legend);
  this->DrawGrid();
  vtkContextDevice2D* device = this->Painter.Context()->GetDevice();
  if (this->Style.ClipToRange)
  {
    int clip[4] = { static_cast<int>(std::floor(this->Plot.X)),
      static_cast<int>(std::floor(this->Plot.Y)), static_cast<int>(std::ceil(this->Plot.Width)),
      static_cast<int>(std::ceil(this->Plot.Height)) };
    device->SetClipping(clip);
    device->EnableClipping(true);
  }
  for (const ChartSeries& series : this->Data.AllSeries)
  {
    this->DrawBand(series);
  }
  for (const ChartSeries& series : this->Data.AllSeries)
  {
    if (this->Style.JoinPoints)
    {
      this->DrawLines(series);
    }
    if (this->MarksPoints())
    {
      this->DrawMarkers(series);
    }
  }
  if (this->Style.ClipToRange)
  {
    device->EnableClipping(false);
  }
  this->DrawXAxis();
  this->DrawYAxis();
  if (this->Data.IsEmpty)
  {
    PanelText style;
    style.Horizontal = 0;
    style.Ink = FaintInk;
    this->Painter.Text(this->Plot.MiddleX(), this->Plot.MiddleY(), "no values to draw", style);
  }
  if (this->HasColorBar)
  {
    DrawColorBar(this->Painter, this->Colors, this->Style.ColorTitle,
      { this->Plot.X, this->Plot.Y, this->ColorBarRight - this->Plot.X, this->Plot.Height });
  }
}

} // namespace pemesh

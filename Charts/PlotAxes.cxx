// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlotAxes.h"

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
/** A reader of a multiplier sees it at the end of its axis. */
constexpr double MultiplierHeight = 1.2;

PanelText PlotTitle()
{
  PanelText style;
  style.Horizontal = 0;
  style.Vertical = 1;
  return style;
}

bool IsSeen(double place, const AxisRange& range)
{
  const double slack = 1e-9 * (range.High - range.Low);
  return place >= range.Low - slack && place <= range.High + slack;
}

} // namespace

void PlotMargins::Include(const PlotMargins& other)
{
  this->Left = std::max(this->Left, other.Left);
  this->Right = std::max(this->Right, other.Right);
  this->Bottom = std::max(this->Bottom, other.Bottom);
  this->Top = std::max(this->Top, other.Top);
}

PlotAxes::PlotAxes(
  PanelPainter& painter, const ChartPlot& plot, const AxisRange& x, const AxisRange& y)
  : Painter(painter)
  , Plot(plot)
  , Em(painter.Em())
{
  this->Place.X = x;
  this->Place.Y = y;
}

PanelText PlotAxes::TickText(int horizontal, int vertical) const
{
  PanelText style;
  style.Size = this->Painter.Style().TickSize;
  style.Horizontal = horizontal;
  style.Vertical = vertical;
  return style;
}

PanelText PlotAxes::TitleText(double angle) const
{
  PanelText style;
  style.Size = this->Painter.Style().AxisTitleSize;
  style.Horizontal = 0;
  style.Vertical = angle == 0.0 ? 1 : -1;
  style.Angle = angle;
  return style;
}

PlotMargins PlotAxes::Margins() const
{
  const Box& area = this->Place.Area;
  return { area.X - this->Cell.X, this->Cell.Right() - area.Right(), area.Y - this->Cell.Y,
    this->Cell.Top() - area.Top() };
}

void PlotAxes::LayOut(const Box& box, const PlotMargins& least)
{
  this->Cell = box;
  // Heights first: they decide how many labels the y axis has, and so its width.
  this->LayOutHeights(box, least);
  this->LayOutWidths(box, least);
}

AxisTicks PlotAxes::MakeNumberTicks(
  const ChartAxis& axis, const AxisRange& range, int maximum) const
{
  return axis.Logarithmic ? MakeLogTicks(range.Low, range.High, maximum)
                          : MakeLinearTicks(range.Low, range.High, maximum);
}

/** `length`: of the axis; `room`: for a label. Where names would overlap, some are left out. */
AxisTicks PlotAxes::MakeCategoryTicks(
  const ChartAxis& axis, const AxisRange& range, double length, double room)
{
  AxisTicks ticks;
  const double slot = length / (range.High - range.Low);
  const double line = this->Painter.Style().TickSize * LineSpacing * this->Em;
  const auto stride =
    static_cast<std::size_t>(std::max(1.0, std::ceil(line / std::max(slot, 1e-9))));
  for (std::size_t i = 0; i < axis.Categories.size(); i += stride)
  {
    if (IsSeen(static_cast<double>(i), range))
    {
      ticks.Ticks.push_back({ static_cast<double>(i),
        this->Painter.Fit(axis.Categories[i], room, 1, this->TickText(0, 0)), true });
    }
  }
  return ticks;
}

void PlotAxes::ChooseYTicks()
{
  const ChartAxis& axis = this->Plot.Y;
  const double height = this->Place.Area.Height;
  const int maximum = std::clamp(static_cast<int>(height / (2.2 * this->Em)), 2, 8);
  this->YTicks = axis.Categories.empty()
    ? this->MakeNumberTicks(axis, this->Place.Y, maximum)
    : this->MakeCategoryTicks(axis, this->Place.Y, height, 0.35 * this->Cell.Width);
}

void PlotAxes::LayOutHeights(const Box& box, const PlotMargins& least)
{
  const double em = this->Em;
  const PanelText titles = this->TitleText(0.0);
  Box& area = this->Place.Area;
  this->XLabelHeight = this->Painter.Style().TickSize * LineSpacing * em;
  if (!this->Plot.X.Categories.empty())
  {
    area.Width = box.Width - std::max(least.Left, 4.0 * em);
    this->ChooseXTicks();
    for (const AxisTick& tick : this->XTicks.Ticks)
    {
      this->XLabelHeight = std::max(this->XLabelHeight,
        this->XLabelsAreUpright ? this->Painter.TextWidth(tick.Label, this->TickText(0, 0)) : 0.0);
    }
  }
  double below = 0.3 * em;
  if (this->Plot.X.HasLabels)
  {
    // A little less than the room keeps it from the title of a neighbour.
    this->FittedXTitle = this->Painter.Fit(this->Plot.X.Title, box.Width - 0.4 * em, 2, titles);
    below = (TickLength + TickGap) * em + this->XLabelHeight +
      (this->FittedXTitle.empty()
          ? 0.0
          : TitleGap * em + this->Painter.TextHeight(this->FittedXTitle, titles));
  }
  this->FittedTitle = this->Painter.Fit(this->Plot.Title, box.Width, 2, PlotTitle());
  const double title =
    this->FittedTitle.empty() ? 0.0 : this->Painter.TextHeight(this->FittedTitle) + 0.2 * em;
  area.Y = box.Y + std::max(below, least.Bottom);
  // Half a label of the y axis stands out above.
  double above = std::max(title + 0.5 * em, least.Top);
  area.Height = std::max(em, box.Top() - area.Y - above);
  this->ChooseYTicks();
  if (!this->YTicks.Multiplier.empty() && this->Plot.Y.HasLabels)
  {
    above = std::max(title + MultiplierHeight * em, least.Top);
    area.Height = std::max(em, box.Top() - area.Y - above);
    this->ChooseYTicks();
  }
}

void PlotAxes::LayOutWidths(const Box& box, const PlotMargins& least)
{
  const double em = this->Em;
  const PanelText titles = this->TitleText(0.0);
  Box& area = this->Place.Area;
  this->YLabelWidth = 0.0;
  double left = 0.3 * em;
  if (this->Plot.Y.HasLabels)
  {
    for (const AxisTick& tick : this->YTicks.Ticks)
    {
      this->YLabelWidth =
        std::max(this->YLabelWidth, this->Painter.TextWidth(tick.Label, this->TickText(0, 0)));
    }
    this->FittedYTitle = this->Painter.Fit(this->Plot.Y.Title, area.Height, 2, titles);
    left = (TickLength + TickGap) * em + this->YLabelWidth +
      (this->FittedYTitle.empty()
          ? 0.0
          : TitleGap * em + this->Painter.TextHeight(this->FittedYTitle, titles));
  }
  area.X = box.X + std::max(left, least.Left);
  area.Width = std::max(em, box.Right() - std::max(0.6 * em, least.Right) - area.X);
  this->ChooseXTicks();
  if (this->Plot.X.HasLabels)
  {
    this->MakeRoomForLastLabel(box);
    this->FitXTitle();
  }
}

void PlotAxes::MakeRoomForLastLabel(const Box& box)
{
  double end = 0.0;
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    const double width = this->XLabelsAreUpright
      ? this->Em
      : this->Painter.TextWidth(tick.Label, this->TickText(0, 0));
    end = std::max(end, this->Place.DeviceX(tick.Position) + 0.5 * width);
  }
  if (end > box.Right())
  {
    Box& area = this->Place.Area;
    area.Width = std::max(this->Em, area.Width - (end - box.Right()));
    this->ChooseXTicks();
  }
}

/** A multiplier stands beside the title, which must not need more lines for that. */
void PlotAxes::FitXTitle()
{
  const double multiplier = this->Painter.TextWidth(this->XTicks.Multiplier, this->TickText(0, 0));
  if (multiplier > 0.0 && !this->Plot.X.Title.empty())
  {
    const double room = this->Place.Area.Width - 2.0 * (multiplier + this->Em);
    const auto lines =
      1 + static_cast<int>(std::count(this->FittedXTitle.begin(), this->FittedXTitle.end(), '\n'));
    if (room < 4.0 * this->Em) // beside it nothing would be left of the title
    {
      this->FittedXTitle = this->Painter.Fit(this->XTicks.Multiplier + " " + this->Plot.X.Title,
        this->Cell.Width - 0.4 * this->Em, lines, this->TitleText(0.0));
      this->XTicks.Multiplier.clear();
      return;
    }
    this->FittedXTitle = this->Painter.Fit(this->Plot.X.Title, room, lines, this->TitleText(0.0));
  }
}

bool PlotAxes::XLabelsFit(double gap)
{
  double end = -1e30;
  bool fits = true;
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    if (!tick.Label.empty())
    {
      const double half = 0.5 * this->Painter.TextWidth(tick.Label, this->TickText(0, 1));
      const double middle = this->Place.DeviceX(tick.Position);
      fits = fits && middle - half >= end;
      end = middle + half + gap;
    }
  }
  return fits;
}

void PlotAxes::ChooseXTicks()
{
  const ChartAxis& axis = this->Plot.X;
  const double width = this->Place.Area.Width;
  const double gap = 0.9 * this->Em;
  if (!axis.Categories.empty())
  {
    const double room = 0.3 * this->Cell.Height;
    this->XTicks = this->MakeCategoryTicks(axis, this->Place.X, width, room);
    this->XLabelsAreUpright = !this->XLabelsFit(0.5 * gap);
    return;
  }
  // As many as leave a gap between neighbouring labels.
  int maximum = std::clamp(static_cast<int>(width / (3.0 * this->Em)), 2, 10);
  this->XTicks = this->MakeNumberTicks(axis, this->Place.X, maximum);
  while (!this->XLabelsFit(gap) && maximum > 2)
  {
    --maximum;
    this->XTicks = this->MakeNumberTicks(axis, this->Place.X, maximum);
  }
  this->DropLabels(gap);
}

/** Where even two labels are too close, the later one goes; so do those that reach a neighbour. */
void PlotAxes::DropLabels(double gap)
{
  double end = -1e30;
  for (AxisTick& tick : this->XTicks.Ticks)
  {
    const double half = 0.5 * this->Painter.TextWidth(tick.Label, this->TickText(0, 1));
    const double middle = this->Place.DeviceX(tick.Position);
    const bool isOut =
      middle - half < this->Cell.X - 0.5 * gap || middle + half > this->Cell.Right() + 0.5 * gap;
    if (!tick.Label.empty() && (middle - half < end || isOut))
    {
      tick.Label.clear();
    }
    end = tick.Label.empty() ? end : middle + half + 0.3 * gap;
  }
}

void PlotAxes::DrawGrid()
{
  const std::string& grid = this->Painter.Style().Grid;
  const Box& area = this->Place.Area;
  const bool all = grid == "all";
  const auto has = [&](const ChartAxis& axis, const char* name, const AxisTick& tick)
  {
    return axis.Categories.empty() && (tick.Major || all) &&
      (all || grid == "major" || grid == name);
  };
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    const double x = this->Place.DeviceX(tick.Position);
    if (has(this->Plot.X, "x", tick) && x > area.X + 1e-3 * this->Em)
    {
      this->Painter.Line(
        x, area.Y, x, area.Top(), tick.Major ? GridWidth : 0.5 * GridWidth, GridInk);
    }
  }
  for (const AxisTick& tick : this->YTicks.Ticks)
  {
    const double y = this->Place.DeviceY(tick.Position);
    if (has(this->Plot.Y, "y", tick) && y > area.Y + 1e-3 * this->Em)
    {
      this->Painter.Line(
        area.X, y, area.Right(), y, tick.Major ? GridWidth : 0.5 * GridWidth, GridInk);
    }
  }
}

void PlotAxes::DrawXAxis()
{
  const Box& area = this->Place.Area;
  const bool names = !this->Plot.X.Categories.empty();
  this->Painter.Line(area.X, area.Y, area.Right(), area.Y, AxisWidth, AxisInk);
  const double labelTop = area.Y - (TickLength + TickGap) * this->Em;
  for (const AxisTick& tick : this->XTicks.Ticks)
  {
    const double x = this->Place.DeviceX(tick.Position);
    const double length = names ? 0.0 : (tick.Major ? TickLength : MinorTickLength) * this->Em;
    this->Painter.Line(x, area.Y, x, area.Y - length, AxisWidth, AxisInk);
    if (this->Plot.X.HasLabels)
    {
      PanelText text =
        this->TickText(this->XLabelsAreUpright ? 1 : 0, this->XLabelsAreUpright ? 0 : 1);
      text.Angle = this->XLabelsAreUpright ? 90.0 : 0.0;
      this->Painter.Text(x, labelTop, tick.Label, text);
    }
  }
  if (!this->Plot.X.HasLabels)
  {
    return;
  }
  const double labelBottom = labelTop - this->XLabelHeight;
  this->Painter.Text(area.Right(), labelBottom, this->XTicks.Multiplier, this->TickText(1, 1));
  // In the middle of the axis, or as near to it as the cell allows.
  const double half = 0.5 * this->Painter.TextWidth(this->FittedXTitle, this->TitleText(0.0));
  const double x = std::max(std::min(area.MiddleX(), this->Cell.Right() - half),
    std::min(this->Cell.X + half, area.MiddleX()));
  this->Painter.Text(
    x, labelBottom - TitleGap * this->Em, this->FittedXTitle, this->TitleText(0.0));
}

void PlotAxes::DrawYAxis()
{
  const Box& area = this->Place.Area;
  const bool names = !this->Plot.Y.Categories.empty();
  this->Painter.Line(area.X, area.Y, area.X, area.Top(), AxisWidth, AxisInk);
  const double labelRight = area.X - (TickLength + TickGap) * this->Em;
  for (const AxisTick& tick : this->YTicks.Ticks)
  {
    const double y = this->Place.DeviceY(tick.Position);
    const double length = names ? 0.0 : (tick.Major ? TickLength : MinorTickLength) * this->Em;
    this->Painter.Line(area.X, y, area.X - length, y, AxisWidth, AxisInk);
    if (this->Plot.Y.HasLabels)
    {
      this->Painter.Text(labelRight, y, tick.Label, this->TickText(1, 0));
    }
  }
  if (!this->Plot.Y.HasLabels)
  {
    return;
  }
  this->Painter.Text(area.X - TickLength * this->Em, area.Top() + 0.15 * this->Em,
    this->YTicks.Multiplier, this->TickText(-1, -1));
  this->Painter.Text(labelRight - this->YLabelWidth - TitleGap * this->Em, area.MiddleY(),
    this->FittedYTitle, this->TitleText(90.0));
}

void PlotAxes::DrawAxes()
{
  const Box& area = this->Place.Area;
  if (this->Painter.Style().Frame)
  {
    this->Painter.Line(area.X, area.Top(), area.Right(), area.Top(), AxisWidth, AxisInk);
    this->Painter.Line(area.Right(), area.Y, area.Right(), area.Top(), AxisWidth, AxisInk);
  }
  this->DrawXAxis();
  this->DrawYAxis();
  this->Painter.Text(this->Cell.MiddleX(), this->Cell.Top(), this->FittedTitle, PlotTitle());
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColorBar.h"

#include "AxisTicks.h"

#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRect.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr double Gap = 1.0;
constexpr double BarWidth = 0.9;
constexpr double TickLength = 0.3;
constexpr double TickGap = 0.25;
constexpr double TitleGap = 0.2;
constexpr double TickSize = 0.9;

PanelText TickStyle()
{
  PanelText style;
  style.Size = TickSize;
  return style;
}

PanelText TitleStyle()
{
  PanelText style;
  style.Horizontal = 0;
  style.Vertical = 1;
  style.Angle = 90.0;
  return style;
}

/** Ticks at places from 0 to 1. */
AxisTicks MakeTicks(PanelPainter& painter, const ColorScale& scale, double height)
{
  AxisTicks ticks;
  if (!(scale.High > scale.Low))
  {
    ticks.Ticks.push_back({ 0.5, ReadableNumber(scale.Low), true });
    return ticks;
  }
  const int maximum = std::clamp(static_cast<int>(height / (2.2 * painter.Em())), 2, 9);
  const double low = scale.Logarithmic ? std::log10(scale.Low) : scale.Low;
  const double high = scale.Logarithmic ? std::log10(scale.High) : scale.High;
  ticks =
    scale.Logarithmic ? MakeLogTicks(low, high, maximum) : MakeLinearTicks(low, high, maximum);
  for (AxisTick& tick : ticks.Ticks)
  {
    tick.Position = (tick.Position - low) / (high - low);
  }
  std::erase_if(ticks.Ticks,
    [](const AxisTick& tick) { return tick.Position < -1e-9 || tick.Position > 1.0 + 1e-9; });
  // A range too short for two ticks says its ends.
  const auto labels = std::count_if(ticks.Ticks.begin(), ticks.Ticks.end(),
    [](const AxisTick& tick) { return !tick.Label.empty(); });
  if (labels < 2)
  {
    ticks.Multiplier.clear();
    ticks.Ticks = { { 0.0, ReadableNumber(scale.Low, 5), true },
      { 1.0, ReadableNumber(scale.High, 5), true } };
  }
  return ticks;
}

/** The multiplier of all labels stands above the bar, and takes its place. */
double BarHeight(const PanelPainter& painter, const AxisTicks& ticks, double height)
{
  return ticks.Multiplier.empty() ? height : height - 1.3 * painter.Em();
}

double LabelWidth(PanelPainter& painter, const AxisTicks& ticks)
{
  double width = 0.0;
  for (const AxisTick& tick : ticks.Ticks)
  {
    width = std::max(width, painter.TextWidth(tick.Label, TickStyle()));
  }
  return width;
}

} // namespace

double ColorBarWidth(
  PanelPainter& painter, const ColorScale& scale, const std::string& title, double height)
{
  const AxisTicks ticks = MakeTicks(painter, scale, height);
  const std::string fitted = painter.Fit(title, height, 2, TitleStyle());
  const double titleWidth =
    fitted.empty() ? 0.0 : TitleGap * painter.Em() + painter.TextHeight(fitted, TitleStyle());
  return (Gap + BarWidth + TickLength + TickGap) * painter.Em() + LabelWidth(painter, ticks) +
    titleWidth;
}

void DrawColorBar(
  PanelPainter& painter, const ColorScale& scale, const std::string& title, const Box& box)
{
  const double em = painter.Em();
  const AxisTicks ticks = MakeTicks(painter, scale, box.Height);
  const std::string fitted = painter.Fit(title, box.Height, 2, TitleStyle());
  const double left = box.Right() - ColorBarWidth(painter, scale, title, box.Height) + Gap * em;
  const Box bar = { left, box.Y, BarWidth * em, BarHeight(painter, ticks, box.Height) };
  painter.Text(bar.X, bar.Top() + 0.75 * em, ticks.Multiplier, TickStyle());

  constexpr int levels = 256;
  vtkNew<vtkImageData> colors;
  colors->SetDimensions(1, levels, 1);
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(colors->GetScalarPointer());
  for (int i = 0; i < levels; ++i)
  {
    const ChartColor color = MapColor(*scale.Map, (i + 0.5) / levels);
    bytes = std::copy(color.begin(), color.end(), bytes);
  }
  painter.Context()->DrawImage(vtkRectf(static_cast<float>(bar.X), static_cast<float>(bar.Y),
                                 static_cast<float>(bar.Width), static_cast<float>(bar.Height)),
    colors);
  std::vector<float> frame;
  for (const auto& [x, y] : { std::pair{ bar.X, bar.Y }, { bar.Right(), bar.Y },
         { bar.Right(), bar.Top() }, { bar.X, bar.Top() }, { bar.X, bar.Y } })
  {
    frame.push_back(static_cast<float>(x));
    frame.push_back(static_cast<float>(y));
  }
  painter.Poly(frame, 0.06, AxisInk);

  for (const AxisTick& tick : ticks.Ticks)
  {
    const double y = bar.Y + tick.Position * bar.Height;
    const double length = (tick.Major ? TickLength : 0.5 * TickLength) * em;
    painter.Line(bar.Right(), y, bar.Right() + length, y, 0.07, AxisInk);
    painter.Text(bar.Right() + (TickLength + TickGap) * em, y, tick.Label, TickStyle());
  }
  const double titleX =
    bar.Right() + (TickLength + TickGap + TitleGap) * em + LabelWidth(painter, ticks);
  painter.Text(titleX, box.MiddleY(), fitted, TitleStyle());
}

} // namespace pemesh

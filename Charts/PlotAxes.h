// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lays out and draws one pair of axes. Private to this module.
 */
#ifndef pemesh_PlotAxes_h
#define pemesh_PlotAxes_h

#include "ChartPlot.h"
#include "PanelPainter.h"

namespace pemesh
{

/** Where a plot was drawn, and which part of its axes is seen. */
struct PlotPlacement
{
  Box Area;
  AxisRange X; // places
  AxisRange Y;

  /** How far along a range a place is; by halves, because differences may overflow. */
  static double Part(double place, const AxisRange& range)
  {
    return (0.5 * place - 0.5 * range.Low) / (0.5 * (range.High - range.Low));
  }
  double DeviceX(double place) const
  {
    return this->Area.X + this->Area.Width * Part(place, this->X);
  }
  double DeviceY(double place) const
  {
    return this->Area.Y + this->Area.Height * Part(place, this->Y);
  }
  double PlaceX(double device) const
  {
    return this->X.Low + (device - this->Area.X) / this->Area.Width * (this->X.High - this->X.Low);
  }
  double PlaceY(double device) const
  {
    return this->Y.Low + (device - this->Area.Y) / this->Area.Height * (this->Y.High - this->Y.Low);
  }
  bool Contains(double x, double y) const
  {
    return x >= this->Area.X && x <= this->Area.Right() && y >= this->Area.Y &&
      y <= this->Area.Top();
  }
};

/** Room around a plot for its labels, in units of the device. */
struct PlotMargins
{
  double Left = 0.0;
  double Right = 0.0;
  double Bottom = 0.0;
  double Top = 0.0;

  void Include(const PlotMargins& other);
};

class PlotAxes
{
public:
  PlotAxes(PanelPainter& painter, const ChartPlot& plot, const AxisRange& x, const AxisRange& y);

  /** Fits the plot and its labels into a box, with margins at least as wide as these. */
  void LayOut(const Box& box, const PlotMargins& least = {});
  PlotMargins Margins() const;

  const PlotPlacement& Placement() const { return this->Place; }

  void DrawGrid();
  void DrawAxes();

private:
  void LayOutHeights(const Box& box, const PlotMargins& least);
  void LayOutWidths(const Box& box, const PlotMargins& least);
  void ChooseYTicks();
  void ChooseXTicks();
  void MakeRoomForLastLabel(const Box& box);
  void FitXTitle();
  AxisTicks MakeNumberTicks(const ChartAxis& axis, const AxisRange& range, int maximum) const;
  AxisTicks MakeCategoryTicks(
    const ChartAxis& axis, const AxisRange& range, double length, double room);
  bool XLabelsFit(double gap);
  void DropLabels(double gap);
  void DrawXAxis();
  void DrawYAxis();
  PanelText TickText(int horizontal, int vertical) const;
  PanelText TitleText(double angle) const;

  PanelPainter& Painter;
  const ChartPlot& Plot;
  double Em;
  Box Cell;
  PlotPlacement Place;
  AxisTicks XTicks;
  AxisTicks YTicks;
  bool XLabelsAreUpright = false;
  double XLabelHeight = 0.0;
  double YLabelWidth = 0.0;
  std::string FittedTitle;
  std::string FittedXTitle;
  std::string FittedYTitle;
};

} // namespace pemesh

#endif

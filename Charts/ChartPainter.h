// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lays out and draws a chart. Private to this module.
 */
#ifndef pemesh_ChartPainter_h
#define pemesh_ChartPainter_h

#include "ChartData.h"
#include "PanelPainter.h"

namespace pemesh
{

struct ChartStyle
{
  std::string Title;
  std::string XTitle;
  std::string YTitle;
  std::string ColorTitle;
  std::string Note;
  bool JoinPoints = true;
  bool LogX = false;
  bool LogY = false;
  bool LogColor = false;
  bool ShowLegend = true;
  bool ClipToRange = false; // a range was asked for that need not hold all points
};

class ChartPainter
{
public:
  ChartPainter(vtkContext2D* context, double em, const ChartData& data, const ChartStyle& style);

  void Paint(const Box& box);

  /** Of the last painting, in units of the device. */
  const Box& PlotArea() const { return this->Plot; }

private:
  void MakeColorScale();
  std::vector<LegendEntry> MakeLegend() const;
  void LayOut(Box box);
  void LayOutHeights(const Box& box);
  void LayOutWidths(const Box& box);
  void ChooseXTicks();
  void DrawGrid();
  void DrawXAxis();
  void DrawYAxis();
  void DrawBand(const ChartSeries& series);
  void DrawLines(const ChartSeries& series);
  void DrawMarkers(const ChartSeries& series);
  int LineType(const ChartSeries& series) const;
  double MarkerSize() const;
  bool MarksPoints() const;
  double DeviceX(double x) const;
  double DeviceY(double y) const;

  PanelPainter Painter;
  const ChartData& Data;
  const ChartStyle& Style;
  double Em;
  Box Plot;
  AxisTicks XTicks;
  AxisTicks YTicks;
  std::vector<LegendEntry> Legend;
  double LegendTop = 0.0;
  double YLabelWidth = 0.0;
  std::string FittedXTitle;
  std::string FittedYTitle;
  bool HasColorBar = false;
  ColorScale Colors;
  double ColorBarRight = 0.0;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Draws the marks of a plot into its axes. Private to this module.
 *
 * What cannot be told apart is not drawn twice: a line keeps the first, last, lowest and highest
 * point of every column of dots, and clouds of many points become an image of cells that tells how
 * many are where. Picking does not depend on that.
 */
#ifndef pemesh_MarkPainter_h
#define pemesh_MarkPainter_h

#include "PlotAxes.h"

#include <vtkSmartPointer.h> // For images
#include <vtkType.h>         // For vtkIdType

class vtkImageData;

namespace pemesh
{

/** How many points fall into each cell of a grid over the plot. */
struct PointDensity
{
  int Columns = 0;
  int Rows = 0;
  std::vector<int> Counts; // row by row from below
  int Largest = 0;
};

PointDensity CountPoints(const ChartSeries& series, const PlotPlacement& place, double cellSize);

class MarkPainter
{
public:
  MarkPainter(PanelPainter& painter, const ChartPlot& plot, const PlotPlacement& place,
    const ColorScale& colors, const std::vector<vtkIdType>& highlighted);

  void Draw();

  ///@{
  /** How a series is drawn, for its legend as well. */
  static int MarkerOf(
    const PanelPainter& painter, const ChartPlot& plot, const ChartSeries& series);
  static int LineTypeOf(
    const PanelPainter& painter, const ChartPlot& plot, const ChartSeries& series);
  ///@}

  /** Size of a cell of a density, in ems. */
  static constexpr double DensityCell = 0.32;

private:
  void DrawBar(const ChartBar& bar);
  /** Of the texts in all bars, in ems: where one of them does not fit there are none (0). */
  double FindBarTextSize() const;
  void DrawShape(const ChartShape& shape);
  void DrawBand(const ChartSeries& series);
  void DrawLines(const ChartSeries& series);
  void DrawRun(std::vector<float>& run, double width, const ChartColor& color, int lineType);
  /** A line that goes to and fro over the plot, as an image; false where it does not. */
  bool DrawTangle(const std::vector<float>& run, double width, const ChartColor& color);
  void DrawMarkers(const ChartSeries& series);
  void DrawDensity(const ChartSeries& series);
  /** Of several clouds, or of one coloured by numbers: mixed colours, mean values. */
  void DrawMixedDensity();
  void DrawHighlights(const ChartSeries& series);
  void DrawText(const ChartText& text);
  void DrawImage(const std::vector<ChartColor>& dots, int columns, int rows);
  double MarkerSize(const ChartSeries& series) const;
  ChartColor ColorOf(const ChartSeries& series, std::size_t point) const;
  bool IsHighlighted(vtkIdType row) const;
  Box DeviceBox(const ChartBar& bar) const;

  PanelPainter& Painter;
  const ChartPlot& Plot;
  const PlotPlacement& Place;
  const ColorScale& Colors;
  const std::vector<vtkIdType>& Highlighted; // ascending
  double Em;
  double BarTextSize = 0.0;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lays out and draws the picture of a chart: title, legend, color bar, and the plots in their grid.
 * Private to this module.
 */
#ifndef pemesh_ChartPainter_h
#define pemesh_ChartPainter_h

#include "PlotAxes.h"

#include <map>

namespace pemesh
{

/** What a picture does not say of itself. */
struct ChartView
{
  std::string Title;
  std::string Note;
  bool ShowLegend = true;
  std::map<int, AxisRange> Ranges;    // that are seen, by the group of axes
  std::vector<vtkIdType> Highlighted; // rows, ascending

  const AxisRange& RangeOf(const ChartAxis& axis) const
  {
    const auto found = this->Ranges.find(axis.Group);
    return found == this->Ranges.end() ? axis.Range : found->second;
  }
};

class ChartPainter
{
public:
  ChartPainter(PanelPainter& painter, const ChartPicture& picture, const ChartView& view);

  /** Draws, and answers where the plots are. */
  std::vector<PlotPlacement> Paint(const Box& box);

private:
  bool IsCounted(const ChartPlot& plot) const;
  void MakeColorScale();
  void CountDensest();
  std::vector<LegendEntry> MakeLegend() const;
  void TakeLegend(Box& box);
  void DrawLegend();
  void LayOutPlots(const Box& box);
  void DrawPlot(std::size_t index);
  std::string ColorTitle() const;

  PanelPainter& Painter;
  const ChartPicture& Picture;
  const ChartView& View;
  double Em;
  std::vector<PlotAxes> Axes;
  std::vector<LegendEntry> Legend;
  Box LegendBox;
  Box Rest;
  bool HasColorBar = false;
  ColorScale Colors;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How charts look: everything that is the same whatever they show.
 *
 * Lengths in points are those of the printed figure at its font size; on a screen they grow with
 * the text.
 */
#ifndef pemesh_ChartStyle_h
#define pemesh_ChartStyle_h

#include "SettingFields.h"
#include "pemeshChartsModule.h" // For export macro

#include <span>
#include <string>

namespace pemesh
{

struct ChartStyle
{
  std::string Palette = "okabe-ito";  // a name of ColorPalettes()
  std::string ColorMap = "viridis";   // a name of ColorMaps()
  std::string Background = "#ffffff"; // of the whole figure
  std::string Ink = "#222222";        // of text; axes and grid are mixed from both
  std::string FontFamily = "DejaVu Sans";
  double FontSize = 8.0;  // points
  double TitleSize = 1.1; // times the font size, as the next ones
  double AxisTitleSize = 1.0;
  double TickSize = 0.9;
  double LegendSize = 0.94;
  std::string Marker = "automatic"; // automatic: another one for every series
  double MarkerSize = 0.0;          // points; 0: by the number of points
  double MarkerOpacity = 1.0;       // 0 to 1
  bool MarkerEdges = true;          // a thin edge in the colour of the background
  double LineWidth = 1.28;          // points
  std::string Dashes = "automatic"; // automatic: where there are no markers to tell by
  double BandOpacity = 0.24;        // 0 to 1
  std::string Grid = "major";
  bool Frame = false; // axes on all four sides
  std::string Legend = "top";
  bool ColorBar = true;
  double Width = 0.0;        // centimetres; 0: 10 for every column of panels
  double Height = 0.0;       // centimetres; 0: what suits the panels
  double Resolution = 300.0; // pixels an inch of a PNG

  bool operator==(const ChartStyle&) const = default;
};

/** The table of all members. */
PEMESHCHARTS_EXPORT std::span<const SettingField<ChartStyle>> ChartStyleFields();

} // namespace pemesh

#endif

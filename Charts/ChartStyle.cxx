// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartStyle.h"

#include "ColorMaps.h"

#include <vector>

namespace pemesh
{

namespace
{

using S = ChartStyle;

template <typename Table>
std::vector<std::string> NamesOf(const Table& table)
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

std::vector<SettingField<ChartStyle>> MakeFields()
{
  return {
    { "palette", "Colours of series",
      "Colours of series and classes; all but grey are made for every colour vision.", &S::Palette,
      0, 0, NamesOf(ColorPalettes()) },
    { "color-map", "Colour map", "Colours of numbers.", &S::ColorMap, 0, 0, NamesOf(ColorMaps()) },
    { "background", "Background", "Colour of the figure.", &S::Background, 0, 0, {}, true },
    { "ink", "Ink", "Colour of the text; axes and grid are between it and the background.", &S::Ink,
      0, 0, {}, true },
    { "font-family", "Font", "Family of the text.", &S::FontFamily },
    { "font-size", "Font size", "Size of the text in points.", &S::FontSize, 3, 72 },
    { "title-size", "Title size", "Size of titles, in font sizes.", &S::TitleSize, 0.3, 5 },
    { "axis-title-size", "Axis title size", "Size of the titles of axes, in font sizes.",
      &S::AxisTitleSize, 0.3, 5 },
    { "tick-size", "Tick label size", "Size of the numbers at axes, in font sizes.", &S::TickSize,
      0.3, 5 },
    { "legend-size", "Legend size", "Size of the text of legends, in font sizes.", &S::LegendSize,
      0.3, 5 },
    { "marker", "Marker", "Shape of the markers; automatic gives every series its own.", &S::Marker,
      0, 0, { "automatic", "circle", "square", "diamond", "cross", "plus", "none" } },
    { "marker-size", "Marker size", "Points; 0 chooses by the number of points.", &S::MarkerSize, 0,
      100 },
    { "marker-opacity", "Marker opacity", "0 is invisible, 1 opaque.", &S::MarkerOpacity, 0, 1 },
    { "marker-edges", "Marker edges", "Whether a thin edge keeps neighbouring markers apart.",
      &S::MarkerEdges },
    { "line-width", "Line width", "Points.", &S::LineWidth, 0, 100 },
    { "dashes", "Dashes", "Of lines; automatic uses them where there are no markers to tell by.",
      &S::Dashes, 0, 0, { "automatic", "solid", "dash", "dash-dot", "dot" } },
    { "band-opacity", "Band opacity", "Of bands between two values; 0 is invisible.",
      &S::BandOpacity, 0, 1 },
    { "grid", "Grid", "Lines behind the marks.", &S::Grid, 0, 0,
      { "none", "major", "x", "y", "all" } },
    { "frame", "Frame", "Whether all four sides of the plot have a line.", &S::Frame },
    { "legend", "Legend", "Where the legend is, if the chart needs one.", &S::Legend, 0, 0,
      { "top", "bottom", "right", "none" } },
    { "color-bar", "Colour bar", "Whether colours of numbers are explained.", &S::ColorBar },
    { "width", "Width", "Of the figure in centimetres; 0 gives 10 a column.", &S::Width, 0, 500 },
    { "height", "Height", "Of the figure in centimetres; 0 is what suits the chart.", &S::Height, 0,
      500 },
    { "resolution", "Resolution", "Pixels an inch of a PNG.", &S::Resolution, 36, 2400 },
  };
}

} // namespace

std::span<const SettingField<ChartStyle>> ChartStyleFields()
{
  static const std::vector<SettingField<ChartStyle>> fields = MakeFields();
  return fields;
}

} // namespace pemesh

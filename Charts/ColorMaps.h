// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Colours that people with any colour vision can tell apart.
 *
 * References: viridis by S. van der Walt, N. Smith and E. Firing (2015, public domain, CC0);
 * cividis by J. R. Nuñez, C. R. Anderton and R. S. Renslow, PLoS ONE 13 (2018) e0199239,
 * doi:10.1371/journal.pone.0199239; the diverging map is RdBu (reversed) of C. A. Brewer,
 * https://colorbrewer2.org, Apache licence 2.0; the series are those of M. Okabe and K. Ito, Color
 * Universal Design (2008), without yellow, which is too pale on white; the palettes bright, muted
 * and vibrant are those of P. Tol, Colour Schemes, SRON/EPS/TN/09-002 (2021); ibm is that of the
 * IBM Design Language colour-blind-safe palette.
 */
#ifndef pemesh_ColorMaps_h
#define pemesh_ColorMaps_h

#include "pemeshChartsModule.h" // For export macro

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace pemesh
{

using ChartColor = std::array<unsigned char, 4>; // red, green, blue, alpha

struct ColorMap
{
  const char* Name;
  std::span<const unsigned> Anchors; // 0xRRGGBB, at equal distances
};

/** viridis, cividis, greys, and the diverging map "red-blue". */
PEMESHCHARTS_EXPORT std::span<const ColorMap> ColorMaps();
/** Null for an unknown name. */
PEMESHCHARTS_EXPORT const ColorMap* FindColorMap(std::string_view name);
/** At a place from 0 to 1; places beyond are those of the ends. */
PEMESHCHARTS_EXPORT ChartColor MapColor(const ColorMap& map, double place);

/** Colours of series and classes. */
struct ColorPalette
{
  const char* Name;
  const char* Description;
  std::span<const unsigned> Colors; // 0xRRGGBB
};

/** The first is the default. */
PEMESHCHARTS_EXPORT std::span<const ColorPalette> ColorPalettes();
/** Null for an unknown name. */
PEMESHCHARTS_EXPORT const ColorPalette* FindColorPalette(std::string_view name);

///@{
/** Colour of series or class i, any i >= 0; they repeat. The default palette has seven. */
PEMESHCHARTS_EXPORT ChartColor SeriesColor(int i);
PEMESHCHARTS_EXPORT ChartColor SeriesColor(const ColorPalette& palette, int i);
///@}

/** "#rrggbb"; black for any other text. */
PEMESHCHARTS_EXPORT ChartColor ParseColor(std::string_view text);

/** `part` of the way from one colour to another. */
PEMESHCHARTS_EXPORT ChartColor MixColors(const ChartColor& from, const ChartColor& to, double part);

/** For values that are undefined. */
inline constexpr ChartColor UndefinedColor = { 205, 205, 205, 255 };

/** Values to colours, linearly or by the logarithm. */
struct ColorScale
{
  const ColorMap* Map = nullptr;
  double Low = 0.0;
  double High = 1.0;
  bool Logarithmic = false;

  /** From 0 to 1, or NaN for what has no place: not finite, on a logarithmic scale not positive. */
  PEMESHCHARTS_EXPORT double PlaceOf(double value) const;
  /** The inverse. */
  PEMESHCHARTS_EXPORT double ValueAt(double place) const;
  /** UndefinedColor where there is no place. */
  PEMESHCHARTS_EXPORT ChartColor ColorOf(double value) const;
};

} // namespace pemesh

#endif

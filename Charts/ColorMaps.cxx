// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColorMaps.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

// Samples at equal distances of the published tables: viridis and cividis of matplotlib (CC0; J. R.
// Nunez et al., PLoS ONE 13 (2018) e0199239), RdBu of ColorBrewer (C. Brewer).
constexpr unsigned Viridis[] = { 0x440154, 0x481467, 0x482576, 0x453781, 0x404688, 0x39558C,
  0x33638D, 0x2D718E, 0x287D8E, 0x238A8D, 0x1F968B, 0x20A386, 0x29AF7F, 0x3DBC74, 0x56C667,
  0x75D054, 0x95D840, 0xBADE28, 0xDDE318, 0xFDE725 };
constexpr unsigned Cividis[] = { 0x00224E, 0x123570, 0x3B496C, 0x575D6D, 0x707173, 0x8A8678,
  0xA59C74, 0xC3B369, 0xE1CC55, 0xFEE838 };
constexpr unsigned RedBlue[] = { 0x053061, 0x2166AC, 0x4393C3, 0x92C5DE, 0xD1E5F0, 0xF7F7F7,
  0xFDDBC7, 0xF4A582, 0xD6604D, 0xB2182B, 0x67001F };
constexpr unsigned Greys[] = { 0xE6E6E6, 0x1A1A1A };
constexpr ColorMap AllMaps[] = { { "viridis", Viridis }, { "cividis", Cividis },
  { "red-blue", RedBlue }, { "greys", Greys } };

constexpr unsigned OkabeIto[] = { 0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
  0x000000 };
constexpr unsigned Bright[] = { 0x4477AA, 0xEE6677, 0x228833, 0xCCBB44, 0x66CCEE, 0xAA3377,
  0xBBBBBB };
constexpr unsigned Vibrant[] = { 0x0077BB, 0xEE7733, 0x009988, 0xEE3377, 0x33BBEE, 0xCC3311,
  0xBBBBBB };
constexpr unsigned Muted[] = { 0x332288, 0xCC6677, 0x117733, 0x88CCEE, 0x999933, 0xAA4499, 0x44AA99,
  0x882255, 0xDDCC77 };
constexpr unsigned Ibm[] = { 0x648FFF, 0xDC267F, 0xFFB000, 0x785EF0, 0xFE6100 };
constexpr unsigned GreyInks[] = { 0x000000, 0x777777, 0x444444, 0xA6A6A6 };
constexpr ColorPalette AllPalettes[] = {
  { "okabe-ito", "Seven of Okabe and Ito's colours", OkabeIto },
  { "bright", "Tol's bright scheme", Bright },
  { "vibrant", "Tol's vibrant scheme", Vibrant },
  { "muted", "Tol's muted scheme: nine soft colours", Muted },
  { "ibm", "Five colours of IBM's design language", Ibm },
  { "grey", "Black and greys, for print without colour", GreyInks },
};

ChartColor Opaque(unsigned color)
{
  return { static_cast<unsigned char>(color >> 16), static_cast<unsigned char>(color >> 8),
    static_cast<unsigned char>(color), 255 };
}

double Channel(unsigned color, int channel)
{
  return (color >> (16 - 8 * channel)) & 0xFFu;
}

} // namespace

std::span<const ColorMap> ColorMaps()
{
  return AllMaps;
}

const ColorMap* FindColorMap(std::string_view name)
{
  const auto found = std::find_if(std::begin(AllMaps), std::end(AllMaps),
    [name](const ColorMap& map) { return name == map.Name; });
  return found == std::end(AllMaps) ? nullptr : found;
}

ChartColor MapColor(const ColorMap& map, double place)
{
  const int last = static_cast<int>(map.Anchors.size()) - 1;
  const double along = std::clamp(place, 0.0, 1.0) * last;
  const int before = std::min(static_cast<int>(along), last - 1);
  const double part = along - before;
  ChartColor color = { 0, 0, 0, 255 };
  for (int channel = 0; channel < 3; ++channel)
  {
    const double value = (1.0 - part) * Channel(map.Anchors[before], channel) +
      part * Channel(map.Anchors[before + 1], channel);
    color[channel] = static_cast<unsigned char>(std::lround(value));
  }
  return color;
}

std::span<const ColorPalette> ColorPalettes()
{
  return AllPalettes;
}

const ColorPalette* FindColorPalette(std::string_view name)
{
  const auto found = std::find_if(std::begin(AllPalettes), std::end(AllPalettes),
    [name](const ColorPalette& palette) { return name == palette.Name; });
  return found == std::end(AllPalettes) ? nullptr : found;
}

ChartColor SeriesColor(int i)
{
  return SeriesColor(AllPalettes[0], i);
}

ChartColor SeriesColor(const ColorPalette& palette, int i)
{
  return Opaque(palette.Colors[static_cast<std::size_t>(i) % palette.Colors.size()]);
}

ChartColor ParseColor(std::string_view text)
{
  unsigned color = 0;
  if (text.size() == 7 && text[0] == '#')
  {
    std::from_chars(text.data() + 1, text.data() + text.size(), color, 16);
  }
  return Opaque(color);
}

ChartColor MixColors(const ChartColor& from, const ChartColor& to, double part)
{
  ChartColor mixed = from;
  for (int channel = 0; channel < 3; ++channel)
  {
    mixed[channel] =
      static_cast<unsigned char>(std::lround((1.0 - part) * from[channel] + part * to[channel]));
  }
  return mixed;
}

double ColorScale::PlaceOf(double value) const
{
  if (std::isinf(value))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (this->Logarithmic)
  {
    if (!(value > 0.0))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double span = std::log(this->High / this->Low);
    return span > 0.0 ? std::clamp(std::log(value / this->Low) / span, 0.0, 1.0) : 0.5;
  }
  const double span = this->High - this->Low;
  return span > 0.0 || std::isnan(value) ? std::clamp((value - this->Low) / span, 0.0, 1.0) : 0.5;
}

double ColorScale::ValueAt(double place) const
{
  return this->Logarithmic ? this->Low * std::pow(this->High / this->Low, place)
                           : this->Low + place * (this->High - this->Low);
}

ChartColor ColorScale::ColorOf(double value) const
{
  const double place = this->PlaceOf(value);
  return std::isnan(place) ? UndefinedColor : MapColor(*this->Map, place);
}

} // namespace pemesh

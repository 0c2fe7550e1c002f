// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColorMaps.h"

#include <algorithm>
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
constexpr ColorMap AllMaps[] = { { "viridis", Viridis }, { "cividis", Cividis },
  { "red-blue", RedBlue } };

constexpr unsigned OkabeIto[] = { 0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
  0x000000 };

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

ChartColor SeriesColor(int i)
{
  const unsigned color = OkabeIto[i % std::size(OkabeIto)];
  return { static_cast<unsigned char>(color >> 16), static_cast<unsigned char>(color >> 8),
    static_cast<unsigned char>(color), 255 };
}

double ColorScale::PlaceOf(double value) const
{
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

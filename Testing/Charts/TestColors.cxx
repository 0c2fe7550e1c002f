// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColorMaps.h"
#include "ContourBands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

/** Relative luminance of sRGB (IEC 61966-2-1). */
double Luminance(const pemesh::ChartColor& color)
{
  const auto linear = [](unsigned char channel)
  {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

double Area(const double* points, int n)
{
  double twice = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const double* a = points + 2 * i;
    const double* b = points + 2 * ((i + 1) % n);
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

TEST(ColorMaps, SequentialMapsGetLighterAllTheWay)
{
  for (const char* name : { "viridis", "cividis" })
  {
    const pemesh::ColorMap* map = pemesh::FindColorMap(name);
    ASSERT_NE(map, nullptr);
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_LT(Luminance(pemesh::MapColor(*map, i / 100.0)),
        Luminance(pemesh::MapColor(*map, (i + 1) / 100.0)) + 1e-3)
        << name << i;
    }
    EXPECT_LT(Luminance(pemesh::MapColor(*map, 0.0)), 0.05);
    EXPECT_GT(Luminance(pemesh::MapColor(*map, 1.0)), 0.7);
  }
  EXPECT_EQ(pemesh::FindColorMap("jet"), nullptr);
}

TEST(ColorMaps, DivergingMapIsLightestInTheMiddle)
{
  const pemesh::ColorMap* map = pemesh::FindColorMap("red-blue");
  const double middle = Luminance(pemesh::MapColor(*map, 0.5));
  for (const double place : { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 })
  {
    EXPECT_GT(middle, Luminance(pemesh::MapColor(*map, place)));
  }
}

TEST(ColorMaps, SeriesDifferAndShowOnWhite)
{
  std::set<pemesh::ChartColor> seen;
  for (int i = 0; i < 7; ++i)
  {
    const pemesh::ChartColor color = pemesh::SeriesColor(i);
    EXPECT_TRUE(seen.insert(color).second);
    EXPECT_GT(1.05 / (Luminance(color) + 0.05), 2.0); // contrast with white
  }
}

TEST(ColorMaps, LogarithmicScale)
{
  pemesh::ColorScale scale;
  scale.Map = pemesh::FindColorMap("viridis");
  scale.Low = 1e-4;
  scale.High = 1.0;
  scale.Logarithmic = true;
  EXPECT_NEAR(scale.PlaceOf(1e-2), 0.5, 1e-12);
  EXPECT_NEAR(scale.ValueAt(0.25), 1e-3, 1e-15);
  EXPECT_TRUE(std::isnan(scale.PlaceOf(0.0)));
  EXPECT_EQ(scale.ColorOf(-1.0), pemesh::UndefinedColor);
  EXPECT_EQ(scale.ColorOf(std::nan("")), pemesh::UndefinedColor);
}

TEST(ContourBands, PartsHaveTheAreasOfTheirValues)
{
  // On the triangle (0,0) (1,0) (0,1) with value x the part below c has area c - c^2 / 2.
  const auto below = [](double c)
  {
    c = std::clamp(c, 0.0, 1.0);
    return c - 0.5 * c * c;
  };
  const std::vector<double> levels = { 0.1, 0.2, 0.5, 0.7, 0.9 };
  pemesh::ContourBands bands(levels);
  std::vector<pemesh::PolygonBatch> parts(bands.GetNumberOfBands());
  bands.Cut({ { { { 0, 0 }, 0 }, { { 1, 0 }, 1 }, { { 0, 1 }, 0 } } }, parts);
  // The first band reaches down, the last up; each reaches under the next one.
  const double from[] = { 0.0, 0.2, 0.5, 0.7 };
  const double to[] = { 0.5, 0.7, 1.0, 1.0 };
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_EQ(parts[i].Sizes.size(), 1u) << i;
    EXPECT_NEAR(
      Area(parts[i].Points.data(), parts[i].Sizes[0]), below(to[i]) - below(from[i]), 1e-14)
      << i;
  }
}

TEST(ContourBands, AConstantTriangleIsOnePart)
{
  pemesh::ContourBands bands({ 0.0, 1.0, 2.0, 3.0 });
  for (const double value : { -5.0, 0.0, 1.0, 1.5, 2.0, 3.0, 9.0 })
  {
    std::vector<pemesh::PolygonBatch> parts(3);
    bands.Cut({ { { { 0, 0 }, value }, { { 1, 0 }, value }, { { 0, 1 }, value } } }, parts);
    double area = 0.0;
    for (const pemesh::PolygonBatch& part : parts)
    {
      area += part.Sizes.empty() ? 0.0 : Area(part.Points.data(), part.Sizes[0]);
    }
    EXPECT_DOUBLE_EQ(area, 0.5) << value;
  }
}

} // namespace

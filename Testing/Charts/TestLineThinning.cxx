// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LineCells.h"
#include "LineThinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace
{

struct Extremes
{
  float Low = 1e30f;
  float High = -1e30f;
};

std::map<double, Extremes> ExtremesOfColumns(const std::vector<float>& points, double width)
{
  std::map<double, Extremes> columns;
  for (std::size_t i = 0; i < points.size(); i += 2)
  {
    Extremes& column = columns[std::floor(points[i] / width)];
    column.Low = std::min(column.Low, points[i + 1]);
    column.High = std::max(column.High, points[i + 1]);
  }
  return columns;
}

TEST(LineThinning, KeepsWhatIsSeenOfEveryColumn)
{
  std::vector<float> points;
  for (int i = 0; i < 50000; ++i)
  {
    points.push_back(0.01f * static_cast<float>(i));
    points.push_back(100.0f * std::sin(0.37f * static_cast<float>(i)) + 0.001f * (i % 7));
  }
  std::vector<float> thin = points;
  pemesh::ThinLine(thin, 2.0);
  EXPECT_LE(thin.size() / 2, 4u * 251u);
  EXPECT_EQ(thin.front(), points.front());
  EXPECT_EQ(thin.back(), points.back());
  const auto before = ExtremesOfColumns(points, 2.0);
  const auto after = ExtremesOfColumns(thin, 2.0);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [column, extremes] : before)
  {
    EXPECT_EQ(after.at(column).Low, extremes.Low);
    EXPECT_EQ(after.at(column).High, extremes.High);
  }
  for (std::size_t i = 2; i < thin.size(); i += 2)
  {
    EXPECT_GT(thin[i], thin[i - 2]); // still in order, none twice
  }
}

TEST(LineThinning, ShortLinesStayAsTheyAre)
{
  std::vector<float> points = { 0, 0, 0.1f, 5, 0.2f, 1, 0.3f, 2 };
  const std::vector<float> before = points;
  pemesh::ThinLine(points, 10.0);
  EXPECT_EQ(points, before);
}

/** What a line covers in each column, from end to end and without gaps. */
TEST(LineThinning, DenseLinesAreStrips)
{
  std::vector<float> line;
  for (int i = 0; i < 10000; ++i)
  {
    const float x = 0.01F * static_cast<float>(i);
    line.insert(line.end(), { x, (i % 2 == 0 ? 1.0F : -1.0F) * (1.0F + std::floor(x)) });
  }
  const std::vector<float> strip = pemesh::StripOfLine(line, 1.0, 0.25);
  ASSERT_EQ(strip.size(), 400U);
  for (std::size_t column = 0; column < 100; ++column)
  {
    EXPECT_NEAR(strip[4 * column], column + 0.5, 1e-4);
    EXPECT_NEAR(strip[4 * column + 3], column + 1.25, 1.1) << "the next column may share its way";
    EXPECT_LE(strip[4 * column + 1], -(column + 1.25) + 1e-4);
    EXPECT_GE(strip[4 * column + 3], column + 1.25 - 1e-4);
  }
  EXPECT_TRUE(pemesh::StripOfLine({ line.begin(), line.begin() + 2000 }, 1.0, 0.25).empty());
  EXPECT_TRUE(pemesh::StripOfLine(line, 0.02, 0.25).empty()) << "few points a column";
  std::vector<float> back = line;
  back.insert(back.end(), line.begin(), line.end());
  EXPECT_TRUE(pemesh::StripOfLine(back, 1.0, 0.25).empty());
}

/** From end to end and back, in no order. */
std::vector<float> TangledLine(std::size_t points, float width, float height)
{
  std::vector<float> line;
  std::uint64_t state = 7;
  const auto next = [&state](float size)
  {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return size * static_cast<float>(state >> 40) / static_cast<float>(1 << 24);
  };
  for (std::size_t i = 0; i < points; ++i)
  {
    line.push_back(next(width));
    line.push_back(next(height));
  }
  return line;
}

TEST(LineCells, EverySegmentCountsHoweverFewAreMarkedOneByOne)
{
  const std::vector<float> line = TangledLine(3000, 400.0F, 300.0F);
  const std::vector<unsigned char> all = pemesh::CellsOfLine(line, 400, 300, 1e12);
  EXPECT_EQ(pemesh::CellsOfLine(line, 400, 300, 1e4), all);
  EXPECT_EQ(pemesh::CellsOfLine(line, 400, 300, 3e5), all);
}

TEST(LineCells, AreThoseThatTheLineGoesThrough)
{
  constexpr int size = 50;
  const std::vector<float> line = TangledLine(12, size, size);
  const std::vector<unsigned char> cells = pemesh::CellsOfLine(line, size, size);
  const auto isNear = [&cells](float x, float y)
  {
    for (const float dx : { -0.5F, 0.5F })
    {
      for (const float dy : { -0.5F, 0.5F })
      {
        const int column = std::clamp(static_cast<int>(std::floor(x + dx)), 0, size - 1);
        const int row = std::clamp(static_cast<int>(std::floor(y + dy)), 0, size - 1);
        if (cells[static_cast<std::size_t>(row * size + column)])
        {
          return true;
        }
      }
    }
    return false;
  };
  std::vector<unsigned char> through(cells.size(), 0);
  for (std::size_t i = 0; i + 3 < line.size(); i += 2)
  {
    for (int step = 0; step <= 5000; ++step)
    {
      const float part = static_cast<float>(step) / 5000.0F;
      const float x = line[i] + part * (line[i + 2] - line[i]);
      const float y = line[i + 1] + part * (line[i + 3] - line[i + 1]);
      ASSERT_TRUE(isNear(x, y)) << x << " " << y;
      const int column = std::min(static_cast<int>(x), size - 1);
      const int row = std::min(static_cast<int>(y), size - 1);
      through[static_cast<std::size_t>(row * size + column)] = 1;
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    EXPECT_LE(cells[i], through[i]) << "only those, " << i;
  }
}

TEST(LineCells, WhatIsFarOutOfSightCostsNothing)
{
  const std::vector<float> line{ -1e12F, 5.0F, 1e12F, 5.0F, 4.0F, 1e20F };
  const std::vector<unsigned char> cells = pemesh::CellsOfLine(line, 10, 10);
  for (int column = 0; column < 10; ++column)
  {
    EXPECT_EQ(cells[static_cast<std::size_t>(50 + column)], 1) << column;
    EXPECT_EQ(cells[static_cast<std::size_t>(20 + column)], 0) << column;
  }
}

} // namespace

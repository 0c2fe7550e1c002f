// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LineThinning.h"

#include <gtest/gtest.h>

#include <cmath>
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

} // namespace

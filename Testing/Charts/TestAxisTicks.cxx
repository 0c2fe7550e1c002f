// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AxisTicks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using testing::ElementsAre;

std::vector<std::string> Labels(const pemesh::AxisTicks& ticks)
{
  std::vector<std::string> labels;
  for (const pemesh::AxisTick& tick : ticks.Ticks)
  {
    if (!tick.Label.empty())
    {
      labels.push_back(tick.Label);
    }
  }
  return labels;
}

TEST(AxisTicks, LinearLabelsAreRoundNumbers)
{
  EXPECT_THAT(Labels(pemesh::MakeLinearTicks(-0.04, 0.94, 6)),
    ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8"));
  EXPECT_THAT(
    Labels(pemesh::MakeLinearTicks(-2.5, 2.5, 5)), ElementsAre("−2", "−1", "0", "1", "2"));
  EXPECT_THAT(Labels(pemesh::MakeLinearTicks(0, 300, 4)), ElementsAre("0", "100", "200", "300"));
}

TEST(AxisTicks, LargeAndSmallNumbersShareOnePower)
{
  const auto large = pemesh::MakeLinearTicks(0.0, 3.5e6, 4);
  EXPECT_EQ(large.Multiplier, "×10⁶");
  EXPECT_THAT(Labels(large), ElementsAre("0", "1", "2", "3"));
  const auto small = pemesh::MakeLinearTicks(-2e-5, 2e-5, 5);
  EXPECT_EQ(small.Multiplier, "×10⁻⁵");
  EXPECT_THAT(Labels(small), ElementsAre("−2", "−1", "0", "1", "2"));
}

TEST(AxisTicks, PowersOfTenWithMinorTicksBetween)
{
  const auto ticks = pemesh::MakeLogTicks(-3.2, 1.3, 8);
  EXPECT_THAT(Labels(ticks), ElementsAre("10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"));
  int minor = 0;
  for (const pemesh::AxisTick& tick : ticks.Ticks)
  {
    if (!tick.Major)
    {
      const double multiple = std::pow(10.0, tick.Position - std::floor(tick.Position));
      EXPECT_NEAR(multiple, std::round(multiple), 1e-9);
      ++minor;
    }
  }
  // 7 e-4, 8 e-4, 9 e-4; four whole decades; 20 only (10^1.3 = 19.95 is less).
  EXPECT_EQ(minor, 3 + 4 * 8);
}

TEST(AxisTicks, ManyPowersAreThinnedOut)
{
  EXPECT_THAT(Labels(pemesh::MakeLogTicks(-6.1, 0.1, 3)), ElementsAre("10⁻⁶", "10⁻³", "10⁰"));
  const auto huge = pemesh::MakeLogTicks(-300.0, 305.0, 8);
  EXPECT_LE(Labels(huge).size(), 8u);
  EXPECT_GE(Labels(huge).size(), 2u);
  EXPECT_LT(huge.Ticks.size(), 50u);
}

TEST(AxisTicks, ShortLogarithmicRangesHaveLabelsToo)
{
  EXPECT_THAT(Labels(pemesh::MakeLogTicks(std::log10(0.9), std::log10(7.0), 8)),
    ElementsAre("1", "2", "3", "5", "7"));
  EXPECT_THAT(Labels(pemesh::MakeLogTicks(std::log10(0.0225), std::log10(0.084), 5)),
    ElementsAre("0.03", "0.05", "0.07"))
    << "spread over the axis, not only at its end";
  EXPECT_GE(Labels(pemesh::MakeLogTicks(std::log10(1.02), std::log10(1.19), 8)).size(), 2u);
  EXPECT_GE(Labels(pemesh::MakeLogTicks(-7.0001, -6.9999, 8)).size(), 2u);
}

TEST(AxisTicks, NumberOfLabelsIsBounded)
{
  for (int maximum = 2; maximum <= 10; ++maximum)
  {
    for (const double span : { 1e-9, 0.3, 1.0, 7.7, 1234.5, 1e9 })
    {
      const auto ticks = pemesh::MakeLinearTicks(0.1 - span, 0.1 + span, maximum);
      EXPECT_LE(Labels(ticks).size(), static_cast<std::size_t>(maximum)) << span;
      EXPECT_GE(Labels(ticks).size(), 1u) << span;
    }
  }
}

TEST(AxisTicks, RangesAreNeverEmpty)
{
  const double nan = std::nan("");
  for (const auto& [low, high] : { std::pair{ 0.0, 0.0 }, { 3.0, 3.0 }, { -1e-310, 1e-310 },
         { 1e308, 1e308 }, { -1e308, 1e308 }, { 1.0, 1.0 + 1e-15 }, { nan, nan } })
  {
    const pemesh::AxisRange range = pemesh::PadLinearRange(low, high);
    EXPECT_LT(range.Low, range.High) << low;
    EXPECT_TRUE(std::isfinite(range.High - range.Low)) << low;
    EXPECT_GE(Labels(pemesh::MakeLinearTicks(range.Low, range.High, 6)).size(), 1u) << low;
    const pemesh::AxisRange logs = pemesh::PadLogRange(-5.0, -5.0);
    EXPECT_GE(Labels(pemesh::MakeLogTicks(logs.Low, logs.High, 6)).size(), 1u);
  }
}

TEST(AxisTicks, RangesHoldWhatIsVeryLargeOrSmall)
{
  for (const auto& [low, high] :
    { std::pair{ 1e300, 2e300 }, { -5e306, 7e307 }, { 1e-300, 2e-300 }, { -3e-302, 0.0 } })
  {
    const pemesh::AxisRange range = pemesh::PadLinearRange(low, high);
    EXPECT_LE(range.Low, low);
    EXPECT_GE(range.High, high);
    EXPECT_LT(range.High - range.Low, 1.5 * (high - low));
    EXPECT_GE(Labels(pemesh::MakeLinearTicks(range.Low, range.High, 6)).size(), 2u) << low;
  }
}

TEST(AxisTicks, NumbersForPeople)
{
  EXPECT_EQ(pemesh::ReadableNumber(0.0), "0");
  EXPECT_EQ(pemesh::ReadableNumber(0.25), "0.25");
  EXPECT_EQ(pemesh::ReadableNumber(-1234.56), "−1235");
  EXPECT_EQ(pemesh::ReadableNumber(1.5e-7), "1.5×10⁻⁷");
  EXPECT_EQ(pemesh::ReadableNumber(999999.6), "1×10⁶");
  EXPECT_EQ(pemesh::ReadableNumber(std::nan("")), "undefined");
  EXPECT_EQ(pemesh::PowerOfTen(-12), "10⁻¹²");
}

} // namespace

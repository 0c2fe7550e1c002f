// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace
{

TEST(Distribution, QuantilesAreThoseOfRAndNumPy)
{
  std::vector<double> sample(10);
  std::iota(sample.begin(), sample.end(), 1.0);
  EXPECT_DOUBLE_EQ(pemesh::SortedQuantile(sample, 0.25), 3.25); // quantile(1:10) in R
  EXPECT_DOUBLE_EQ(pemesh::SortedQuantile(sample, 0.5), 5.5);
  EXPECT_DOUBLE_EQ(pemesh::SortedQuantile(sample, 0.75), 7.75);
  EXPECT_DOUBLE_EQ(pemesh::SortedQuantile(sample, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(pemesh::SortedQuantile(sample, 1.0), 10.0);
  EXPECT_TRUE(std::isnan(pemesh::SortedQuantile({}, 0.5)));
}

TEST(Distribution, WhiskersEndAtTheLastValueWithinReach)
{
  const std::vector<double> sample = { -50, 1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 17 };
  const pemesh::BoxStatistics box = pemesh::DescribeBox(sample);
  EXPECT_DOUBLE_EQ(box.LowerQuartile, 2.75);
  EXPECT_DOUBLE_EQ(box.Median, 5.5);
  EXPECT_DOUBLE_EQ(box.UpperQuartile, 8.25);
  EXPECT_DOUBLE_EQ(box.LowerWhisker, 1.0);  // 2.75 - 1.5 * 5.5 = -5.5
  EXPECT_DOUBLE_EQ(box.UpperWhisker, 16.0); // 8.25 + 8.25 = 16.5
}

TEST(Distribution, BinsFollowFreedmanAndDiaconis)
{
  std::vector<double> sample(1000);
  std::iota(sample.begin(), sample.end(), 0.0);
  EXPECT_EQ(pemesh::ChooseBins(sample), 10); // range 999, width 2 * 499.5 / 10
  EXPECT_EQ(pemesh::ChooseBins(std::vector<double>{ 3, 3, 3 }), 1);
  EXPECT_EQ(pemesh::ChooseBins({}), 1);
  EXPECT_EQ(pemesh::ChooseBins(std::vector<double>{ 0, 1, 1, 1, 1, 1, 1, 9 }), 4); // Sturges
  for (int bin = 0; bin < 7; ++bin)
  {
    const double low = -1e308;
    const double high = 1e308;
    const double start = pemesh::BinStart(bin, low, high, 7);
    const double end = pemesh::BinStart(bin + 1, low, high, 7);
    EXPECT_TRUE(std::isfinite(end));
    EXPECT_EQ(pemesh::BinOf(0.5 * start + 0.5 * end, low, high, 7), bin);
  }
  EXPECT_EQ(pemesh::BinOf(2.0, 0.0, 2.0, 4), 3);
}

TEST(Distribution, ADensityIsASumOfBells)
{
  const std::vector<double> sample = { 0.0, 1.0, 5.0 };
  const pemesh::DensityCurve curve = pemesh::EstimateDensity(sample, 300, false);
  // Silverman: s = sqrt(7), IQR = 3 - 0.5 = 2.5.
  const double h = 0.9 * std::min(std::sqrt(7.0), 2.5 / 1.34) * std::pow(3.0, -0.2);
  EXPECT_NEAR(curve.Bandwidth, h, 1e-14);
  EXPECT_NEAR(curve.X.front(), -3.0 * h, 1e-12);
  double integral = 0.0;
  for (std::size_t i = 0; i < curve.X.size(); ++i)
  {
    double expected = 0.0;
    for (const double value : sample)
    {
      const double z = (curve.X[i] - value) / h;
      expected += std::exp(-0.5 * z * z) / (3.0 * h * std::sqrt(2.0 * std::numbers::pi));
    }
    EXPECT_NEAR(curve.Y[i], expected, 1e-14);
    integral += curve.Y[i] * (curve.X[1] - curve.X[0]);
  }
  EXPECT_NEAR(integral, 1.0, 2e-3); // less the ends of the bells
}

/** Sharing out to a grid changes little: the grid is much finer than the bells. */
TEST(Distribution, ManyValuesHaveTheDensityOfAll)
{
  std::vector<double> sample;
  for (int i = 0; i < 5000; ++i)
  {
    const double part = (i + 0.5) / 5000.0;
    sample.push_back(std::log(part / (1.0 - part))); // quantiles of the logistic distribution
  }
  const pemesh::DensityCurve curve = pemesh::EstimateDensity(sample, 60, true);
  EXPECT_EQ(curve.X.front(), sample.front());
  const double h = curve.Bandwidth;
  for (std::size_t i = 0; i < curve.X.size(); ++i)
  {
    double expected = 0.0;
    for (const double value : sample)
    {
      const double z = (curve.X[i] - value) / h;
      expected += std::exp(-0.5 * z * z) / (5000.0 * h * std::sqrt(2.0 * std::numbers::pi));
    }
    EXPECT_NEAR(curve.Y[i], expected, 2e-4);
  }
  EXPECT_TRUE(pemesh::EstimateDensity(std::vector<double>{ 2, 2, 2 }, 50, false).X.empty());
  EXPECT_TRUE(pemesh::EstimateDensity(std::vector<double>{ 2 }, 50, false).X.empty());
}

} // namespace

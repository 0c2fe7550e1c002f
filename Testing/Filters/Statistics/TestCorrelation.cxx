// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Correlation.h"

#include "BruteForce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using brute::Sample;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

double Kendall(const Sample& x, const Sample& y)
{
  return pemesh::KendallTauB(pemesh::CountKendallPairs(x, y));
}

// F. J. Anscombe, Graphs in Statistical Analysis, American Statistician 27 (1973) 17-21.
const Sample AnscombeX{ 10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5 };
const Sample AnscombeX4{ 8, 8, 8, 8, 8, 8, 8, 19, 8, 8, 8 };
const Sample AnscombeY1{ 8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68 };
const Sample AnscombeY2{ 9.14, 8.14, 8.74, 8.77, 9.26, 8.10, 6.13, 3.10, 9.13, 7.26, 4.74 };
const Sample AnscombeY3{ 7.46, 6.77, 12.74, 7.11, 7.81, 8.84, 6.08, 5.39, 8.15, 6.42, 5.73 };
const Sample AnscombeY4{ 6.58, 5.76, 7.71, 8.84, 8.47, 7.04, 5.25, 12.50, 5.56, 7.91, 6.89 };

TEST(Correlation, PearsonOfAnscombesQuartet)
{
  // The published correlation of all four is 0.816; further digits as R prints them.
  EXPECT_NEAR(pemesh::PearsonCorrelation(AnscombeX, AnscombeY1), 0.8164205, 5e-8);
  EXPECT_NEAR(pemesh::PearsonCorrelation(AnscombeX, AnscombeY2), 0.8162365, 5e-8);
  EXPECT_NEAR(pemesh::PearsonCorrelation(AnscombeX, AnscombeY3), 0.8162867, 5e-8);
  EXPECT_NEAR(pemesh::PearsonCorrelation(AnscombeX4, AnscombeY4), 0.8165214, 5e-8);
}

TEST(Correlation, SpearmanOfTextbookExample)
{
  // IQ against hours of television a week: sum of d^2 = 194, rho = 1 - 6 * 194 / 990 = -29/165.
  const Sample intelligence{ 106, 100, 86, 101, 99, 103, 97, 113, 112, 110 };
  const Sample hours{ 7, 27, 2, 50, 28, 29, 20, 12, 6, 17 };
  EXPECT_NEAR(pemesh::SpearmanCorrelation(intelligence, hours), -29.0 / 165.0, 1e-15);
}

TEST(Correlation, KendallWithTiesByHand)
{
  // Of 10 pairs 2 are tied in x, 1 in y, 1 of them in both; 2 are concordant and 6 discordant.
  const Sample x{ 12, 2, 1, 12, 2 };
  const Sample y{ 1, 4, 7, 1, 0 };
  const pemesh::KendallCounts counts = pemesh::CountKendallPairs(x, y);
  EXPECT_EQ(counts.Pairs, 10);
  EXPECT_EQ(counts.TiesX, 2);
  EXPECT_EQ(counts.TiesY, 1);
  EXPECT_EQ(counts.TiesBoth, 1);
  EXPECT_EQ(counts.Concordant(), 2);
  EXPECT_EQ(counts.Discordant, 6);
  EXPECT_NEAR(pemesh::KendallTauB(counts), -4.0 / std::sqrt(8.0 * 9.0), 1e-15);
}

TEST(Correlation, AgreesWithPairByPairDefinitions)
{
  std::mt19937_64 bits(1);
  for (int trial = 0; trial < 400; ++trial)
  {
    const std::size_t n = 2 + bits() % 40;
    const Sample x = brute::RandomSample(bits, n, 2 + bits() % 30);
    const Sample y = brute::RandomSample(bits, n, 2 + bits() % 30);
    if (pemesh::IsConstant(x) || pemesh::IsConstant(y))
    {
      continue;
    }
    ASSERT_NEAR(pemesh::PearsonCorrelation(x, y), brute::Pearson(x, y), 1e-13);
    ASSERT_NEAR(
      pemesh::SpearmanCorrelation(x, y), brute::Pearson(brute::Ranks(x), brute::Ranks(y)), 1e-13);
    ASSERT_NEAR(Kendall(x, y), brute::KendallTauB(x, y), 1e-13);
    ASSERT_EQ(pemesh::CountKendallPairs(x, y).Score(), brute::KendallScore(x, y));
  }
}

TEST(Correlation, RanksAreIntegersThatAddUpToZero)
{
  const Sample sample{ 3, 1, 3, -Infinity, 2, 3 };
  // Mid-ranks 5 2 5 1 3 5, twice less 7.
  EXPECT_EQ(pemesh::CenteredRanks(sample), (Sample{ 3, -3, 3, -5, -1, 3 }));
}

TEST(Correlation, PerfectRelationsAreExactlyOne)
{
  std::mt19937_64 bits(2);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Sample x = brute::RandomSample(bits, 3 + bits() % 60, 10);
    if (pemesh::IsConstant(x))
    {
      continue;
    }
    Sample rising;
    Sample falling;
    for (const double value : x)
    {
      rising.push_back(std::exp(value));
      falling.push_back(-value * value * value);
    }
    EXPECT_EQ(pemesh::SpearmanCorrelation(x, rising), 1.0);
    EXPECT_EQ(pemesh::SpearmanCorrelation(x, falling), -1.0);
    EXPECT_EQ(Kendall(x, rising), 1.0);
    EXPECT_EQ(Kendall(x, falling), -1.0);
    EXPECT_NEAR(pemesh::PearsonCorrelation(x, x), 1.0, 1e-15);
  }
}

TEST(Correlation, RankCoefficientsIgnoreMonotoneMaps)
{
  std::mt19937_64 bits(3);
  const Sample x = brute::RandomSample(bits, 50, 20);
  const Sample y = brute::RandomSample(bits, 50, 20);
  Sample mapped;
  for (const double value : y)
  {
    mapped.push_back(std::exp(3 * value) - 7);
  }
  EXPECT_EQ(pemesh::SpearmanCorrelation(x, y), pemesh::SpearmanCorrelation(x, mapped));
  EXPECT_EQ(Kendall(x, y), Kendall(x, mapped));
  EXPECT_GT(
    std::fabs(pemesh::PearsonCorrelation(x, y) - pemesh::PearsonCorrelation(x, mapped)), 1e-3);
}

TEST(Correlation, PearsonIgnoresUnitsAndOffsets)
{
  const double plain = pemesh::PearsonCorrelation(AnscombeX, AnscombeY1);
  for (const double unit : { 1e-300, 1e-9, 1e9, 1e300 })
  {
    Sample scaled;
    for (const double value : AnscombeY1)
    {
      scaled.push_back(unit * value);
    }
    EXPECT_NEAR(pemesh::PearsonCorrelation(AnscombeX, scaled), plain, 1e-13) << unit;
  }
  Sample moved;
  for (const double value : AnscombeX)
  {
    moved.push_back(value + 1e9);
  }
  EXPECT_NEAR(pemesh::PearsonCorrelation(moved, AnscombeY1), plain, 1e-13);
  // The two ends of what a double holds.
  EXPECT_NEAR(
    pemesh::PearsonCorrelation(Sample{ -1.7e308, 0, 1.7e308 }, Sample{ 1, 2, 3 }), 1.0, 1e-15);
}

TEST(Correlation, UndefinedIsNaN)
{
  const Sample varies{ 1, 2, 3 };
  const Sample same{ 0.1, 0.1, 0.1 };
  EXPECT_TRUE(std::isnan(pemesh::PearsonCorrelation(varies, same)));
  EXPECT_TRUE(std::isnan(pemesh::SpearmanCorrelation(same, varies)));
  EXPECT_TRUE(std::isnan(Kendall(varies, same)));
  for (const Sample& few : { Sample{}, Sample{ 1 } })
  {
    EXPECT_TRUE(std::isnan(pemesh::PearsonCorrelation(few, few)));
    EXPECT_TRUE(std::isnan(pemesh::SpearmanCorrelation(few, few)));
    EXPECT_TRUE(std::isnan(Kendall(few, few)));
  }
}

TEST(Correlation, InfinityHasARankButNoPearson)
{
  const Sample x{ 1, 2, 3, 4 };
  const Sample y{ -Infinity, 2, 5, Infinity };
  EXPECT_TRUE(std::isnan(pemesh::PearsonCorrelation(x, y)));
  EXPECT_EQ(pemesh::SpearmanCorrelation(x, y), 1.0);
  EXPECT_EQ(Kendall(x, y), 1.0);
}

TEST(Correlation, MissingValuesLeavePairwise)
{
  Sample x;
  Sample y;
  pemesh::RemoveMissing(Sample{ 1, NaN, 3, 4, 5 }, Sample{ 5, 6, NaN, 8, Infinity }, x, y);
  EXPECT_EQ(x, (Sample{ 1, 4, 5 }));
  EXPECT_EQ(y, (Sample{ 5, 8, Infinity }));
}

TEST(Correlation, ManyObservationsTakeNoQuadraticTime)
{
  constexpr std::size_t n = 100'000; // five thousand million pairs
  std::mt19937_64 bits(4);
  const Sample x = brute::RandomSample(bits, n, 1'000'000'000);
  Sample y = x;
  std::reverse(y.begin(), y.end());
  const double tau = Kendall(x, y);
  EXPECT_LT(std::fabs(tau), 0.01);
  EXPECT_EQ(Kendall(x, x), 1.0);
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FamilyTests.h"

#include "BruteForce.h"
#include "CoefficientKinds.h"
#include "KnownSamples.h"
#include "ManyTests.h"
#include "ParallelLoop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace
{

using brute::Sample;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

const pemesh::CoefficientKind& Kind(const char* name)
{
  return *pemesh::FindCoefficientKind(name);
}

TEST(RowFamilies, AreInTheOrderOfTheirFirstRow)
{
  EXPECT_EQ(pemesh::GroupRows(std::vector<std::string>{ "b", "a", "b", "" }),
    (pemesh::RowFamilies{ { 0, 2 }, { 1 }, { 3 } }));
  EXPECT_TRUE(pemesh::GroupRows({}).empty());
}

TEST(FamilyShuffle, WalksEveryArrangementOfEqualFamiliesOnce)
{
  // Three families of two rows and two of one: 3! 2! = 12; the family of three rows stays.
  const pemesh::RowFamilies families{ { 0, 1 }, { 2, 3 }, { 4 }, { 5 }, { 6, 7 }, { 8, 9, 10 } };
  pemesh::FamilyShuffle shuffle(families, 999, 1);
  EXPECT_TRUE(shuffle.IsExact());
  EXPECT_EQ(shuffle.GetCount(), 11);
  std::set<std::vector<std::size_t>> seen;
  std::vector<std::size_t> rows(12);
  while (shuffle.Next(rows))
  {
    EXPECT_TRUE(seen.insert(rows).second);
    EXPECT_EQ(rows[8], 8U);
    EXPECT_EQ(rows[11], 11U) << "a row of no family stays";
    EXPECT_EQ(rows[1], rows[0] + 1) << "rows of a family stay together";
    std::vector<std::size_t> sorted = rows;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      EXPECT_EQ(sorted[i], i);
    }
  }
  EXPECT_EQ(seen.size(), 11U);
}

TEST(FamilyShuffle, DrawsWhereThereAreTooMany)
{
  const pemesh::RowFamilies families = pemesh::SingleRows(20);
  pemesh::FamilyShuffle shuffle(families, 50, 3);
  EXPECT_FALSE(shuffle.IsExact());
  EXPECT_EQ(shuffle.GetCount(), 50);
  const pemesh::RowFamilies unequal{ { 0 }, { 1, 2 }, { 3, 4, 5 } };
  EXPECT_EQ(pemesh::FamilyShuffle(unequal, 50, 3).GetCount(), 0);
}

/** The share of all 4! orders of four blocks of Y with at least the observed coefficient. */
template <typename Coefficient>
double EnumerateBlocks(const Sample& x, const Sample& y, Coefficient coefficient)
{
  const double observed = std::fabs(coefficient(x, y));
  std::vector<std::size_t> order{ 0, 1, 2, 3 };
  double hits = 0;
  do
  {
    Sample arranged;
    for (const std::size_t block : order)
    {
      arranged.insert(arranged.end(), y.begin() + static_cast<std::ptrdiff_t>(3 * block),
        y.begin() + static_cast<std::ptrdiff_t>(3 * block + 3));
    }
    hits += std::fabs(coefficient(x, arranged)) >= observed - 1e-9 ? 1 : 0;
  } while (std::next_permutation(order.begin(), order.end()));
  return hits / 24.0;
}

TEST(FamilyPValues, AreTheShareOfAllArrangementsOfBlocks)
{
  const pemesh::RowFamilies families{ { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 }, { 9, 10, 11 } };
  std::mt19937_64 bits(4);
  const auto spearman = [](const Sample& x, const Sample& y)
  { return brute::Pearson(brute::Ranks(x), brute::Ranks(y)); };
  for (int trial = 0; trial < 20; ++trial)
  {
    const Sample x = brute::RandomSample(bits, 12, 6);
    const Sample y = brute::RandomSample(bits, 12, 1000);
    const pemesh::PairsOfColumns pairs{ { x, y }, { { 0, 1 } }, {} };
    const auto p = [&](const char* kind)
    { return pemesh::FamilyPValues(pairs, Kind(kind), families, 999, 1).front(); };
    EXPECT_DOUBLE_EQ(p("spearman"), EnumerateBlocks(x, y, spearman));
    EXPECT_DOUBLE_EQ(p("pearson"), EnumerateBlocks(x, y, brute::Pearson));
    EXPECT_DOUBLE_EQ(p("kendall"), EnumerateBlocks(x, y, brute::KendallTauB));
  }
}

TEST(FamilyPValues, WhatAllFamiliesShareIsNoEvidence)
{
  // Every family falls from 5 to 1 in X and rises in Y: rows say p = 1e-20, families say nothing.
  Sample x;
  Sample y;
  pemesh::RowFamilies families;
  for (std::size_t family = 0; family < 5; ++family)
  {
    auto& rows = families.emplace_back();
    for (int i = 0; i < 5; ++i)
    {
      rows.push_back(x.size());
      x.push_back(5 - i);
      y.push_back(i * i);
    }
  }
  EXPECT_EQ(
    pemesh::FamilyPValues({ { x, y }, { { 0, 1 } }, {} }, Kind("spearman"), families, 999, 1)[0],
    1.0);
}

TEST(FamilyPValues, MissingValuesAndConstantColumnsHaveDefinedAnswers)
{
  const pemesh::RowFamilies families = pemesh::SingleRows(6);
  const pemesh::PairsOfColumns pairs{ { { 1, 2, 3, 4, 5, 6 }, { 2, NaN, 4, 5, NaN, 9 },
                                        { 7, 7, 7, 7, 7, 7 }, { NaN, NaN, NaN, NaN, NaN, 1 } },
    { { 0, 1 }, { 0, 2 }, { 0, 3 } }, {} };
  const std::vector<double> p = pemesh::FamilyPValues(pairs, Kind("spearman"), families, 2000, 1);
  EXPECT_GT(p[0], 0.0);
  EXPECT_LE(p[0], 1.0);
  EXPECT_TRUE(std::isnan(p[1]));
  EXPECT_TRUE(std::isnan(p[2]));
}

TEST(FamilyIntervals, ComeCloseToSciPysOfTheLawSchools)
{
  // scipy.stats.bootstrap 1.10.1, percentile, 20000 resamples: Pearson [0.525, 0.948] at 90 %,
  // [0.462, 0.962] at 95 %; Spearman [0.449, 0.963] at 95 %.
  const pemesh::PairsOfColumns pairs{ { known::LawTests, known::LawGrades }, { { 0, 1 } }, {} };
  const auto interval = [&](const char* kind, double level)
  { return pemesh::FamilyIntervals(pairs, Kind(kind), pemesh::SingleRows(15), 4000, level, 1)[0]; };
  EXPECT_NEAR(interval("pearson", 0.9).Low, 0.525, 0.02);
  EXPECT_NEAR(interval("pearson", 0.9).High, 0.948, 0.01);
  EXPECT_NEAR(interval("pearson", 0.95).Low, 0.462, 0.03);
  EXPECT_NEAR(interval("pearson", 0.95).High, 0.962, 0.01);
  EXPECT_NEAR(interval("spearman", 0.95).Low, 0.449, 0.03);
  EXPECT_NEAR(interval("spearman", 0.95).High, 0.963, 0.01);
}

TEST(FamilyIntervals, RanksOfResamplesAreThoseOfTheRowsDrawn)
{
  // The quick way over the order against the plain one, with ties and missing values.
  std::mt19937_64 bits(6);
  const Sample x = brute::RandomSample(bits, 30, 7);
  Sample y = brute::RandomSample(bits, 30, 9);
  y[4] = y[17] = NaN;
  pemesh::RowFamilies families;
  for (std::size_t row = 0; row < 30; row += 3)
  {
    families.push_back({ row, row + 1, row + 2 });
  }
  const auto quick = pemesh::FamilyIntervals(
    { { x, y }, { { 0, 1 } }, {} }, Kind("spearman"), families, 200, 0.9, 5);
  std::mt19937_64 draws(5);
  Sample coefficients;
  for (int sample = 0; sample < 200; ++sample)
  {
    const std::vector<int> times = pemesh::DrawFamilies(families, 30, draws);
    Sample drawnX;
    Sample drawnY;
    for (std::size_t row = 0; row < 30; ++row)
    {
      const std::size_t count = std::isnan(y[row]) ? 0 : static_cast<std::size_t>(times[row]);
      drawnX.insert(drawnX.end(), count, x[row]);
      drawnY.insert(drawnY.end(), count, y[row]);
    }
    coefficients.push_back(brute::Pearson(brute::Ranks(drawnX), brute::Ranks(drawnY)));
  }
  std::sort(coefficients.begin(), coefficients.end());
  EXPECT_NEAR(quick[0].Low, coefficients[9] + 0.95 * (coefficients[10] - coefficients[9]), 1e-12);
}

/** All pairs at once, with values missing here and there, against one coefficient at a time. */
TEST(FamilyIntervals, OfManyPairsAreThoseOfEachAlone)
{
  std::mt19937_64 bits(9);
  pemesh::PairsOfColumns pairs;
  for (int column = 0; column < 6; ++column)
  {
    pairs.Columns.push_back(brute::RandomSample(bits, 24, 40));
    for (std::size_t other = 0; other < pairs.Columns.size() - 1; ++other)
    {
      pairs.Pairs.emplace_back(pairs.Columns.size() - 1, other);
    }
  }
  pairs.Columns[1][3] = NaN;
  pairs.Columns[4][3] = pairs.Columns[4][20] = NaN;
  const pemesh::RowFamilies families = pemesh::SingleRows(24);
  for (const std::vector<std::size_t>& given :
    { std::vector<std::size_t>{}, { 5 }, { 5, 0 }, { 5, 5 } })
  {
    pairs.Given = given;
    for (const char* kind : { "spearman", "pearson", "kendall" })
    {
      const auto quick = pemesh::FamilyIntervals(pairs, Kind(kind), families, 60, 0.9, 3);
      std::mt19937_64 draws(3);
      std::vector<Sample> values(pairs.Pairs.size());
      for (int sample = 0; sample < 60; ++sample)
      {
        const std::vector<int> times = pemesh::DrawFamilies(families, 24, draws);
        std::vector<Sample> drawn(pairs.Columns.size());
        for (std::size_t column = 0; column < drawn.size(); ++column)
        {
          for (std::size_t row = 0; row < 24; ++row)
          {
            drawn[column].insert(drawn[column].end(), static_cast<std::size_t>(times[row]),
              pairs.Columns[column][row]);
          }
        }
        std::vector<std::span<const double>> fixed;
        for (const std::size_t column : given)
        {
          fixed.emplace_back(drawn[column]);
        }
        for (std::size_t pair = 0; pair < values.size(); ++pair)
        {
          const auto [x, y] = pairs.Pairs[pair];
          const double value = pemesh::CoefficientGiven(Kind(kind), drawn[x], drawn[y], fixed);
          if (!std::isnan(value))
          {
            values[pair].push_back(value);
          }
        }
      }
      for (std::size_t pair = 0; pair < values.size(); ++pair)
      {
        if (values[pair].size() < 54)
        {
          EXPECT_TRUE(std::isnan(quick[pair].Low)) << kind << pair;
          continue;
        }
        std::sort(values[pair].begin(), values[pair].end());
        const double place = 0.05 * static_cast<double>(values[pair].size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const double low = values[pair][below] +
          (place - static_cast<double>(below)) * (values[pair][below + 1] - values[pair][below]);
        EXPECT_NEAR(quick[pair].Low, low, 1e-9) << kind << pair;
      }
    }
  }
}

TEST(FamilyIntervals, NeedFourFamilies)
{
  const pemesh::RowFamilies three{ { 0, 1, 2, 3, 4 }, { 5, 6, 7, 8, 9 }, { 10, 11, 12, 13, 14 } };
  const pemesh::PairsOfColumns pairs{ { known::LawTests, known::LawGrades }, { { 0, 1 } }, {} };
  EXPECT_TRUE(
    std::isnan(pemesh::FamilyIntervals(pairs, Kind("spearman"), three, 100, 0.9, 1)[0].Low));
}

TEST(FamilyTests, AreTheSameBitsForAnyNumberOfThreads)
{
  std::mt19937_64 bits(7);
  pemesh::PairsOfColumns pairs;
  for (int column = 0; column < 12; ++column)
  {
    pairs.Columns.push_back(brute::RandomSample(bits, 40, 30));
  }
  for (std::size_t i = 0; i < 11; ++i)
  {
    pairs.Pairs.emplace_back(i, 11);
  }
  const pemesh::RowFamilies families = pemesh::SingleRows(40);
  const auto run = [&](int threads)
  {
    pemesh::SetNumberOfThreads(threads);
    std::vector<double> all = pemesh::FamilyPValues(pairs, Kind("pearson"), families, 99, 2);
    for (const char* kind : { "kendall", "spearman" })
    {
      for (const auto& [low, high] :
        pemesh::FamilyIntervals(pairs, Kind(kind), families, 99, 0.9, 2))
      {
        all.insert(all.end(), { low, high });
      }
    }
    pemesh::SetNumberOfThreads(0);
    return all;
  };
  const std::vector<double> many = run(4); // first, because one thread is a limit that stays
  EXPECT_EQ(run(1), many);
}

TEST(FamilyTests, StopWhenTold)
{
  const pemesh::PairsOfColumns pairs{ { known::LawTests, known::LawGrades }, { { 0, 1 } }, {} };
  const auto stop = [](double) { return false; };
  EXPECT_TRUE(
    pemesh::FamilyPValues(pairs, Kind("pearson"), pemesh::SingleRows(15), 9, 1, stop).empty());
}

TEST(ManyTests, HolmByHand)
{
  // R: p.adjust(c(.01, .04, .03, .005), "holm") is .03 .06 .06 .02.
  const std::vector<double> p{ 0.01, 0.04, NaN, 0.03, 0.005 };
  const std::vector<double> holm = pemesh::HolmPValues(p);
  EXPECT_NEAR(holm[0], 0.03, 1e-15);
  EXPECT_NEAR(holm[1], 0.06, 1e-15);
  EXPECT_TRUE(std::isnan(holm[2]));
  EXPECT_NEAR(holm[3], 0.06, 1e-15);
  EXPECT_NEAR(holm[4], 0.02, 1e-15);
  EXPECT_EQ(pemesh::HolmPValues(std::vector<double>{ 0.6, 0.7 })[0], 1.0);
}

TEST(ManyTests, BenjaminisAndHochbergsExample)
{
  // Section 3.2 of the paper: of these 15, Bonferroni rejects 3 at 5 % and their method 4.
  const std::vector<double> p{ 0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
    0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000 };
  const std::vector<double> rate = pemesh::BenjaminiHochbergPValues(p);
  const std::vector<double> holm = pemesh::HolmPValues(p);
  const auto rejected = [](const std::vector<double>& all)
  { return std::count_if(all.begin(), all.end(), [](double q) { return q <= 0.05; }); };
  EXPECT_EQ(rejected(rate), 4);
  EXPECT_EQ(rejected(holm), 3);
  EXPECT_NEAR(rate[3], 0.0095 * 15 / 4, 1e-15);
  // Never below the one before in order: 15/9 * .0459 caps those above it.
  EXPECT_NEAR(rate[7], 0.0344 * 15 / 8, 1e-15);
  EXPECT_NEAR(rate[5], 0.0298 * 15 / 7, 1e-15);
}

} // namespace

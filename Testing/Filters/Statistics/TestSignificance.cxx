// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Significance.h"

#include "BruteForce.h"
#include "Correlation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

using brute::Sample;
using pemesh::PValueMethod;

/** Share of all n! orders of y whose score is at least as far from zero as that of y itself. */
template <typename Score>
double EnumeratePValue(const Sample& x, const Sample& y, Score score)
{
  std::vector<std::size_t> order(y.size());
  std::iota(order.begin(), order.end(), 0);
  const double observed = std::fabs(score(x, y));
  double hits = 0;
  double all = 0;
  do
  {
    Sample arranged;
    for (const std::size_t i : order)
    {
      arranged.push_back(y[i]);
    }
    hits += std::fabs(score(x, arranged)) >= observed - 1e-9 ? 1 : 0;
    all += 1;
  } while (std::next_permutation(order.begin(), order.end()));
  return hits / all;
}

double SpearmanScore(const Sample& x, const Sample& y)
{
  return brute::Pearson(brute::Ranks(x), brute::Ranks(y));
}

Sample Shuffled(std::mt19937_64& bits, std::size_t n)
{
  Sample sample(n);
  std::iota(sample.begin(), sample.end(), 1.0);
  for (std::size_t i = n - 1; i > 0; --i)
  {
    std::swap(sample[i], sample[bits() % (i + 1)]);
  }
  return sample;
}

TEST(Significance, ExactMatchesEnumeration)
{
  std::mt19937_64 bits(5);
  for (std::size_t n = 3; n <= 8; ++n)
  {
    for (int trial = 0; trial < (n < 8 ? 6 : 1); ++trial)
    {
      const Sample x = Shuffled(bits, n);
      const Sample y = Shuffled(bits, n);
      const pemesh::PValue kendall = pemesh::KendallPValue(x, y);
      const pemesh::PValue spearman = pemesh::SpearmanPValue(x, y);
      EXPECT_EQ(kendall.Method, PValueMethod::Exact);
      EXPECT_EQ(spearman.Method, PValueMethod::Exact);
      EXPECT_NEAR(kendall.Value, EnumeratePValue(x, y, brute::KendallScore), 1e-12);
      EXPECT_NEAR(spearman.Value, EnumeratePValue(x, y, SpearmanScore), 1e-12);
    }
  }
}

TEST(Significance, ExactWithTiesMatchesEnumeration)
{
  std::mt19937_64 bits(6);
  for (int trial = 0; trial < 12; ++trial)
  {
    const std::size_t n = 4 + bits() % 4;
    const Sample x = brute::RandomSample(bits, n, 3);
    const Sample y = brute::RandomSample(bits, n, 4);
    if (pemesh::IsConstant(x) || pemesh::IsConstant(y))
    {
      continue;
    }
    const pemesh::PValue kendall = pemesh::KendallPValue(x, y);
    EXPECT_EQ(kendall.Method, PValueMethod::Exact);
    EXPECT_NEAR(kendall.Value, EnumeratePValue(x, y, brute::KendallScore), 1e-12);
    EXPECT_NEAR(pemesh::SpearmanPValue(x, y).Value, EnumeratePValue(x, y, SpearmanScore), 1e-12);
  }
}

TEST(Significance, PerfectOrderHasTwoOrdersOfAll)
{
  double factorial = 2;
  for (std::size_t n = 3; n <= 12; ++n)
  {
    factorial *= static_cast<double>(n);
    Sample x(n);
    std::iota(x.begin(), x.end(), 0.0);
    EXPECT_NEAR(pemesh::SpearmanPValue(x, x).Value * factorial, 2.0, 1e-9) << n;
    EXPECT_NEAR(pemesh::KendallPValue(x, x).Value * factorial, 2.0, 1e-9) << n;
  }
}

TEST(Significance, CriticalValuesOfTables)
{
  // Two-sided 5 % of Spearman's rho at n = 10 is 0.648 (Zar 1972): sum of d^2 = 58 is significant,
  // 60 is not.
  const Sample x{ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 };
  const auto withSumOfSquares = [&](double wanted)
  {
    std::mt19937_64 bits(7);
    for (;;)
    {
      const Sample y = Shuffled(bits, x.size());
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        sum += (x[i] - y[i]) * (x[i] - y[i]);
      }
      if (sum == wanted)
      {
        return y;
      }
    }
  };
  EXPECT_LE(pemesh::SpearmanPValue(x, withSumOfSquares(58)).Value, 0.05);
  EXPECT_GT(pemesh::SpearmanPValue(x, withSumOfSquares(60)).Value, 0.05);
  // Kendall's score at n = 10: |S| >= 23 has 2 * 0.0233 (Kendall 1970, appendix table 1: 0.023).
  Sample y = x;
  // 11 inversions give S = 45 - 22 = 23.
  y = { 5, 1, 2, 3, 4, 10, 6, 7, 8, 9 };
  std::swap(y[1], y[2]);
  std::swap(y[3], y[4]);
  std::swap(y[6], y[7]);
  EXPECT_EQ(brute::KendallScore(x, y), 23);
  EXPECT_NEAR(pemesh::KendallPValue(x, y).Value, 2 * 0.023, 0.001);
}

TEST(Significance, PearsonOfAnscombe)
{
  // Regression of the first set: t = 4.241, 9 degrees of freedom, p = 0.00217 (as R prints them).
  const Sample x{ 10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5 };
  const Sample y{ 8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68 };
  EXPECT_NEAR(pemesh::PearsonPValue(x, y).Value, 0.00217, 5e-6);
  // With one degree of freedom Student's t is Cauchy's: p = 1 - 2 atan(t) / pi.
  const Sample three{ 1, 2, 3 };
  const Sample other{ 1, 3, 2 }; // r = 1/2, t = 1/sqrt(3): p = 2/3
  EXPECT_NEAR(pemesh::PearsonPValue(three, other).Value, 2.0 / 3.0, 1e-12);
  EXPECT_EQ(pemesh::PearsonPValue(three, three).Value, 0.0);
}

TEST(Significance, SpearmanBeyondExactUsesStudent)
{
  // Doubling the television example gives ties and n = 20; t = r sqrt(18 / (1 - r^2)).
  std::mt19937_64 bits(8);
  const Sample x = Shuffled(bits, 20);
  const Sample y = Shuffled(bits, 20);
  const pemesh::PValue p = pemesh::SpearmanPValue(x, y);
  EXPECT_EQ(p.Method, PValueMethod::Asymptotic);
  // By Simpson's rule on the density of Student's t.
  const double r = SpearmanScore(x, y);
  const double t = std::fabs(r) * std::sqrt(18 / (1 - r * r));
  const double scale = std::tgamma(9.5) / (std::sqrt(18 * std::acos(-1.0)) * std::tgamma(9.0));
  const auto density = [&](double u) { return scale * std::pow(1 + u * u / 18, -9.5); };
  constexpr int steps = 2000;
  double integral = density(0) + density(t);
  for (int i = 1; i < steps; ++i)
  {
    integral += (i % 2 == 1 ? 4 : 2) * density(t * i / steps);
  }
  integral *= t / steps / 3;
  EXPECT_NEAR(p.Value, 1 - 2 * integral, 1e-9);
}

TEST(Significance, KendallBeyondExactHasTheTrueVariance)
{
  // Kendall's variance with ties is exact: compare with that over all arrangements.
  const Sample x{ 1, 1, 1, 2, 2, 3, 3, 3, 3, 4 };
  const Sample y{ 0, 0, 1, 0, 1, 0, 2, 1, 1, 2 };
  Sample arranged = y;
  std::sort(arranged.begin(), arranged.end());
  double squares = 0;
  double all = 0;
  do
  {
    const double score = brute::KendallScore(x, arranged);
    squares += score * score;
    all += 1;
  } while (std::next_permutation(arranged.begin(), arranged.end()));
  const pemesh::PValue p = pemesh::KendallPValue(x, y);
  EXPECT_EQ(p.Method, PValueMethod::Asymptotic);
  EXPECT_NEAR(
    p.Value, std::erfc(std::fabs(brute::KendallScore(x, y)) / std::sqrt(2 * squares / all)), 1e-12);
}

TEST(Significance, IsUniformForUnrelatedSamples)
{
  // p <= 0.1 must happen in 10 % of unrelated samples, or a little less.
  std::mt19937_64 bits(9);
  int kendall = 0;
  int spearman = 0;
  constexpr int trials = 2000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const Sample x = Shuffled(bits, 30);
    const Sample y = Shuffled(bits, 30);
    kendall += pemesh::KendallPValue(x, y).Value <= 0.1 ? 1 : 0;
    spearman += pemesh::SpearmanPValue(x, y).Value <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(kendall / double(trials), 0.1, 0.02);
  EXPECT_NEAR(spearman / double(trials), 0.1, 0.02);
}

TEST(Significance, UndefinedIsNaN)
{
  const Sample two{ 1, 2 };
  const Sample same{ 1, 1, 1 };
  const Sample three{ 1, 2, 3 };
  for (const auto& [x, y] : { std::pair(two, two), std::pair(same, three), std::pair(three, same) })
  {
    EXPECT_TRUE(std::isnan(pemesh::PearsonPValue(x, y).Value));
    EXPECT_TRUE(std::isnan(pemesh::SpearmanPValue(x, y).Value));
    EXPECT_TRUE(std::isnan(pemesh::KendallPValue(x, y).Value));
    EXPECT_EQ(pemesh::KendallPValue(x, y).Method, PValueMethod::Undefined);
  }
  EXPECT_STREQ(pemesh::PValueMethodName(PValueMethod::Exact), "exact");
}

} // namespace

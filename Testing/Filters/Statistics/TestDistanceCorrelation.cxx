// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DistanceCorrelation.h"

#include "BruteForce.h"
#include "KnownSamples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using brute::Sample;

/** By the definition: products of doubly centred matrices of distances. */
double ByDefinition(const Sample& x, const Sample& y)
{
  const std::size_t n = x.size();
  const auto centred = [n](const Sample& s)
  {
    Sample a(n * n);
    Sample row(n, 0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < n * n; ++i)
    {
      a[i] = std::fabs(s[i / n] - s[i % n]);
      row[i / n] += a[i] / static_cast<double>(n);
      all += a[i] / static_cast<double>(n * n);
    }
    for (std::size_t i = 0; i < n * n; ++i)
    {
      a[i] += all - row[i / n] - row[i % n];
    }
    return a;
  };
  const Sample a = centred(x);
  const Sample b = centred(y);
  const auto dot = [](const Sample& u, const Sample& v)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i)
    {
      sum += u[i] * v[i];
    }
    return sum;
  };
  return std::sqrt(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)));
}

TEST(DistanceCorrelation, IsItsDefinitionWithAndWithoutTies)
{
  std::mt19937_64 bits(1);
  for (int trial = 0; trial < 300; ++trial)
  {
    const std::size_t n = 2 + bits() % 30;
    const std::uint64_t distinct = trial % 2 ? 4 : 1000000;
    const Sample x = brute::RandomSample(bits, n, distinct);
    Sample y = brute::RandomSample(bits, n, distinct);
    if (trial % 3 == 0)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        y[i] = y[i] * 1e-12 + 7.0 - x[i];
      }
    }
    const double expected = ByDefinition(x, y);
    const double found = pemesh::DistanceCorrelation(x, y);
    if (std::isnan(expected) || std::isnan(found))
    {
      EXPECT_TRUE(std::isnan(found)) << n;
      continue;
    }
    EXPECT_NEAR(found * found, expected * expected, 1e-11) << trial;
  }
}

TEST(DistanceCorrelation, OfKnownSamples)
{
  // By NumPy from the doubly centred matrices.
  EXPECT_NEAR(
    pemesh::DistanceCorrelation(known::LawTests, known::LawGrades), 0.758892412202443, 1e-12);
  EXPECT_NEAR(
    pemesh::DistanceCorrelation(known::CarMiles, known::CarWeights), 0.871021610036535, 1e-12);
  const Sample x{ -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5 };
  const Sample parabola{ 25, 16, 9, 4, 1, 0, 1, 4, 9, 16, 25 };
  EXPECT_NEAR(pemesh::DistanceCorrelation(x, parabola), 0.4975090846304604, 1e-12);
}

TEST(DistanceCorrelation, OfNormalSamplesIsThatOfTheDistribution)
{
  // Theorem 7 of Székely, Rizzo and Bakirov (2007), for standard normal samples with correlation r.
  constexpr double r = 0.6;
  const double pi = std::acos(-1.0);
  const double squared =
    (r * std::asin(r) + std::sqrt(1 - r * r) - r * std::asin(r / 2) - std::sqrt(4 - r * r) + 1) /
    (1 + pi / 3 - std::sqrt(3.0));
  std::mt19937_64 bits(2);
  const auto uniform = [&] { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; };
  Sample x;
  Sample y;
  for (int i = 0; i < 40000; ++i)
  {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    const double angle = 2 * pi * uniform();
    x.push_back(radius * std::cos(angle));
    y.push_back(r * x.back() + std::sqrt(1 - r * r) * radius * std::sin(angle));
  }
  EXPECT_NEAR(pemesh::DistanceCorrelation(x, y), std::sqrt(squared), 0.01);
}

TEST(DistanceCorrelation, IsOneOnALineAndUndefinedOnAPoint)
{
  const Sample x{ 1e300, -1e300, 3e299, 0 };
  const Sample line{ -1e-300, 1e-300, -3e-301, 0 };
  EXPECT_NEAR(pemesh::DistanceCorrelation(x, line), 1.0, 1e-12);
  const Sample same(4, 2.0);
  EXPECT_TRUE(std::isnan(pemesh::DistanceCorrelation(x, same)));
  EXPECT_TRUE(std::isnan(pemesh::DistanceCorrelation(Sample{ 1 }, Sample{ 2 })));
  EXPECT_TRUE(std::isnan(pemesh::DistanceCorrelation(Sample{}, Sample{})));
  const Sample infinite{ 1, 2, 3, std::numeric_limits<double>::infinity() };
  EXPECT_TRUE(std::isnan(pemesh::DistanceCorrelation(x, infinite)));
}

} // namespace

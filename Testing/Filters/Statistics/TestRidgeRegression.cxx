// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RidgeRegression.h"

#include "BruteForce.h"
#include "CoefficientKinds.h"
#include "Correlation.h"
#include "KnownSamples.h"
#include "PartialCorrelation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{

using brute::Sample;
using known::CarMiles;
using known::CarPowers;
using known::CarWeights;
using testing::HasSubstr;

/** Solves a small system by elimination with pivots: no library the code under test uses. */
Sample Solve(std::vector<Sample> a, Sample b)
{
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
    {
      pivot = std::fabs(a[i][k]) > std::fabs(a[pivot][k]) ? i : pivot;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i)
    {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j)
      {
        a[i][j] -= factor * a[k][j];
      }
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;)
  {
    for (std::size_t j = k + 1; j < n; ++j)
    {
      b[k] -= a[k][j] * b[j];
    }
    b[k] /= a[k][k];
  }
  return b;
}

Sample Standardised(Sample sample)
{
  double mean = 0.0;
  for (const double value : sample)
  {
    mean += value / static_cast<double>(sample.size());
  }
  double variance = 0.0;
  for (double& value : sample)
  {
    value -= mean;
    variance += value * value / static_cast<double>(sample.size());
  }
  for (double& value : sample)
  {
    value /= std::sqrt(variance);
  }
  return sample;
}

/** Constant and weights of ridge regression on some rows, by the normal equations. */
Sample FitRows(const std::vector<Sample>& x, const Sample& y, const std::vector<std::size_t>& rows,
  double penalty)
{
  const std::size_t p = x.size() + 1;
  std::vector<Sample> matrix(p, Sample(p, 0.0));
  Sample right(p, 0.0);
  for (const std::size_t row : rows)
  {
    Sample line{ 1.0 };
    for (const Sample& column : x)
    {
      line.push_back(column[row]);
    }
    for (std::size_t i = 0; i < p; ++i)
    {
      for (std::size_t j = 0; j < p; ++j)
      {
        matrix[i][j] += line[i] * line[j];
      }
      right[i] += line[i] * y[row];
    }
  }
  for (std::size_t i = 1; i < p; ++i)
  {
    matrix[i][i] += penalty;
  }
  return Solve(matrix, right);
}

struct Problem
{
  std::vector<Sample> X{ 3 };
  Sample Y;
  pemesh::RowFamilies Families;

  Problem()
  {
    std::mt19937_64 bits(11);
    for (std::size_t row = 0; row < 30; ++row)
    {
      for (Sample& column : this->X)
      {
        column.push_back(static_cast<double>(bits() % 1000));
      }
      this->Y.push_back(3 * this->X[0][row] - this->X[1][row] + static_cast<double>(bits() % 900));
      if (row % 5 == 0)
      {
        this->Families.emplace_back();
      }
      this->Families.back().push_back(row);
    }
  }
};

TEST(RidgeRegression, PenaltyAndShareAreThoseOfRefittingWithoutEachFamily)
{
  const Problem problem;
  const pemesh::RidgeModel model = pemesh::FitRidge(problem.X, problem.Y, problem.Families);
  ASSERT_EQ(model.Refusal, "");
  std::vector<Sample> x;
  for (const Sample& column : problem.X)
  {
    x.push_back(Standardised(column));
  }
  const Sample y = Standardised(problem.Y);
  const auto leftOutError = [&](double penalty, bool meanOnly)
  {
    double error = 0.0;
    for (std::size_t family = 0; family < problem.Families.size(); ++family)
    {
      std::vector<std::size_t> others;
      for (std::size_t row = 0; row < y.size(); ++row)
      {
        if (row / 5 != family)
        {
          others.push_back(row);
        }
      }
      const Sample weights = FitRows(meanOnly ? std::vector<Sample>() : x, y, others, penalty);
      for (const std::size_t row : problem.Families[family])
      {
        double predicted = weights[0];
        for (std::size_t i = 1; i < weights.size(); ++i)
        {
          predicted += weights[i] * x[i - 1][row];
        }
        error += (y[row] - predicted) * (y[row] - predicted);
      }
    }
    return error;
  };
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 12; step >= -32; --step)
  {
    const double penalty = std::pow(10.0, step / 4.0);
    const double error = leftOutError(30 * penalty, false);
    best = error < least ? penalty : best;
    least = std::min(least, error);
  }
  EXPECT_DOUBLE_EQ(model.Penalty, best);
  EXPECT_NEAR(model.PredictedShare, 1 - least / leftOutError(0.0, true), 1e-10);
  std::vector<std::size_t> all(30);
  for (std::size_t i = 0; i < 30; ++i)
  {
    all[i] = i;
  }
  const Sample weights = FitRows(x, y, all, 30 * model.Penalty);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(model.Weights[i], weights[i + 1], 1e-10);
  }
}

TEST(RidgeRegression, TwinsShareTheWeight)
{
  Problem problem;
  problem.X[1] = problem.X[0];
  const pemesh::RidgeModel model = pemesh::FitRidge(problem.X, problem.Y, problem.Families);
  EXPECT_NEAR(model.Weights[0], model.Weights[1], 1e-9);
  EXPECT_GT(model.Weights[0], 0.2);
}

TEST(RidgeRegression, IsRefusedInASentence)
{
  const Problem problem;
  const auto refusal = [](const std::vector<Sample>& x, const Sample& y, const auto& families)
  { return pemesh::FitRidge(x, y, families).Refusal; };
  EXPECT_THAT(refusal(std::vector<Sample>(11, problem.X[0]), problem.Y, problem.Families),
    HasSubstr("30 rows are too few for 11 predictors"));
  EXPECT_EQ(refusal(std::vector<Sample>(10, problem.X[0]), problem.Y, problem.Families), "");
  EXPECT_THAT(refusal(problem.X, problem.Y, pemesh::RowFamilies{ { 0, 1 } }), HasSubstr("family"));
  EXPECT_THAT(refusal({}, problem.Y, problem.Families), HasSubstr("No predictor"));
  EXPECT_THAT(refusal(problem.X, Sample(30, 1.0), problem.Families), HasSubstr("one value"));
}

TEST(PartialCorrelation, OfCarsIsThatOfR)
{
  // R's ppcor: pcor.test(mpg, wt, hp) is -0.7512; by NumPy from the inverse correlation matrix
  // -0.7512049049618656, of ranks -0.6844151608419109.
  EXPECT_NEAR(
    pemesh::PartialCorrelation(CarMiles, CarWeights, { CarPowers }), -0.7512049049618656, 1e-12);
  const auto& spearman = *pemesh::FindCoefficientKind("spearman");
  EXPECT_NEAR(pemesh::CoefficientGiven(spearman, CarMiles, CarWeights, { CarPowers }),
    -0.6844151608419109, 1e-12);
  EXPECT_NEAR(pemesh::PartialCorrelation(CarMiles, CarWeights, {}),
    brute::Pearson(CarMiles, CarWeights), 1e-12);
  // Named twice, it is held fixed once.
  EXPECT_NEAR(pemesh::PartialCorrelation(CarMiles, CarWeights, { CarPowers, CarPowers }),
    -0.7512049049618656, 1e-12);
}

double Tau(const std::vector<double>& x, const std::vector<double>& y)
{
  return pemesh::KendallTauB(pemesh::CountKendallPairs(x, y));
}

/** Kendall's formula, and for two given samples its recursion. */
TEST(PartialKendall, IsThatOfKendallsFormula)
{
  const auto given = [](double xy, double xz, double yz)
  { return (xy - xz * yz) / std::sqrt((1 - xz * xz) * (1 - yz * yz)); };
  const double plain = Tau(CarMiles, CarWeights);
  const double one = given(plain, Tau(CarMiles, CarPowers), Tau(CarWeights, CarPowers));
  EXPECT_NEAR(pemesh::PartialKendall(CarMiles, CarWeights, { CarPowers }), one, 1e-12);
  EXPECT_NEAR(pemesh::PartialKendall(CarMiles, CarWeights, { CarPowers, CarPowers }), one, 1e-12);
  EXPECT_NEAR(pemesh::PartialKendall(CarMiles, CarWeights, {}), plain, 1e-12);
  std::vector<double> noise;
  std::mt19937_64 bits(4);
  for (std::size_t i = 0; i < CarMiles.size(); ++i)
  {
    noise.push_back(static_cast<double>(bits() % 1000));
  }
  const double milesNoise =
    given(Tau(CarMiles, noise), Tau(CarMiles, CarPowers), Tau(noise, CarPowers));
  const double weightsNoise =
    given(Tau(CarWeights, noise), Tau(CarWeights, CarPowers), Tau(noise, CarPowers));
  EXPECT_NEAR(pemesh::PartialKendall(CarMiles, CarWeights, { CarPowers, noise }),
    given(one, milesNoise, weightsNoise), 1e-12);
  EXPECT_TRUE(std::isnan(pemesh::PartialKendall(CarMiles, CarWeights, { CarMiles })));
}

/** U-centred distances by their definition, each a whole matrix. */
std::vector<double> CentredDistances(const std::vector<double>& x)
{
  const std::size_t n = x.size();
  const auto size = static_cast<double>(n);
  std::vector<double> sums(n, 0.0);
  double total = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      sums[i] += std::fabs(x[i] - x[j]);
    }
    total += sums[i];
  }
  std::vector<double> centred;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      centred.push_back(i == j ? 0.0
                               : std::fabs(x[i] - x[j]) - sums[i] / (size - 2) -
            sums[j] / (size - 2) + total / ((size - 1) * (size - 2)));
    }
  }
  return centred;
}

double Product(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

TEST(PartialDistanceCorrelation, IsThatOfTheDefinition)
{
  const auto a = CentredDistances(CarMiles);
  const auto b = CentredDistances(CarWeights);
  const auto c = CentredDistances(CarPowers);
  const auto cosine = [](const auto& u, const auto& v)
  { return Product(u, v) / std::sqrt(Product(u, u) * Product(v, v)); };
  const double ab = cosine(a, b);
  const double ac = cosine(a, c);
  const double bc = cosine(b, c);
  const double squared = (ab - ac * bc) / std::sqrt((1 - ac * ac) * (1 - bc * bc));
  ASSERT_GT(squared, 0.0);
  EXPECT_NEAR(pemesh::PartialDistanceCorrelation(CarMiles, CarWeights, { CarPowers }),
    std::sqrt(squared), 1e-9);
  // What depends on the given sample alone has nothing left in common.
  EXPECT_TRUE(std::isnan(pemesh::PartialDistanceCorrelation(CarMiles, CarWeights, { CarMiles })));
}

TEST(PartialCorrelation, IsUndefinedWhereNothingIsLeft)
{
  const Sample x{ 1, 2, 3, 4, 5 };
  const Sample y{ 2, 1, 4, 3, 5 };
  const Sample twice{ 2, 4, 6, 8, 10 };
  EXPECT_TRUE(std::isnan(pemesh::PartialCorrelation(x, y, { twice })));
  EXPECT_TRUE(std::isnan(pemesh::PartialCorrelation(x, y, { y, twice, { 1, 0, 0, 1, 0 } })));
  const Sample infinite{ 1, 2, 3, 4, std::numeric_limits<double>::infinity() };
  EXPECT_TRUE(std::isnan(pemesh::PartialCorrelation(x, y, { infinite })));
}

} // namespace

TEST(PartialCorrelation, OfNoRowLeavesNothing)
{
  EXPECT_TRUE(pemesh::RegressionResiduals({}, { {}, {} }).empty());
}

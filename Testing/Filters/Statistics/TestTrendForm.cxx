// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TrendForm.h"

#include "BruteForce.h"
#include "RelationWords.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace
{

using brute::Sample;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename Function>
Sample Map(const Sample& x, Function function)
{
  Sample y;
  for (const double value : x)
  {
    y.push_back(function(value));
  }
  return y;
}

const Sample Grid{ 0.1, 0.2, 0.35, 0.5, 0.7, 0.8, 1.1, 1.7, 2.5, 4.0 };

TEST(TrendForm, FindsTheFormItWasMadeOf)
{
  const auto power =
    pemesh::FindTrendForm(Grid, Map(Grid, [](double x) { return 3e5 * std::pow(x, -1.9); }));
  EXPECT_EQ(power.Name, "power-law");
  EXPECT_NEAR(power.Parameter, -1.9, 1e-12);
  EXPECT_NEAR(power.Fit, 1.0, 1e-12);
  const auto line = pemesh::FindTrendForm(Grid, Map(Grid, [](double x) { return 7 - 2 * x; }));
  EXPECT_EQ(line.Name, "linear");
  EXPECT_NEAR(line.Parameter, -2.0, 1e-12);
  const auto exponential =
    pemesh::FindTrendForm(Grid, Map(Grid, [](double x) { return 1e-9 * std::exp(2.5 * x); }));
  EXPECT_EQ(exponential.Name, "exponential");
  EXPECT_NEAR(exponential.Parameter, 2.5, 1e-12);
}

TEST(TrendForm, SurvivesNoiseOfTheKindItIsMeantFor)
{
  std::mt19937_64 bits(3);
  const auto noise = [&] { return static_cast<double>(bits() % 1001) / 500.0 - 1.0; };
  int right = 0;
  for (int trial = 0; trial < 50; ++trial)
  {
    const Sample y =
      Map(Grid, [&](double x) { return std::pow(x, -1.9) * std::exp(0.2 * noise()); });
    const auto form = pemesh::FindTrendForm(Grid, y);
    right += form.Name == "power-law" && std::fabs(form.Parameter + 1.9) < 0.2;
  }
  EXPECT_GE(right, 48);
}

/** R^2 of a straight line of the samples, and its sum of squared residuals. */
std::pair<double, double> FitLine(const Sample& u, const Sample& v)
{
  const double r = brute::Pearson(u, v);
  double mean = 0.0;
  for (const double value : v)
  {
    mean += value / static_cast<double>(v.size());
  }
  double squares = 0.0;
  for (const double value : v)
  {
    squares += (value - mean) * (value - mean);
  }
  return { r * r, squares * (1 - r * r) };
}

TEST(TrendForm, IsTheOneOfTheLargestLikelihood)
{
  // Box and Cox: -n/2 log RSS of y, and of log y less the sum of log y, its Jacobian.
  std::mt19937_64 bits(12);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto logarithm = [](double value) { return std::log(value); };
  std::map<std::string, int> found;
  for (int trial = 0; trial < 300; ++trial)
  {
    Sample x;
    Sample y;
    const double curvature = 3 * uniform();
    const double noise = 0.3 * uniform();
    for (int i = 0; i < 15; ++i)
    {
      x.push_back(1 + 0.2 * i);
      const double grown = trial % 3 == 0 ? 1 + curvature * 0.2 * i
        : trial % 3 == 1                  ? std::pow(x.back(), curvature)
                                          : std::exp(curvature * 0.2 * i);
      y.push_back(1e4 * grown * (1 + noise * (uniform() - 0.5)));
    }
    const Sample logX = Map(x, logarithm);
    const Sample logY = Map(y, logarithm);
    double jacobian = 0.0;
    for (const double value : logY)
    {
      jacobian += value;
    }
    std::string best = "none";
    double largest = -Infinity;
    const auto consider = [&](const char* name, const Sample& u, const Sample& v, double shift)
    {
      const auto [fit, rest] = FitLine(u, v);
      const double likelihood = -7.5 * std::log(rest) - shift;
      if (fit >= 0.9 && likelihood > largest)
      {
        largest = likelihood;
        best = name;
      }
    };
    consider("linear", x, y, 0.0);
    consider("power-law", logX, logY, jacobian);
    consider("exponential", x, logY, jacobian);
    const std::string name = pemesh::FindTrendForm(x, y).Name;
    ++found[name];
    if (best != "none")
    {
      EXPECT_EQ(name, best) << trial;
    }
  }
  for (const char* name : { "linear", "power-law", "exponential" })
  {
    EXPECT_GT(found[name], 10) << name;
  }
}

TEST(TrendForm, NegativeValuesHaveNoLogarithm)
{
  const Sample x{ -3, -2, -1, 0, 1, 2 };
  EXPECT_EQ(pemesh::FindTrendForm(x, Map(x, [](double v) { return v; })).Name, "linear");
  const auto cubes = pemesh::FindTrendForm(x, Map(x, [](double v) { return std::pow(v, 11); }));
  EXPECT_EQ(cubes.Name, "monotone");
  EXPECT_TRUE(std::isnan(cubes.Parameter));
  EXPECT_EQ(pemesh::FindTrendForm(x, Sample{ 1, 9, 2, 8, 3, 7 }).Name, "none");
}

TEST(TrendForm, ExtremeValuesNeitherOverflowNorVanish)
{
  const auto huge = pemesh::FindTrendForm(Grid, Map(Grid, [](double x) { return 4e307 * x; }));
  EXPECT_EQ(huge.Name, "linear");
  EXPECT_NEAR(huge.Parameter / 4e307, 1.0, 1e-12);
  const auto tiny = pemesh::FindTrendForm(Grid, Map(Grid, [](double x) { return 1e-300 * x * x; }));
  EXPECT_EQ(tiny.Name, "power-law");
  EXPECT_NEAR(tiny.Parameter, 2.0, 1e-12);
}

TEST(TrendForm, UndefinedWhereThereIsNothingToSee)
{
  EXPECT_EQ(pemesh::FindTrendForm(Sample{ 1, 2 }, Sample{ 1, 2 }).Name, "undefined");
  EXPECT_EQ(pemesh::FindTrendForm(Sample{ 1, 1, 1 }, Sample{ 1, 2, 3 }).Name, "undefined");
  EXPECT_EQ(pemesh::FindTrendForm(Sample{ 1, 2, Infinity }, Sample{ 1, 2, 3 }).Name, "undefined");
  EXPECT_EQ(pemesh::FindTrendForm(Sample{}, Sample{}).Name, "undefined");
}

TEST(RelationWords, AreThoseOfTheSeed)
{
  EXPECT_EQ(pemesh::RelationWords(-0.98, -0.98, { "power-law", -1.9034, 0.97 }),
    "strong negative, close to a power law with exponent -1.9");
  EXPECT_EQ(pemesh::RelationWords(0.7, 0.7, { "linear", 1234.5, 0.999 }),
    "strong positive, a straight line with slope 1200");
  EXPECT_EQ(pemesh::RelationWords(-0.7, -0.7, { "monotone", NaN, NaN }),
    "strong negative, monotone but of no simple form");
  EXPECT_EQ(pemesh::RelationWords(0.4, 0.4, { "none", NaN, NaN }), "moderate positive");
  EXPECT_EQ(pemesh::RelationWords(0.399, 0.399, { "none", NaN, NaN }), "weak positive");
  EXPECT_EQ(pemesh::RelationWords(0.0, 0.0, { "none", NaN, NaN }), "weak, of no direction");
  EXPECT_EQ(pemesh::RelationWords(NaN, NaN, {}), "undefined");
}

TEST(RelationWords, NumbersHaveTwoDigits)
{
  EXPECT_EQ(pemesh::RoundedNumber(-1.8999), "-1.9");
  EXPECT_EQ(pemesh::RoundedNumber(0.0995), "0.1");
  EXPECT_EQ(pemesh::RoundedNumber(0.000316), "0.00032");
  EXPECT_EQ(pemesh::RoundedNumber(99.6), "100");
  EXPECT_EQ(pemesh::RoundedNumber(0.0), "0");
  EXPECT_EQ(pemesh::RoundedNumber(-Infinity), "-inf");
  EXPECT_EQ(pemesh::RoundedNumber(1.0), "1");
}

} // namespace

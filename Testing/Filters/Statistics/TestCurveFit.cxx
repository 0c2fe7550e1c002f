// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace
{

using pemesh::CurveForm;
using pemesh::FitCurve;

/** The data set Norris of NIST's statistical reference data sets, with its certified values. */
TEST(CurveFit, NistNorris)
{
  const std::vector<double> y = { 0.1, 338.8, 118.1, 888.0, 9.2, 228.1, 668.5, 998.5, 449.1, 778.9,
    559.2, 0.3, 0.1, 778.1, 668.8, 339.3, 448.9, 10.8, 557.7, 228.3, 998.0, 888.8, 119.6, 0.3, 0.6,
    557.6, 339.3, 888.0, 998.5, 778.9, 10.2, 117.6, 228.9, 668.4, 449.2, 0.2 };
  const std::vector<double> x = { 0.2, 337.4, 118.2, 884.6, 10.1, 226.5, 666.3, 996.3, 448.6, 777.0,
    558.2, 0.4, 0.6, 775.5, 666.9, 338.0, 447.5, 11.6, 556.0, 228.1, 995.8, 887.6, 120.2, 0.3, 0.3,
    556.8, 339.1, 887.2, 999.0, 779.0, 11.1, 118.3, 229.2, 669.1, 448.9, 0.5 };
  const auto fit = FitCurve(CurveForm::Linear, x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->A, -0.262323073774029, 1e-11);
  EXPECT_NEAR(fit->B, 1.00211681802045, 1e-13);
  EXPECT_NEAR(fit->Deviation, 0.884796396144373, 1e-11);
  EXPECT_NEAR(fit->RSquared, 0.999993745883712, 1e-12);
  EXPECT_NEAR(fit->StandardErrorOfB(), 0.429796848199937e-03, 1e-14);
}

TEST(CurveFit, ExtremeUnitsChangeNothing)
{
  const std::vector<double> x = { 1e-180, 2e-180, 4e-180 };
  const std::vector<double> y = { 2e200, 3e200, 7e200 }; // of 1, 2, 4 and 2, 3, 7: 12 / 7
  const auto fit = FitCurve(CurveForm::Linear, x, y);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(std::isinf(fit->B)); // 1.7e380 is no number
  const std::vector<double> large = { 1e300, 2e300, 4e300 };
  const auto scaled = FitCurve(CurveForm::Linear, large, y);
  ASSERT_TRUE(scaled);
  EXPECT_NEAR(scaled->B, 12.0 / 7.0 * 1e-100, 1e-112);
  const auto plain =
    FitCurve(CurveForm::Linear, std::vector<double>{ 1, 2, 4 }, std::vector<double>{ 2, 3, 7 });
  EXPECT_NEAR(scaled->BandAt(3e300, 0.9).Upper / plain->BandAt(3, 0.9).Upper, 1e200, 1e187);
}

/** Rounding alone does not choose among forms that all go through the points: the simplest. */
TEST(CurveFit, OfExactFormsTheSimplestIsTaken)
{
  for (const double slope : { 0.1, 1.0 / 3.0, 7e-9, 12345.678 })
  {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 1; i < 30; ++i)
    {
      x.push_back(0.37 * i);
      y.push_back(slope * x.back());
    }
    EXPECT_EQ(pemesh::FitBestCurve(x, y)->Form, CurveForm::Linear) << slope;
  }
}

TEST(CurveFit, PowersAndExponentialsAreFoundAgain)
{
  std::vector<double> x;
  std::vector<double> power;
  std::vector<double> exponential;
  for (int i = 1; i <= 12; ++i)
  {
    x.push_back(0.3 * i);
    power.push_back(2.5 * std::pow(x.back(), -1.9));
    exponential.push_back(0.7 * std::exp(1.2 * x.back()));
  }
  const auto first = pemesh::FitBestCurve(x, power);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->Form, CurveForm::Power);
  EXPECT_NEAR(first->A, 2.5, 1e-12);
  EXPECT_NEAR(first->B, -1.9, 1e-12);
  EXPECT_NEAR(first->ValueAt(0.9), 2.5 * std::pow(0.9, -1.9), 1e-12);
  const auto second = pemesh::FitBestCurve(x, exponential);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->Form, CurveForm::Exponential);
  EXPECT_NEAR(second->A, 0.7, 1e-12);
  EXPECT_NEAR(second->B, 1.2, 1e-12);
  const auto third = pemesh::FitBestCurve(x, x);
  ASSERT_TRUE(third);
  EXPECT_NEAR(third->ValueAt(5.0), 5.0, 1e-9); // a line is a power too
}

/** Other units of y, or of x, must not change which form is the best. */
TEST(CurveFit, TheBestFormDoesNotDependOnUnits)
{
  const std::vector<double> x = { 1, 2, 3, 4, 5, 6, 7 };
  const std::vector<double> y = { 2.1, 3.8, 6.3, 7.7, 10.4, 11.9, 14.2 };
  const auto form = pemesh::FitBestCurve(x, y)->Form;
  for (const double scale : { 1e-6, 1e6 })
  {
    std::vector<double> scaled = y;
    for (double& value : scaled)
    {
      value *= scale;
    }
    EXPECT_EQ(pemesh::FitBestCurve(x, scaled)->Form, form);
  }
}

/** With three points there is one degree of freedom, and Student's t has a closed form. */
TEST(CurveFit, TheBandIsThatOfTheMean)
{
  const std::vector<double> x = { 0, 1, 2 };
  const std::vector<double> y = { 0, 1, 1 };
  const auto fit = FitCurve(CurveForm::Linear, x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->B, 0.5, 1e-15);
  EXPECT_NEAR(fit->A, 1.0 / 6.0, 1e-15);
  const double t = std::tan(0.475 * std::numbers::pi);
  for (const double at : { 1.0, 3.0 })
  {
    const double half = t * std::sqrt(1.0 / 6.0) * std::sqrt(1.0 / 3.0 + (at - 1) * (at - 1) / 2.0);
    const auto band = fit->BandAt(at, 0.95);
    EXPECT_NEAR(band.Upper - band.Lower, 2.0 * half, 1e-9);
    EXPECT_NEAR(0.5 * (band.Upper + band.Lower), fit->ValueAt(at), 1e-12);
  }
  // Between logarithms the band is that of the straight line there.
  const std::vector<double> powers = { 1.0, std::exp(1.0), std::exp(1.0) };
  const auto exponential = FitCurve(CurveForm::Exponential, x, powers);
  ASSERT_TRUE(exponential);
  EXPECT_NEAR(std::log(exponential->BandAt(3.0, 0.95).Upper), fit->BandAt(3.0, 0.95).Upper, 1e-12);
}

TEST(CurveFit, WhatHasNoPlaceIsLeftOut)
{
  const double nan = std::nan("");
  const std::vector<double> x = { 1, 2, -3, 4, nan, 8 };
  const std::vector<double> y = { 1, 4, 9, 16, 25, HUGE_VAL };
  const auto fit = FitCurve(CurveForm::Power, x, y);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->Points, 3);
  EXPECT_EQ(fit->LeftOut, 3);
  EXPECT_NEAR(fit->B, 2.0, 1e-12);
  EXPECT_EQ(pemesh::FitBestCurve(x, y)->Points, 4); // not by the form that leaves out more
  EXPECT_FALSE(
    FitCurve(CurveForm::Linear, std::vector<double>{ 2, 2 }, std::vector<double>{ 1, 3 }));
  EXPECT_FALSE(FitCurve(CurveForm::Linear, std::vector<double>{ 2 }, std::vector<double>{ 1 }));
  EXPECT_FALSE(
    FitCurve(CurveForm::Power, std::vector<double>{ 1, 2 }, std::vector<double>{ -1, -3 }));
  const auto two =
    FitCurve(CurveForm::Linear, std::vector<double>{ 0, 2 }, std::vector<double>{ 1, 3 });
  ASSERT_TRUE(two);
  EXPECT_TRUE(std::isnan(two->BandAt(1.0, 0.95).Lower));
}

} // namespace

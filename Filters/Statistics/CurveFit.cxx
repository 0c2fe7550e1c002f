// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveFit.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<FormKind, 3> Kinds{ {
  { CurveForm::Linear, "linear", "a straight line", "slope", false, false },
  { CurveForm::Power, "power-law", "a power law", "exponent", true, true },
  { CurveForm::Exponential, "exponential", "an exponential", "rate", false, true },
} };

double Straight(double value, bool logarithmic)
{
  return !logarithmic ? value : value > 0.0 ? std::log(value) : Undefined;
}

/** Values where the curve is a straight line, in units so that no square overflows or vanishes. */
struct StraightValues
{
  std::vector<double> Values;
  double Unit = 1.0;
  double Largest = 0.0; // size of a value, in units

  void Finish(bool logarithmic)
  {
    for (const double value : this->Values)
    {
      this->Largest = std::max(this->Largest, std::fabs(value));
    }
    if (!logarithmic && this->Largest > 0.0)
    {
      this->Unit = this->Largest;
      this->Largest = 1.0;
      for (double& value : this->Values)
      {
        value /= this->Unit;
      }
    }
  }
};

struct StraightPoints
{
  StraightValues X;
  StraightValues Y;
  long LeftOut = 0;
};

StraightPoints Straighten(
  const FormKind& kind, std::span<const double> x, std::span<const double> y)
{
  StraightPoints points;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double straightX = Straight(x[i], kind.LogX);
    const double straightY = Straight(y[i], kind.LogY);
    if (std::isfinite(straightX) && std::isfinite(straightY))
    {
      points.X.Values.push_back(straightX);
      points.Y.Values.push_back(straightY);
    }
    else
    {
      ++points.LeftOut;
    }
  }
  points.X.Finish(kind.LogX);
  points.Y.Finish(kind.LogY);
  return points;
}

double Mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/** Sum of squares that rounding alone leaves of n values. */
double RoundingOf(const StraightValues& values)
{
  const double each = 16.0 * std::numeric_limits<double>::epsilon() * values.Largest;
  return static_cast<double>(values.Values.size()) * each * each;
}

} // namespace

std::span<const FormKind> FormKinds()
{
  return Kinds;
}

const FormKind& CurveFit::Kind() const
{
  return Kinds[static_cast<std::size_t>(this->Form)];
}

double CurveFit::StandardErrorOfB() const
{
  return this->Points > 2 ? this->Deviation / this->SpreadX : Undefined;
}

double CurveFit::ValueAt(double x) const
{
  switch (this->Form)
  {
    case CurveForm::Power:
      return this->A * std::pow(x, this->B);
    case CurveForm::Exponential:
      return this->A * std::exp(this->B * x);
    default:
      return this->A + this->B * x;
  }
}

CurveBand CurveFit::BandAt(double x, double confidence) const
{
  if (this->Points < 3 || !(confidence > 0.0 && confidence < 1.0))
  {
    return { Undefined, Undefined };
  }
  const auto n = static_cast<double>(this->Points);
  const boost::math::students_t distribution(n - 2.0);
  const double t = boost::math::quantile(distribution, 0.5 * (1.0 + confidence));
  const bool logY = this->Kind().LogY;
  const double offset = (Straight(x, this->Kind().LogX) - this->MeanX) / this->SpreadX;
  const double half = t * this->Deviation * std::sqrt(1.0 / n + offset * offset);
  const double value = Straight(this->ValueAt(x), logY);
  return logY ? CurveBand{ std::exp(value - half), std::exp(value + half) }
              : CurveBand{ value - half, value + half };
}

std::optional<CurveFit> FitCurve(
  CurveForm form, std::span<const double> x, std::span<const double> y)
{
  CurveFit fit;
  fit.Form = form;
  const StraightPoints points = Straighten(fit.Kind(), x, y);
  const std::vector<double>& us = points.X.Values;
  const std::vector<double>& vs = points.Y.Values;
  if (us.size() < 2)
  {
    return {};
  }
  fit.Points = static_cast<long>(us.size());
  fit.LeftOut = points.LeftOut;
  const double meanX = Mean(us);
  const double meanY = Mean(vs);
  double squaresX = 0.0;
  double products = 0.0;
  double squaresY = 0.0;
  for (std::size_t i = 0; i < us.size(); ++i)
  {
    squaresX += (us[i] - meanX) * (us[i] - meanX);
    products += (us[i] - meanX) * (vs[i] - meanY);
    squaresY += (vs[i] - meanY) * (vs[i] - meanY);
  }
  const auto [least, greatest] = std::minmax_element(us.begin(), us.end());
  if (*least == *greatest || !(squaresX > 0.0))
  {
    return {};
  }
  const double slope = products / squaresX;
  const double intercept = meanY - slope * meanX;
  double rest = 0.0;
  for (std::size_t i = 0; i < us.size(); ++i)
  {
    const double error = vs[i] - intercept - slope * us[i];
    rest += error * error;
  }
  const double unitY = points.Y.Unit;
  const auto count = static_cast<double>(us.size());
  fit.B = slope * (unitY / points.X.Unit);
  fit.A = fit.Kind().LogY ? std::exp(intercept) : intercept * unitY;
  fit.MeanX = meanX * points.X.Unit;
  fit.SpreadX = std::sqrt(squaresX) * points.X.Unit;
  fit.RSquared = squaresY > 0.0 ? std::max(0.0, 1.0 - rest / squaresY) : Undefined;
  fit.Deviation = us.size() > 2 ? std::sqrt(rest / (count - 2.0)) * unitY : 0.0;
  // The logarithm of y has the derivative 1 / y: its density is carried back with it.
  fit.LogLikelihood = rest <= RoundingOf(points.Y)
    ? std::numeric_limits<double>::infinity()
    : -0.5 * count * (std::log(rest / count) + 2.0 * std::log(unitY)) -
      (fit.Kind().LogY ? count * meanY : 0.0);
  return fit;
}

std::optional<CurveFit> FitBestCurve(
  std::span<const double> x, std::span<const double> y, double leastRSquared)
{
  std::optional<CurveFit> best;
  for (const FormKind& kind : Kinds)
  {
    const std::optional<CurveFit> fit = FitCurve(kind.Form, x, y);
    if (!fit || (leastRSquared > 0.0 && !(fit->RSquared >= leastRSquared)))
    {
      continue;
    }
    if (!best || fit->Points > best->Points ||
      (fit->Points == best->Points && fit->LogLikelihood > best->LogLikelihood))
    {
      best = fit;
    }
  }
  return best;
}

} // namespace pemesh

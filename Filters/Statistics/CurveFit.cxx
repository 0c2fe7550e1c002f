// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveFit.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

bool HasLogX(CurveForm form)
{
  return form == CurveForm::Power;
}

bool HasLogY(CurveForm form)
{
  return form != CurveForm::Linear;
}

double Straight(double value, bool logarithmic)
{
  return !logarithmic ? value : value > 0.0 ? std::log(value) : Undefined;
}

/** Points where the curve is a straight line. */
struct StraightPoints
{
  std::vector<double> X;
  std::vector<double> Y;
  long LeftOut = 0;
};

StraightPoints Straighten(CurveForm form, std::span<const double> x, std::span<const double> y)
{
  StraightPoints points;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double straightX = Straight(x[i], HasLogX(form));
    const double straightY = Straight(y[i], HasLogY(form));
    if (std::isfinite(straightX) && std::isfinite(straightY))
    {
      points.X.push_back(straightX);
      points.Y.push_back(straightY);
    }
    else
    {
      ++points.LeftOut;
    }
  }
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

} // namespace

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
  const double offset = Straight(x, HasLogX(this->Form)) - this->MeanX;
  const double half = t * this->Deviation * std::sqrt(1.0 / n + offset * offset / this->SpreadX);
  const double value = Straight(this->ValueAt(x), HasLogY(this->Form));
  return HasLogY(this->Form) ? CurveBand{ std::exp(value - half), std::exp(value + half) }
                             : CurveBand{ value - half, value + half };
}

std::optional<CurveFit> FitCurve(
  CurveForm form, std::span<const double> x, std::span<const double> y)
{
  const StraightPoints points = Straighten(form, x, y);
  const std::size_t n = points.X.size();
  if (n < 2)
  {
    return {};
  }
  CurveFit fit;
  fit.Form = form;
  fit.Points = static_cast<long>(n);
  fit.LeftOut = points.LeftOut;
  fit.MeanX = Mean(points.X);
  const double meanY = Mean(points.Y);
  double products = 0.0;
  double spreadY = 0.0;
  double sumY = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    fit.SpreadX += (points.X[i] - fit.MeanX) * (points.X[i] - fit.MeanX);
    products += (points.X[i] - fit.MeanX) * (points.Y[i] - meanY);
    spreadY += (points.Y[i] - meanY) * (points.Y[i] - meanY);
    sumY += points.Y[i];
  }
  const auto [least, greatest] = std::minmax_element(points.X.begin(), points.X.end());
  if (*least == *greatest || !(fit.SpreadX > 0.0))
  {
    return {};
  }
  fit.B = products / fit.SpreadX;
  const double intercept = meanY - fit.B * fit.MeanX;
  fit.A = HasLogY(form) ? std::exp(intercept) : intercept;
  double residual = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double error = points.Y[i] - intercept - fit.B * points.X[i];
    residual += error * error;
  }
  const auto count = static_cast<double>(n);
  fit.RSquared = spreadY > 0.0 ? std::max(0.0, 1.0 - residual / spreadY) : Undefined;
  fit.Deviation = n > 2 ? std::sqrt(residual / (count - 2.0)) : 0.0;
  // The logarithm of y has the derivative 1 / y: its density is carried back with it.
  fit.LogLikelihood =
    -0.5 * count * std::log(std::max(residual / count, 1e-300)) - (HasLogY(form) ? sumY : 0.0);
  return fit;
}

std::optional<CurveFit> FitBestCurve(std::span<const double> x, std::span<const double> y)
{
  std::optional<CurveFit> best;
  for (const CurveForm form : { CurveForm::Linear, CurveForm::Power, CurveForm::Exponential })
  {
    const std::optional<CurveFit> fit = FitCurve(form, x, y);
    if (fit &&
      (!best || fit->Points > best->Points ||
        (fit->Points == best->Points && fit->LogLikelihood > best->LogLikelihood)))
    {
      best = fit;
    }
  }
  return best;
}

} // namespace pemesh

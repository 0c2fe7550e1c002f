// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FittedCurves.h"

#include "ChartOptions.h"
#include "CurveFit.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pemesh
{

namespace
{

constexpr int Samples = 120; // of a curve

std::optional<CurveFit> Fit(const std::string& name, const ChartSeries& series)
{
  static const std::map<std::string, CurveForm> forms = { { "linear", CurveForm::Linear },
    { "power", CurveForm::Power }, { "exponential", CurveForm::Exponential } };
  const auto form = forms.find(name);
  return form == forms.end() ? FitBestCurve(series.X, series.Y)
                             : FitCurve(form->second, series.X, series.Y);
}

/** The abscissae that the curve goes over, as places. */
AxisRange PlacesOf(const ChartAxis& axis, const ChartSeries& series, const CurveFit& fit)
{
  AxisRange range = { NoValue, NoValue };
  for (const double value : series.X)
  {
    const double place = axis.PlaceOf(value);
    if (std::isfinite(place) && (fit.Form != CurveForm::Power || value > 0.0))
    {
      range.Low = std::fmin(range.Low, place);
      range.High = std::fmax(range.High, place);
    }
  }
  return range;
}

ChartSeries MakeCurve(const ChartOptions& options, const ChartPlot& plot, const ChartSeries& series,
  const CurveFit& fit)
{
  ChartSeries curve;
  curve.Style = series.Style + (CountsPoints(plot) ? 1 : 0); // not lost in the density
  curve.Joined = true;
  curve.Marked = false;
  curve.OfRows = false;
  curve.Label = "fit: " + DescribeFit(fit);
  if (!std::isnan(fit.RSquared))
  {
    curve.Label += ", R² = " + ReadableNumber(fit.RSquared, 3);
  }
  const AxisRange range = PlacesOf(plot.X, series, fit);
  const bool hasBand = options.Confidence > 0.0 && fit.Points > 2;
  for (int i = 0; i <= Samples; ++i)
  {
    const double x = plot.X.ValueAt(range.Low + (range.High - range.Low) * i / Samples);
    curve.X.push_back(x);
    curve.Y.push_back(fit.ValueAt(x));
    if (hasBand)
    {
      const CurveBand band = fit.BandAt(x, options.Confidence);
      // On a logarithmic axis a lower end that is not positive is beyond the end of the axis.
      curve.Lower.push_back(
        plot.Y.Logarithmic && band.Lower <= 0.0 ? 1e-3 * curve.Y.back() : band.Lower);
      curve.Upper.push_back(band.Upper);
    }
  }
  return curve;
}

} // namespace

std::string DescribeFit(const CurveFit& fit)
{
  const std::string a = ReadableNumber(fit.A, 3);
  const std::string b = ReadableNumber(fit.B, 3);
  switch (fit.Form)
  {
    case CurveForm::Power:
      return "y = " + a + " x^" + b;
    case CurveForm::Exponential:
      return "y = " + a + " exp(" + b + " x)";
    default:
      return "y = " + a + (fit.B < 0.0 ? " − " : " + ") + ReadableNumber(std::fabs(fit.B), 3) +
        " x";
  }
}

void AddFits(const ChartOptions& options, ChartPlot& plot, std::vector<std::string>& notes)
{
  if (options.Fit == "none")
  {
    return;
  }
  std::vector<ChartSeries> curves;
  for (const ChartSeries& series : plot.AllSeries)
  {
    if (series.Y.empty())
    {
      continue;
    }
    const std::optional<CurveFit> fit = Fit(options.Fit, series);
    if (!fit)
    {
      notes.push_back("No curve through \"" + series.Label +
        "\": it needs two points with different abscissae" +
        (options.Fit == "linear" ? "." : ", and positive values."));
      continue;
    }
    if (fit->LeftOut > 0 && fit->Form != CurveForm::Linear)
    {
      notes.push_back("The curve of \"" + series.Label + "\" leaves out " +
        std::to_string(fit->LeftOut) + (fit->LeftOut == 1 ? " point." : " points."));
    }
    curves.push_back(MakeCurve(options, plot, series, *fit));
  }
  plot.LegendIsNeeded = plot.LegendIsNeeded || !curves.empty();
  std::move(curves.begin(), curves.end(), std::back_inserter(plot.AllSeries));
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Errors over the size of the mesh, with the orders they converge with.
#include "ChartBuilders.h"
#include "CurveFit.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

/** The part of a series that counts for its order. */
struct Stretch
{
  std::vector<double> X;
  std::vector<double> Y;
};

Stretch StretchOf(const ChartOptions& options, const ChartSeries& series)
{
  Stretch stretch;
  for (std::size_t i = 0; i < series.X.size(); ++i)
  {
    const double x = series.X[i];
    // A limit that is not set (NaN) is none.
    if (!(x < options.SlopeFrom) && !(x > options.SlopeTo) && std::isfinite(x) && x > 0.0 &&
      std::isfinite(series.Y[i]) && series.Y[i] > 0.0)
    {
      stretch.X.push_back(x);
      stretch.Y.push_back(series.Y[i]);
    }
  }
  return stretch;
}

/** A right triangle below the fitted line, in the middle of what was fitted, with its slope. */
void AddTriangle(const CurveFit& fit, const Stretch& stretch, int style, ChartPlot& plot)
{
  const auto [least, greatest] = std::minmax_element(stretch.X.begin(), stretch.X.end());
  const double low = std::log10(*least);
  const double span = std::log10(*greatest) - low;
  const double left = std::pow(10.0, low + 0.30 * span);
  const double right = std::pow(10.0, low + 0.55 * span);
  const double below = std::pow(10.0, -0.12 - 0.05 * std::fabs(fit.B) * span);
  const double start = below * fit.ValueAt(left);
  const double end = below * fit.ValueAt(right);
  ChartShape triangle;
  triangle.Style = style;
  // The right angle is away from the line: below it, whichever way it goes.
  const bool rises = end > start;
  const double corner = rises ? right : left;
  const double foot = rises ? start : end;
  triangle.X = { left, right, corner };
  triangle.Y = { start, end, foot };
  plot.Shapes.push_back(triangle);
  const double middle = std::sqrt(start * end);
  plot.Texts.push_back({ corner, middle, FixedNumber(std::fabs(fit.B), 2), rises ? -1 : 1, 0 });
  plot.Texts.push_back({ std::sqrt(left * right), foot, "1", 0, 1 });
}

/** False where the meshes come in no order of size: a line through them would go to and fro. */
bool IsRefinement(const std::vector<double>& sizes)
{
  std::vector<double> known;
  std::copy_if(sizes.begin(), sizes.end(), std::back_inserter(known),
    [](double size) { return std::isfinite(size); });
  return std::is_sorted(known.begin(), known.end()) || std::is_sorted(known.rbegin(), known.rend());
}

} // namespace

ChartPicture MakeConvergencePlot(const ChartRequest& request)
{
  ChartRequest logarithmic = request;
  logarithmic.LogX = true;
  logarithmic.LogY = true;
  ChartPicture picture = MakeLineChart(logarithmic);
  ChartPlot& plot = picture.Plots[0];
  for (ChartSeries& series : plot.AllSeries)
  {
    series.Joined = series.Joined && IsRefinement(series.X);
    const Stretch stretch = StretchOf(request.Options, series);
    const auto fit = FitCurve(CurveForm::Power, stretch.X, stretch.Y);
    if (!fit)
    {
      picture.Notes.push_back(
        "No order of \"" + series.Label + "\": it needs positive values at two different sizes.");
      continue;
    }
    series.Label += ": order " + FixedNumber(std::fabs(fit->B), 2);
    if (request.Options.Slopes)
    {
      AddTriangle(*fit, stretch, series.Style, plot);
    }
  }
  plot.LegendIsNeeded = true;
  plot.NotPositive = 0; // FinishPlot counts again
  plot.Undefined = 0;
  plot.Infinite = 0;
  FinishPicture(logarithmic, picture);
  return picture;
}

} // namespace pemesh

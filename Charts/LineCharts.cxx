// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and bands: one pair of axes for all, or one for each.
#include "ChartBuilders.h"

#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

ChartSeries ReadSeries(
  const ChartRequest& request, const ChartRequest::Series& asked, const std::vector<double>& x)
{
  if (asked.Lower.empty() != asked.Upper.empty())
  {
    throw std::runtime_error(
      "The band \"" + request.LabelOf(asked) + "\" needs a lower and an upper column.");
  }
  ChartSeries series;
  series.Label = request.LabelOf(asked);
  series.Joined = true;
  series.X = x;
  const auto read = [&request](const std::string& name)
  { return name.empty() ? std::vector<double>() : ReadNumbers(request.Table, name); };
  series.Y = read(asked.Line);
  series.Lower = read(asked.Lower);
  series.Upper = read(asked.Upper);
  return series;
}

/** The limit that was asked for, where it has a place on the axis. */
void UseLimit(double asked, const ChartAxis& axis, double& limit)
{
  const double place = axis.PlaceOf(asked);
  limit = std::isfinite(place) ? place : limit;
}

void UseLimits(double low, double high, ChartAxis& axis)
{
  if (!axis.Categories.empty())
  {
    return;
  }
  AxisRange range = axis.Range;
  UseLimit(low, axis, range.Low);
  UseLimit(high, axis, range.High);
  axis.Range = range.Low < range.High ? range : axis.Range;
}

} // namespace

ChartPlot MakeAxes(const ChartRequest& request)
{
  ChartPlot plot;
  plot.X.Title = request.TitleOfX();
  plot.X.Logarithmic = request.LogX;
  plot.Y.Title = request.TitleOfY();
  plot.Y.Logarithmic = request.LogY;
  plot.Y.Group = 1;
  plot.LogColor = request.LogColor;
  plot.ColorTitle =
    !request.ColorTitle.empty() ? request.ColorTitle : request.TitleOf(request.Color);
  return plot;
}

void FinishPicture(const ChartRequest& request, ChartPicture& picture)
{
  const ChartOptions& options = request.Options;
  for (ChartPlot& plot : picture.Plots)
  {
    FinishPlot(plot);
    UseLimits(options.XMin, options.XMax, plot.X);
    UseLimits(options.YMin, options.YMax, plot.Y);
  }
}

ChartPicture MakeLineChart(const ChartRequest& request)
{
  CheckRequest(request);
  if (!request.Color.empty())
  {
    // Points of a colour each cannot be joined by a line of one.
    return MakeScatterChart(request);
  }
  ChartPlot plot = MakeAxes(request);
  const std::vector<double> x = ReadNumbers(request.Table, request.X);
  for (const ChartRequest::Series& asked : request.AllSeries)
  {
    plot.AllSeries.push_back(ReadSeries(request, asked, x));
    plot.AllSeries.back().Style = static_cast<int>(plot.AllSeries.size()) - 1;
    plot.LegendIsNeeded = plot.LegendIsNeeded || !asked.Lower.empty();
  }
  ChartPicture picture;
  picture.Plots.push_back(std::move(plot));
  FinishPicture(request, picture);
  return picture;
}

ChartPicture MakeSmallMultiples(const ChartRequest& request)
{
  CheckRequest(request);
  const std::vector<double> x = ReadNumbers(request.Table, request.X);
  ChartPicture picture;
  AxisRange common = { NoValue, NoValue };
  for (const ChartRequest::Series& asked : request.AllSeries)
  {
    ChartPlot plot = MakeAxes(request);
    plot.Title = request.LabelOf(asked);
    plot.Y.Title.clear();
    plot.Y.Group = 1 + static_cast<int>(picture.Plots.size());
    plot.AllSeries.push_back(ReadSeries(request, asked, x));
    plot.AllSeries.back().InLegend = false;
    picture.Plots.push_back(std::move(plot));
  }
  picture.Columns =
    static_cast<int>(std::ceil(std::sqrt(static_cast<double>(picture.Plots.size()))));
  FinishPicture(request, picture);
  for (const ChartPlot& plot : picture.Plots)
  {
    if (!plot.IsEmpty)
    {
      common.Low = std::fmin(common.Low, plot.X.Range.Low);
      common.High = std::fmax(common.High, plot.X.Range.High);
    }
  }
  for (ChartPlot& plot : picture.Plots)
  {
    plot.X.Range = common.Low < common.High ? common : plot.X.Range;
  }
  return picture;
}

} // namespace pemesh

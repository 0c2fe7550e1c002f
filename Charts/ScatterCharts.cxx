// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Points: one cloud, or every pair of columns.
#include "ChartBuilders.h"

#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

std::vector<double> Pick(const std::vector<double>& values, const std::vector<vtkIdType>& rows)
{
  std::vector<double> picked;
  picked.reserve(rows.size());
  for (const vtkIdType row : rows)
  {
    picked.push_back(values[static_cast<std::size_t>(row)]);
  }
  return picked;
}

/** One series for every class, in place of one for all rows. */
void SplitByClass(const ChartRequest& request, const std::string& column, ChartPlot& plot)
{
  if (plot.AllSeries.size() != 1)
  {
    throw std::runtime_error("The column \"" + column +
      "\" holds classes, and colours by classes need exactly one y column.");
  }
  const ChartSeries whole = std::move(plot.AllSeries[0]);
  plot.AllSeries.clear();
  for (RowClass& rows : ReadClasses(request.Table, column))
  {
    ChartSeries part;
    part.Label = rows.Name;
    part.Style = static_cast<int>(plot.AllSeries.size());
    part.X = Pick(whole.X, rows.Rows);
    part.Y = Pick(whole.Y, rows.Rows);
    part.Rows = std::move(rows.Rows);
    plot.AllSeries.push_back(std::move(part));
  }
  plot.LegendIsNeeded = true;
}

} // namespace

void AddPoints(const ChartRequest& request, ChartPlot& plot)
{
  const std::vector<double> x = ReadNumbers(request.Table, request.X);
  for (const ChartRequest::Series& asked : request.AllSeries)
  {
    ChartSeries series;
    series.Label = request.LabelOf(asked);
    series.Style = static_cast<int>(plot.AllSeries.size());
    series.X = x;
    // Of a band, the points are its middle, or else both its ends.
    if (!asked.Line.empty())
    {
      series.Y = ReadNumbers(request.Table, asked.Line);
    }
    if (!asked.Lower.empty() && !asked.Upper.empty())
    {
      series.Lower = ReadNumbers(request.Table, asked.Lower);
      series.Upper = ReadNumbers(request.Table, asked.Upper);
      plot.LegendIsNeeded = true;
    }
    plot.AllSeries.push_back(std::move(series));
  }
  const std::string& classes =
    request.Options.Group.empty() ? request.Color : request.Options.Group;
  if (!classes.empty() && (!request.Options.Group.empty() || IsTextColumn(request.Table, classes)))
  {
    SplitByClass(request, classes, plot);
  }
  else if (!request.Color.empty())
  {
    for (ChartSeries& series : plot.AllSeries)
    {
      series.Values = ReadNumbers(request.Table, request.Color);
    }
  }
  const int most = request.Options.DensityAbove;
  plot.IsDensity = most > 0 && request.Table->GetNumberOfRows() > most;
}

ChartPicture MakeScatterChart(const ChartRequest& request)
{
  CheckRequest(request);
  ChartPlot plot = MakeAxes(request);
  AddPoints(request, plot);
  ChartPicture picture;
  picture.Plots.push_back(std::move(plot));
  FinishPicture(request, picture);
  return picture;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPlot.h"

#include <algorithm>

namespace pemesh
{

namespace
{

/** The least and greatest place of one axis. */
struct Extent
{
  double Low = NoValue;
  double High = NoValue;

  void Add(double place)
  {
    if (std::isfinite(place))
    {
      this->Low = std::fmin(this->Low, place);
      this->High = std::fmax(this->High, place);
    }
  }
};

/** Counts the values that have no place on an axis; returns their number. */
class MissingCounter
{
public:
  explicit MissingCounter(ChartPlot& plot)
    : Plot(plot)
  {
  }

  bool Count(double value, bool logarithmic)
  {
    this->Plot.Undefined += std::isnan(value) ? 1 : 0;
    this->Plot.Infinite += std::isinf(value) ? 1 : 0;
    const bool notPositive = logarithmic && std::isfinite(value) && value <= 0.0;
    this->Plot.NotPositive += notPositive ? 1 : 0;
    return !std::isfinite(value) || notPositive;
  }

private:
  ChartPlot& Plot;
};

std::vector<double> Logarithms(const std::vector<double>& values, const ChartAxis& axis)
{
  std::vector<double> places;
  if (axis.Logarithmic)
  {
    places.resize(values.size());
    std::transform(values.begin(), values.end(), places.begin(),
      [&axis](double value) { return axis.PlaceOf(value); });
  }
  return places;
}

void FinishSeries(ChartPlot& plot, std::size_t index, Extent& x, Extent& y)
{
  ChartSeries& series = plot.AllSeries[index];
  series.LogX = Logarithms(series.X, plot.X);
  series.LogY = Logarithms(series.Y, plot.Y);
  series.LogLower = Logarithms(series.Lower, plot.Y);
  series.LogUpper = Logarithms(series.Upper, plot.Y);
  MissingCounter missing(plot);
  // Series of all rows share their abscissae: each is counted once.
  const bool ownX = index == 0 || !series.Rows.empty();
  const std::vector<double>& placesX = series.PlacesX();
  const auto include = [&](const std::vector<double>& values, const std::vector<double>& places)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (!std::isfinite(placesX[i]))
      {
        continue; // the row is missing for its abscissa
      }
      if (series.OfRows && missing.Count(values[i], plot.Y.Logarithmic))
      {
        continue;
      }
      x.Add(placesX[i]);
      y.Add(places[i]);
    }
  };
  for (const double value : series.X)
  {
    if (ownX && series.OfRows)
    {
      missing.Count(value, plot.X.Logarithmic);
    }
  }
  include(series.Y, series.PlacesY());
  if (series.OfRows) // the band of a curve may be wider than is worth seeing
  {
    include(series.Lower, series.PlacesLower());
    include(series.Upper, series.PlacesUpper());
  }
}

AxisRange RangeOf(const ChartAxis& axis, const Extent& extent)
{
  if (!axis.Categories.empty())
  {
    return { -0.5, static_cast<double>(axis.Categories.size()) - 0.5 };
  }
  return axis.Logarithmic ? PadLogRange(extent.Low, extent.High)
                          : PadLinearRange(extent.Low, extent.High);
}

/** Says where all values are one: the picture alone does not tell that from a single value. */
void RemarkOnConstants(
  const ChartPlot& plot, const Extent& x, const Extent& y, std::vector<std::string>& remarks)
{
  std::size_t points = 0;
  for (const ChartSeries& series : plot.AllSeries)
  {
    // Series of all rows share them; classes have rows of their own.
    const std::size_t rows = series.OfRows ? series.X.size() : 0;
    points = series.Rows.empty() ? std::max(points, rows) : points + rows;
  }
  const auto remark = [&](const ChartAxis& axis, const Extent& extent, const std::string& otherwise)
  {
    if (points > 1 && axis.Categories.empty() && extent.Low == extent.High)
    {
      const bool named = axis.Title.find_first_not_of(' ') != std::string::npos;
      remarks.push_back("All values of " + (named ? axis.Title : otherwise) + " are " +
        ReadableNumber(axis.ValueAt(extent.Low)) + ".");
    }
  };
  remark(plot.X, x, "x");
  remark(plot.Y, y, plot.Title.empty() ? "y" : plot.Title);
}

std::string Count(long count, const std::string& what)
{
  return std::to_string(count) + (count == 1 ? " value " : " values ") + what;
}

std::string LogarithmicAxes(const ChartPicture& picture)
{
  bool x = false;
  bool y = false;
  for (const ChartPlot& plot : picture.Plots)
  {
    x = x || plot.X.Logarithmic;
    y = y || plot.Y.Logarithmic;
  }
  return x && y ? "logarithmic axes" : x ? "logarithmic x axis" : "logarithmic y axis";
}

} // namespace

bool CountsPoints(const ChartPlot& plot)
{
  const auto clouds = std::count_if(plot.AllSeries.begin(), plot.AllSeries.end(),
    [](const ChartSeries& series) { return series.OfRows; });
  return plot.IsDensity && clouds == 1 && plot.AllSeries[0].Values.empty();
}

void FinishPlot(ChartPlot& plot)
{
  Extent x;
  Extent y;
  for (std::size_t i = 0; i < plot.AllSeries.size(); ++i)
  {
    FinishSeries(plot, i, x, y);
  }
  for (const ChartBar& bar : plot.Bars)
  {
    for (const double* corner : { bar.Low, bar.High })
    {
      x.Add(plot.X.PlaceOf(corner[0]));
      y.Add(plot.Y.PlaceOf(corner[1]));
    }
  }
  for (const ChartShape& shape : plot.Shapes)
  {
    for (std::size_t i = 0; i < shape.X.size(); ++i)
    {
      x.Add(plot.X.PlaceOf(shape.X[i]));
      y.Add(plot.Y.PlaceOf(shape.Y[i]));
    }
  }
  Extent values;
  const auto addValue = [&](double value)
  { values.Add(plot.LogColor && !(value > 0.0) ? NoValue : value); };
  long colourless = 0;
  for (const ChartSeries& series : plot.AllSeries)
  {
    std::for_each(series.Values.begin(), series.Values.end(), addValue);
    colourless += std::count_if(series.Values.begin(), series.Values.end(),
      [&plot](double value) { return !std::isfinite(value) || (plot.LogColor && value <= 0.0); });
  }
  for (const ChartBar& bar : plot.Bars)
  {
    addValue(bar.HasValue ? bar.Value : NoValue);
  }
  plot.Values = { values.Low, values.High };
  plot.Remarks.clear();
  RemarkOnConstants(plot, x, y, plot.Remarks);
  if (colourless > 0)
  {
    plot.Remarks.push_back("Grey: " + Count(colourless, "of " + plot.ColorTitle) +
      (plot.LogColor ? " undefined, infinite or not positive." : " undefined or infinite."));
  }
  plot.IsEmpty = std::isnan(y.Low);
  plot.X.Range = RangeOf(plot.X, x);
  plot.Y.Range = RangeOf(plot.Y, y);
}

std::string DescribePicture(const ChartPicture& picture)
{
  long notPositive = 0;
  long undefined = 0;
  long infinite = 0;
  for (const ChartPlot& plot : picture.Plots)
  {
    notPositive += plot.NotPositive;
    undefined += plot.Undefined;
    infinite += plot.Infinite;
  }
  std::string text;
  const auto add = [&text](const std::string& part)
  { text += (text.empty() ? "Not drawn: " : ", ") + part; };
  if (notPositive > 0)
  {
    add(Count(notPositive, "not positive (") + LogarithmicAxes(picture) + ")");
  }
  if (undefined > 0)
  {
    add(Count(undefined, "undefined"));
  }
  if (infinite > 0)
  {
    add(Count(infinite, "infinite"));
  }
  text += text.empty() ? "" : ".";
  std::vector<std::string> sentences = picture.Notes;
  if (!picture.IsMatrix) // which would say it of every pair
  {
    for (const ChartPlot& plot : picture.Plots)
    {
      sentences.insert(sentences.end(), plot.Remarks.begin(), plot.Remarks.end());
    }
  }
  const auto mixed = std::find_if(picture.Plots.begin(), picture.Plots.end(),
    [](const ChartPlot& plot) { return plot.IsDensity && !CountsPoints(plot); });
  if (mixed != picture.Plots.end())
  {
    const bool byValue = std::any_of(mixed->AllSeries.begin(), mixed->AllSeries.end(),
      [](const ChartSeries& series) { return !series.Values.empty(); });
    sentences.push_back(std::string("Too many points to draw each: a cell has the ") +
      (byValue ? "mean colour" : "mixed colours") +
      " of those in it, and is paler where they are few.");
  }
  for (const std::string& sentence : sentences)
  {
    text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

} // namespace pemesh

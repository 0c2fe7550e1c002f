// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Every column against every other one: as points, and as coefficients of correlation.
#include "ChartBuilders.h"
#include "Correlation.h"
#include "Distribution.h"

#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace pemesh
{

namespace
{

/** Columns of single values, and of bands their middle. */
std::vector<std::string> ColumnNames(const ChartRequest& request)
{
  std::vector<std::string> names;
  for (const ChartRequest::Series& series : request.AllSeries)
  {
    names.push_back(series.Line.empty() ? series.Lower : series.Line);
  }
  return names;
}

/** A histogram that is as high as the axis of the column, which it stands on the diagonal of. */
void DrawHistogram(const std::vector<double>& column, ChartPlot& plot)
{
  std::vector<double> sorted;
  for (const double value : column)
  {
    const double place = plot.X.PlaceOf(value);
    if (std::isfinite(place))
    {
      sorted.push_back(place);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty() || !(sorted.back() > sorted.front()))
  {
    return;
  }
  const int bins = std::min(ChooseBins(sorted), 20);
  std::vector<ChartBar> bars(static_cast<std::size_t>(bins));
  std::size_t most = 1;
  for (std::size_t row = 0; row < column.size(); ++row)
  {
    const double place = plot.X.PlaceOf(column[row]);
    if (std::isfinite(place))
    {
      std::vector<vtkIdType>& rows =
        bars[static_cast<std::size_t>(BinOf(place, sorted.front(), sorted.back(), bins))].Rows;
      rows.push_back(static_cast<vtkIdType>(row));
      most = std::max(most, rows.size());
    }
  }
  const AxisRange& range = plot.Y.Range;
  for (std::size_t bin = 0; bin < bars.size(); ++bin)
  {
    ChartBar& bar = bars[bin];
    const double part = 0.92 * static_cast<double>(bar.Rows.size()) / static_cast<double>(most);
    bar.Low[0] =
      plot.X.ValueAt(BinStart(static_cast<int>(bin), sorted.front(), sorted.back(), bins));
    bar.High[0] =
      plot.X.ValueAt(BinStart(static_cast<int>(bin) + 1, sorted.front(), sorted.back(), bins));
    bar.Low[1] = plot.Y.ValueAt(range.Low);
    bar.High[1] = plot.Y.ValueAt(range.Low + part * (range.High - range.Low));
    bar.Pale = true;
    bar.Name = std::to_string(bar.Rows.size()) + " values from " + ReadableNumber(bar.Low[0]) +
      " to " + ReadableNumber(bar.High[0]);
    if (!bar.Rows.empty())
    {
      plot.Bars.push_back(bar);
    }
  }
}

double Coefficient(
  const std::string& method, const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> x;
  std::vector<double> y;
  RemoveMissing(a, b, x, y);
  using Function = double (*)(std::span<const double>, std::span<const double>);
  static const std::map<std::string, Function> functions = {
    { "pearson", PearsonCorrelation },
    { "spearman", SpearmanCorrelation },
    { "kendall",
      [](std::span<const double> first, std::span<const double> second)
      {
        const bool constant = IsConstant(first) || IsConstant(second);
        return constant ? NoValue : KendallTauB(CountKendallPairs(first, second));
      } },
  };
  return functions.at(method)(x, y);
}

/** Columns by how strongly they go with the others, or with the one of the abscissae. */
std::vector<std::size_t> OrderByStrength(
  const std::vector<std::vector<double>>& matrix, std::ptrdiff_t leader)
{
  std::vector<double> strength(matrix.size(), 0.0);
  for (std::size_t i = 0; i < matrix.size(); ++i)
  {
    for (std::size_t j = 0; j < matrix.size(); ++j)
    {
      const bool counts = leader < 0 ? i != j : j == static_cast<std::size_t>(leader);
      strength[i] += counts && std::isfinite(matrix[i][j]) ? std::fabs(matrix[i][j]) : 0.0;
    }
  }
  if (leader >= 0)
  {
    strength[static_cast<std::size_t>(leader)] = HUGE_VAL;
  }
  std::vector<std::size_t> order(matrix.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&strength](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
  return order;
}

ChartBar MakeCell(std::size_t column, std::size_t row, std::size_t size, double value)
{
  ChartBar cell;
  cell.Low[0] = static_cast<double>(column) - 0.5;
  cell.High[0] = static_cast<double>(column) + 0.5;
  cell.Low[1] = static_cast<double>(size - 1 - row) - 0.5; // the first row is the uppermost
  cell.High[1] = static_cast<double>(size - 1 - row) + 0.5;
  cell.HasValue = true;
  cell.Value = value;
  std::string text =
    std::isfinite(value) ? ReadableNumber(std::round(100.0 * value) / 100.0, 2) : "";
  cell.Text = text;
  return cell;
}

} // namespace

ChartPicture MakeScatterMatrix(const ChartRequest& request)
{
  CheckRequest(request, 2);
  const std::vector<std::string> names = ColumnNames(request);
  const auto size = static_cast<int>(names.size());
  ChartPicture picture;
  picture.Columns = size;
  picture.IsMatrix = true;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      ChartRequest pair = request;
      pair.X = names[static_cast<std::size_t>(column)];
      pair.AllSeries = { request.AllSeries[static_cast<std::size_t>(row)] };
      pair.AllSeries[0] = { names[static_cast<std::size_t>(row)], "", "", "" };
      pair.XTitle = request.LabelOf(request.AllSeries[static_cast<std::size_t>(column)]);
      pair.YTitle = request.LabelOf(request.AllSeries[static_cast<std::size_t>(row)]);
      pair.LogY = request.LogX; // one column has one kind of axis
      ChartPlot plot = MakeAxes(pair);
      AddPoints(pair, plot);
      FinishPlot(plot);
      plot.X.Group = column; // a column is zoomed wherever it is
      plot.Y.Group = row;
      plot.X.HasLabels = row == size - 1;
      plot.Y.HasLabels = column == 0;
      if (row == column)
      {
        const bool empty = plot.IsEmpty;
        for (ChartSeries& series : plot.AllSeries)
        {
          ChartSeries entry; // of the legend
          entry.Label = series.Label;
          entry.Style = series.Style;
          series = entry;
        }
        plot.IsDensity = false;
        DrawHistogram(ReadNumbers(request.Table, pair.X), plot);
        plot.IsEmpty = empty;
      }
      else
      {
        plot.Undefined = 0; // they are counted on the diagonal
        plot.Infinite = 0;
        plot.NotPositive = 0;
      }
      picture.Plots.push_back(std::move(plot));
    }
  }
  // Rows without a place in one column leave gaps in the range of the others: take the diagonal's.
  for (int i = 0; i < size * size; ++i)
  {
    ChartPlot& plot = picture.Plots[static_cast<std::size_t>(i)];
    plot.X.Range = picture.Plots[static_cast<std::size_t>((i % size) * (size + 1))].X.Range;
    plot.Y.Range = picture.Plots[static_cast<std::size_t>((i / size) * (size + 1))].X.Range;
    plot.HasColorBar = i == 0;
  }
  return picture;
}

ChartPicture MakeCorrelationMatrix(const ChartRequest& request)
{
  CheckRequest(request, 2);
  const std::vector<std::string> names = ColumnNames(request);
  std::vector<std::vector<double>> columns;
  for (const std::string& name : names)
  {
    columns.push_back(ReadNumbers(request.Table, name));
  }
  const std::size_t size = names.size();
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size, 1.0));
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      matrix[i][j] = Coefficient(request.Options.Method, columns[i], columns[j]);
      matrix[j][i] = matrix[i][j];
    }
  }
  const auto leader = std::find(names.begin(), names.end(), request.X);
  const std::vector<std::size_t> order =
    OrderByStrength(matrix, leader == names.end() ? -1 : leader - names.begin());
  ChartPlot plot;
  plot.ColorMap = "red-blue";
  plot.ColorRange[0] = -1.0;
  plot.ColorRange[1] = 1.0;
  plot.ColorTitle = request.Options.Method + " correlation";
  plot.ColorTitle[0] = static_cast<char>(plot.ColorTitle[0] - 'a' + 'A');
  std::string undefined;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::string label = request.LabelOf(request.AllSeries[order[i]]);
    plot.X.Categories.push_back(label);
    plot.Y.Categories.insert(plot.Y.Categories.begin(), label);
    const bool constant = !std::isfinite(matrix[order[i]][order[i]]);
    undefined += constant ? (undefined.empty() ? "" : ", ") + label : "";
    for (std::size_t j = 0; j < size; ++j)
    {
      const double value = matrix[order[i]][order[j]];
      ChartBar cell = MakeCell(j, i, size, value);
      cell.Name = label + " and " + request.LabelOf(request.AllSeries[order[j]]) + ": " +
        ReadableNumber(value);
      plot.Bars.push_back(std::move(cell));
    }
  }
  plot.Y.Group = 1;
  ChartPicture picture;
  picture.Plots.push_back(std::move(plot));
  FinishPicture(request, picture);
  if (!undefined.empty())
  {
    picture.Notes.push_back(
      "No correlation with a column of one value or none: " + undefined + ".");
  }
  return picture;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartKinds.h"

#include "ChartBuilders.h"

#include <algorithm>

namespace pemesh
{

std::span<const ChartKind> ChartKinds()
{
  static const std::vector<ChartKind> kinds = {
    { "line", "Lines", "Columns over another one, joined in the order of the rows.",
      "x; any number of y", true, true, true, 1, 0.7, true, false, { "group-by" }, MakeLineChart },
    { "scatter", "Scatter",
      "Columns against another one, coloured by a third one; a density where there are many "
      "points.",
      "x; any number of y; color-by, a number or classes", true, true, true, 1, 0.7, false, false,
      { "group-by", "fit", "confidence", "density-above" }, MakeScatterChart },
    { "small-multiples", "Small multiples", "A small line chart for every column over one x.",
      "x; any number of y", true, false, true, 1, 0.75, true, false, {}, MakeSmallMultiples },
    { "scatter-matrix", "Scatter-plot matrix",
      "Every column against every other one, with histograms on the diagonal.",
      "two or more y; color-by", false, true, true, 2, 0.95, false, false,
      { "group-by", "density-above" }, MakeScatterMatrix },
    { "correlation-matrix", "Correlation matrix",
      "Coefficients of correlation as a heat map, the strongest columns first.",
      "two or more y; x, if one of them, leads", true, false, false, 2, 0.9, false, false,
      { "method" }, MakeCorrelationMatrix },
    { "histogram", "Histogram", "How many values are where.", "one or more y", false, false, true,
      1, 0.7, false, true, { "group-by", "bins" }, MakeHistogram },
    { "box", "Box plot", "Median, quartiles, whiskers and outliers of columns or classes.",
      "one or more y; group-by", false, false, true, 1, 0.7, false, true, { "group-by" },
      MakeBoxPlot },
    { "violin", "Violin plot", "Densities of columns or classes, with their quartiles.",
      "one or more y; group-by", false, false, true, 1, 0.7, false, true, { "group-by" },
      MakeViolinPlot },
    { "convergence", "Convergence",
      "Errors over the mesh size on logarithmic axes, with the fitted order of each.",
      "x, a size; one or more y", true, false, false, 1, 0.8, false, false,
      { "slopes", "slope-from", "slope-to" }, MakeConvergencePlot },
    { "element-scatter", "Element scatter",
      "A metric of each element against another value of it, such as its error.",
      "x, a metric; y, an error; color-by", true, true, true, 1, 0.75, false, true,
      { "group-by", "fit", "confidence", "density-above" }, MakeScatterChart },
  };
  return kinds;
}

const ChartKind* FindChartKind(const std::string& name)
{
  const auto kinds = ChartKinds();
  const auto found = std::find_if(
    kinds.begin(), kinds.end(), [&name](const ChartKind& kind) { return name == kind.Name; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> ChartKindNames()
{
  std::vector<std::string> names;
  for (const ChartKind& kind : ChartKinds())
  {
    names.emplace_back(kind.Name);
  }
  return names;
}

bool HasOption(const ChartKind& kind, const std::string& option)
{
  const bool isLimit = option.starts_with("x-m") || option.starts_with("y-m");
  return isLimit ||
    std::find(kind.Options.begin(), kind.Options.end(), option) != kind.Options.end();
}

} // namespace pemesh

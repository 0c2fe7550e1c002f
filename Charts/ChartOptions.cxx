// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartOptions.h"

#include <vector>

namespace pemesh
{

std::span<const SettingField<ChartOptions>> ChartOptionFields()
{
  using O = ChartOptions;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  static const std::vector<SettingField<ChartOptions>> fields = {
    { "group-by", "Group by",
      "Column whose values each get a box, a violin or a colour of their own.", &O::Group },
    { "fit", "Fitted curve",
      "Least-squares curve through the points of each series; best is the one with the least "
      "error.",
      &O::Fit, 0, 0, { "none", "linear", "power", "exponential", "best" } },
    { "confidence", "Confidence", "Of the band of the mean around a fitted curve; 0 draws none.",
      &O::Confidence, 0, 0.999 },
    { "bins", "Bins", "Of a histogram; 0 chooses by the data.", &O::Bins, 0, 1000 },
    { "method", "Coefficient", "Of correlation.", &O::Method, 0, 0,
      { "spearman", "pearson", "kendall" } },
    { "slopes", "Slope triangles",
      "Whether a convergence plot shows the fitted order of each series.", &O::Slopes },
    { "slope-from", "Fit order from", "Smallest abscissa that counts for the fitted order.",
      &O::SlopeFrom, -infinity, infinity },
    { "slope-to", "Fit order to", "Largest abscissa that counts for the fitted order.", &O::SlopeTo,
      -infinity, infinity },
    { "density-above", "Density above",
      "Number of points above which a scatter shows how many are where; 0 draws all points.",
      &O::DensityAbove, 0, 1000000000 },
    { "x-min", "Least x", "Where the x axis begins.", &O::XMin, -infinity, infinity },
    { "x-max", "Greatest x", "Where the x axis ends.", &O::XMax, -infinity, infinity },
    { "y-min", "Least y", "Where the y axis begins.", &O::YMin, -infinity, infinity },
    { "y-max", "Greatest y", "Where the y axis ends.", &O::YMax, -infinity, infinity },
  };
  return fields;
}

} // namespace pemesh

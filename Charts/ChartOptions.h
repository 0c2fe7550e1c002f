// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the kinds of charts can be asked beyond their columns.
 */
#ifndef pemesh_ChartOptions_h
#define pemesh_ChartOptions_h

#include "SettingFields.h"
#include "pemeshChartsModule.h" // For export macro

#include <limits>
#include <span>
#include <string>

namespace pemesh
{

struct ChartOptions
{
  std::string Group;               // column that splits the rows, one box or violin each
  std::string Fit = "none";        // curve through a scatter
  double Confidence = 0.95;        // of the band around it; 0: no band
  int Bins = 0;                    // of a histogram; 0: by the data
  std::string Method = "spearman"; // of a correlation
  bool Slopes = true;              // triangles in a convergence plot
  double SlopeFrom = std::numeric_limits<double>::quiet_NaN(); // sizes between which it is fitted
  double SlopeTo = std::numeric_limits<double>::quiet_NaN();
  int DensityAbove = 10000; // points that are drawn one by one; 0: all
  double XMin = std::numeric_limits<double>::quiet_NaN(); // limits of the axes
  double XMax = std::numeric_limits<double>::quiet_NaN();
  double YMin = std::numeric_limits<double>::quiet_NaN();
  double YMax = std::numeric_limits<double>::quiet_NaN();
};

/** The table of all members. */
PEMESHCHARTS_EXPORT std::span<const SettingField<ChartOptions>> ChartOptionFields();

} // namespace pemesh

#endif

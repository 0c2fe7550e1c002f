// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Which columns of a table of meshes are metrics and which are performances, and columns as plain
 * samples.
 */
#ifndef pemesh_ColumnRoles_h
#define pemesh_ColumnRoles_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <string>
#include <vector>

class vtkTable;

namespace pemesh
{

/** Field data list of the columns that are performances although their names do not say so. */
inline constexpr const char* PerformancesList = "Performances";

/** The column that tells the studies of a pooled table apart. */
inline constexpr const char* StudyColumn = "Study";

/**
 * `<Metric>_<statistic>`, perhaps with a group of elements behind it: Area_min, Area_mean_placed,
 * Area_q0.5. Neither histograms nor the ids of extreme elements.
 */
PEMESHFILTERSSTATISTICS_EXPORT bool IsMetricColumn(const std::string& name);

/** In the list Performances, or `<run>_<performance>`, no metric, and not in the list Measured. */
PEMESHFILTERSSTATISTICS_EXPORT bool IsPerformanceColumn(vtkTable* table, const std::string& name);

/** The columns that hold numbers, in order. */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<std::string> NumericColumns(vtkTable* table);

PEMESHFILTERSSTATISTICS_EXPORT std::vector<std::string> MetricColumns(vtkTable* table);
PEMESHFILTERSSTATISTICS_EXPORT std::vector<std::string> PerformanceColumns(vtkTable* table);

/** Empty if all are numeric columns of the table, else one sentence. */
PEMESHFILTERSSTATISTICS_EXPORT std::string WhyNotNumeric(
  vtkTable* table, const std::vector<std::string>& names);

/** Empty if the table has the column, else one sentence. */
PEMESHFILTERSSTATISTICS_EXPORT std::string WhyNoColumn(vtkTable* table, const std::string& name);

/** The values of a numeric column. */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> ColumnNumbers(
  vtkTable* table, const std::string& name);

/** The values of any column, numbers as FormatNumber writes them. */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<std::string> ColumnTexts(
  vtkTable* table, const std::string& name);

} // namespace pemesh

#endif

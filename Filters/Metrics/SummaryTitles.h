// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the columns of vtkPEMMetricSummary are called where people read them.
 */
#ifndef pemesh_SummaryTitles_h
#define pemesh_SummaryTitles_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <string>
#include <string_view>

namespace pemesh
{

/** A label within a sentence: "minimum angle" of "Minimum angle"; "VEM indicator" stays. */
PEMESHFILTERSMETRICS_EXPORT std::string LowerFirst(std::string text);

/**
 * The title of a column of the summary or of the array of a metric, in words, with the symbol of
 * the metric, the group of elements and the unit: "smallest minimum angle MA, placed polygons
 * (rad)" for MinAngle_min_placed. All words are those of the tables of metrics, statistics and
 * groups. Empty for a column that is not of that kind.
 */
PEMESHFILTERSMETRICS_EXPORT std::string TitleOfSummaryColumn(std::string_view column);

/** Whether it is a number of the mesh, or of the values of a metric, or an element id or a count.
 */
PEMESHFILTERSMETRICS_EXPORT bool IsOfSummary(std::string_view column);

/** Whether it is a statistic or a quantile of a metric: no element id, and no count. */
PEMESHFILTERSMETRICS_EXPORT bool IsStatisticOfMetric(std::string_view column);

} // namespace pemesh

#endif

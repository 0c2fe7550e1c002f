// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The reference of all metrics, made from the registry: Filters/Metrics/METRICS.md.
 */
#ifndef pemesh_MetricReference_h
#define pemesh_MetricReference_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <string>

namespace pemesh
{

/** The whole page, in Markdown with formulas in TeX. */
PEMESHFILTERSMETRICS_EXPORT std::string DescribeMetrics();

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lines of many points without those that cannot be seen.
 */
#ifndef pemesh_LineThinning_h
#define pemesh_LineThinning_h

#include "pemeshChartsModule.h" // For export macro

#include <vector>

namespace pemesh
{

/**
 * Of consecutive points (x0 y0 x1 y1 …) in one column of this width keeps the first, the lowest,
 * the highest and the last, in their order: the same picture at that width. Lines of fewer than a
 * thousand points stay as they are.
 *
 * Reference: U. Jugel et al., M4: a visualization-oriented time series data aggregation, PVLDB 7
 * (2014) 797-808, doi:10.14778/2732951.2732953.
 */
PEMESHCHARTS_EXPORT void ThinLine(std::vector<float>& points, double columnWidth);

/**
 * The strip (x low x high …) that a line fills which goes up and down many times in every column of
 * this width, with half a line width more on either side; empty for any other line.
 */
PEMESHCHARTS_EXPORT std::vector<float> StripOfLine(
  const std::vector<float>& points, double columnWidth, double halfWidth);

} // namespace pemesh

#endif

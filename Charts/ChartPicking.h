// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Finds marks by where they were drawn. All points are searched, also those that a thinned line or
 * a density does not show one by one: a million take a few milliseconds. Private to this module.
 */
#ifndef pemesh_ChartPicking_h
#define pemesh_ChartPicking_h

#include "ChartPick.h"
#include "PlotAxes.h"

namespace pemesh
{

/** Which of the plots a point of the device is in, or -1. */
int FindPlot(const std::vector<PlotPlacement>& placements, double x, double y);

/**
 * The nearest point within `tolerance` (units of the device); where there is none the nearest line;
 * where there is none the bar that is there.
 */
ChartPick PickMark(
  const ChartPlot& plot, const PlotPlacement& place, double x, double y, double tolerance);

/** Adds the rows with a point, or a bar, in a rectangle of the device. */
void SelectRows(const ChartPlot& plot, const PlotPlacement& place, const Box& rectangle,
  std::vector<vtkIdType>& rows);

} // namespace pemesh

#endif

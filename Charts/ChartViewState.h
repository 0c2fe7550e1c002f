// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What of a chart is seen, and where it was painted last. Private to this module.
 */
#ifndef pemesh_ChartViewState_h
#define pemesh_ChartViewState_h

#include "ChartPlot.h"
#include "PlotAxes.h"

#include <map>
#include <vector>

namespace pemesh
{

struct ChartViewState
{
  std::map<int, AxisRange> Ranges; // places, by the group of axes; empty: all is seen
  std::vector<PlotPlacement> Placements;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One function for every kind of chart: columns in, marks out. Private to this module.
 */
#ifndef pemesh_ChartBuilders_h
#define pemesh_ChartBuilders_h

#include "ChartRequest.h"

namespace pemesh
{

ChartPicture MakeLineChart(const ChartRequest& request);
ChartPicture MakeSmallMultiples(const ChartRequest& request);
ChartPicture MakeScatterChart(const ChartRequest& request);
ChartPicture MakeScatterMatrix(const ChartRequest& request);
ChartPicture MakeCorrelationMatrix(const ChartRequest& request);
ChartPicture MakeHistogram(const ChartRequest& request);
ChartPicture MakeBoxPlot(const ChartRequest& request);
ChartPicture MakeViolinPlot(const ChartRequest& request);
ChartPicture MakeConvergencePlot(const ChartRequest& request);

///@{
/** Parts of several kinds. Axes with titles and logarithms as asked for. */
ChartPlot MakeAxes(const ChartRequest& request);
/** The series of a scatter, split and coloured as asked for; above DensityAbove a density. */
void AddPoints(const ChartRequest& request, ChartPlot& plot);
/** Ends a picture: places, ranges and limits that were asked for. */
void FinishPicture(const ChartRequest& request, ChartPicture& picture);
///@}

} // namespace pemesh

#endif

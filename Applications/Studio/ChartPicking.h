// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The row of a table that is under the mouse in a painted chart.
 */
#ifndef pemesh_ChartPicking_h
#define pemesh_ChartPicking_h

#include <QPointF>

#include <string>
#include <vector>

class vtkPEMChart;
class vtkTable;

namespace pemesh
{

struct PaintedPanels;

/**
 * The row whose point is nearest to a place in the view of the chart, within `radius` pixels, or
 * -1; with a negative radius the row whose abscissa is nearest.
 */
int FindNearestRow(const PaintedPanels& painted, int panel, const QPointF& position,
  const std::vector<std::string>& yColumns, double radius);

} // namespace pemesh

#endif

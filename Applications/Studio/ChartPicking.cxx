// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPicking.h"

#include "PanelView.h"
#include "vtkPEMChart.h"

#include <cmath>

#include <vtkDataArray.h>
#include <vtkTable.h>

namespace pemesh
{

int FindNearestRow(const PaintedPanels& painted, int panel, const QPointF& position,
  const std::vector<std::string>& yColumns, double radius)
{
  auto* chart = panel >= 0 && panel < static_cast<int>(painted.Panels.size())
    ? vtkPEMChart::SafeDownCast(painted.Panels[static_cast<std::size_t>(panel)])
    : nullptr;
  vtkTable* table = chart ? chart->GetTable() : nullptr;
  auto* xs = table ? vtkDataArray::SafeDownCast(table->GetColumnByName(chart->GetXColumn().c_str()))
                   : nullptr;
  if (!xs)
  {
    return -1;
  }
  const double height = painted.Image.height() / painted.Image.devicePixelRatio();
  int nearest = -1;
  double least = radius < 0.0 ? INFINITY : radius;
  for (vtkIdType row = 0; row < xs->GetNumberOfTuples(); ++row)
  {
    const double dx = chart->GetDeviceX(xs->GetTuple1(row)) - position.x();
    if (radius < 0.0 && std::abs(dx) < least)
    {
      least = std::abs(dx);
      nearest = static_cast<int>(row);
    }
    for (const std::string& column : yColumns)
    {
      auto* ys = vtkDataArray::SafeDownCast(table->GetColumnByName(column.c_str()));
      const double dy =
        ys ? height - chart->GetDeviceY(ys->GetTuple1(row)) - position.y() : std::nan("");
      if (radius >= 0.0 && std::hypot(dx, dy) < least)
      {
        least = std::hypot(dx, dy);
        nearest = static_cast<int>(row);
      }
    }
  }
  return nearest;
}

} // namespace pemesh

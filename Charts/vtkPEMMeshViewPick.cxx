// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The second half of vtkPEMMeshView: what is at a place.
#include "vtkPEMMeshView.h"

#include "AxisTicks.h"
#include "ElementAccess.h"
#include "PointLocation.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

pemesh::ChartPick vtkPEMMeshView::Pick(double deviceX, double deviceY, double)
{
  pemesh::ChartPick pick;
  if (!this->Mesh || !(this->ToDevice[2] > 0.0))
  {
    return pick;
  }
  const double x = (deviceX - this->ToDevice[0]) / this->ToDevice[2];
  const double y = (deviceY - this->ToDevice[1]) / this->ToDevice[2];
  pemesh::ElementAccess access(this->Mesh);
  std::vector<pemesh::Point2> element;
  for (vtkIdType cell = 0; cell < access.GetNumberOfElements(); ++cell)
  {
    access.GetVertices(cell, element);
    if (!pemesh::ContainsPoint(element, { x, y }))
    {
      continue;
    }
    pick.What = pemesh::ChartPick::Kind::Area;
    pick.Row = cell;
    pick.Element = cell;
    pick.X = x;
    pick.Y = y;
    pick.DeviceX = deviceX;
    pick.DeviceY = deviceY;
    pick.Series = this->ColorTitle.empty() ? this->ColorArray : this->ColorTitle;
    pick.Text = "element " + std::to_string(cell);
    vtkDataArray* values = this->Mesh->GetCellData()->GetArray(this->ColorArray.c_str());
    if (values)
    {
      pick.Text +=
        ", " + pick.Series + " = " + pemesh::ReadableNumber(values->GetComponent(cell, 0));
    }
    break;
  }
  return pick;
}

std::vector<vtkIdType> vtkPEMMeshView::SelectRectangle(double x0, double y0, double x1, double y1)
{
  std::vector<vtkIdType> cells;
  if (!this->Mesh || !(this->ToDevice[2] > 0.0))
  {
    return cells;
  }
  vtkCellArray* polygons = this->Mesh->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->GetCellAtId(cell, count, ids);
    const bool isIn = std::any_of(ids, ids + count,
      [&](vtkIdType id)
      {
        double point[3];
        this->Mesh->GetPoint(id, point);
        const double x = this->GetDeviceX(point[0]);
        const double y = this->GetDeviceY(point[1]);
        return x >= std::min(x0, x1) && x <= std::max(x0, x1) && y >= std::min(y0, y1) &&
          y <= std::max(y0, y1);
      });
    if (isIn)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

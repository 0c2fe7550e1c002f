// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementAccess.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

struct CopyIds
{
  template <typename CellState>
  void operator()(CellState& state, vtkIdType element, std::vector<vtkIdType>& ids) const
  {
    const auto range = state.GetCellRange(element);
    ids.assign(range.begin(), range.end());
  }
};

} // namespace

ElementAccess::ElementAccess(vtkPolyData* mesh)
  : Polygons(mesh->GetPolys())
  , Points(mesh->GetPoints())
  , Coordinates(nullptr)
{
  if (this->Points)
  {
    auto* array = vtkDoubleArray::SafeDownCast(this->Points->GetData());
    this->Coordinates = array ? array->GetPointer(0) : nullptr;
  }
}

std::string ElementAccess::WhyUnusable(vtkPolyData* mesh)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0 || mesh->GetNumberOfPolys() == 0)
  {
    return "the mesh has no polygons";
  }
  if (mesh->GetNumberOfCells() != mesh->GetNumberOfPolys())
  {
    return "the mesh has cells that are not polygons (vertices, lines or strips)";
  }
  const vtkIdType points = mesh->GetNumberOfPoints();
  ElementAccess access(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < access.GetNumberOfElements(); ++element)
  {
    access.GetVertexIds(element, ids);
    if (ids.size() < 3)
    {
      return "element " + std::to_string(element) + " has fewer than three vertices";
    }
    for (const vtkIdType id : ids)
    {
      if (id < 0 || id >= points)
      {
        return "element " + std::to_string(element) + " uses vertex " + std::to_string(id) +
          ", and the mesh has " + std::to_string(points) + " vertices";
      }
    }
  }
  return {};
}

vtkIdType ElementAccess::GetNumberOfElements() const
{
  return this->Polygons->GetNumberOfCells();
}

void ElementAccess::GetVertexIds(vtkIdType element, std::vector<vtkIdType>& ids)
{
  this->Polygons->Visit(CopyIds{}, element, ids);
}

void ElementAccess::GetVertices(vtkIdType element, std::vector<Point2>& vertices)
{
  this->GetVertexIds(element, this->Ids);
  vertices.resize(this->Ids.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const vtkIdType id = this->Ids[i];
    if (this->Coordinates)
    {
      vertices[i] = { this->Coordinates[3 * id], this->Coordinates[3 * id + 1] };
    }
    else
    {
      double point[3];
      this->Points->GetPoint(id, point);
      vertices[i] = { point[0], point[1] };
    }
  }
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementAccess.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

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

struct CountDistinct
{
  template <typename CellState>
  vtkIdType operator()(CellState& state, vtkIdType element) const
  {
    const auto range = state.GetCellRange(element);
    vtkIdType count = 0;
    vtkIdType before = range.size() > 0 ? static_cast<vtkIdType>(range[range.size() - 1]) : -1;
    for (const vtkIdType id : range)
    {
      count += id != before ? 1 : 0;
      before = id;
    }
    return count;
  }
};

/** Coordinates of an element, from an array of x, y, z. */
struct CopyVertices
{
  template <typename CellState>
  void operator()(CellState& state, vtkIdType element, const double* coordinates,
    std::vector<Point2>& vertices) const
  {
    const auto range = state.GetCellRange(element);
    vertices.resize(static_cast<std::size_t>(range.size()));
    auto vertex = vertices.begin();
    for (const vtkIdType id : range)
    {
      *vertex++ = { coordinates[3 * id], coordinates[3 * id + 1] };
    }
  }
};

/** The first element with fewer than three vertices, or with one that there is not; else -1. */
struct FindUnusable
{
  template <typename CellState>
  vtkIdType operator()(CellState& state, vtkIdType points) const
  {
    const vtkIdType elements = state.GetNumberOfCells();
    for (vtkIdType element = 0; element < elements; ++element)
    {
      const auto range = state.GetCellRange(element);
      bool isUsable = range.size() >= 3;
      for (const vtkIdType id : range)
      {
        isUsable = isUsable && id >= 0 && id < points;
      }
      if (!isUsable)
      {
        return element;
      }
    }
    return -1;
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
  const vtkIdType element = mesh->GetPolys()->Visit(FindUnusable{}, points);
  if (element < 0)
  {
    return {};
  }
  std::vector<vtkIdType> ids;
  ElementAccess(mesh).GetVertexIds(element, ids);
  if (ids.size() < 3)
  {
    return "element " + std::to_string(element) + " has fewer than three vertices";
  }
  const auto missing =
    std::ranges::find_if(ids, [points](vtkIdType id) { return id < 0 || id >= points; });
  return "element " + std::to_string(element) + " uses vertex " + std::to_string(*missing) +
    ", and the mesh has " + std::to_string(points) + " vertices";
}

vtkIdType ElementAccess::GetNumberOfElements() const
{
  return this->Polygons->GetNumberOfCells();
}

vtkIdType ElementAccess::CountVertices(vtkIdType element)
{
  return this->Polygons->Visit(CountDistinct{}, element);
}

void ElementAccess::GetVertexIds(vtkIdType element, std::vector<vtkIdType>& ids)
{
  this->Polygons->Visit(CopyIds{}, element, ids);
}

void ElementAccess::GetVertices(vtkIdType element, std::vector<Point2>& vertices)
{
  if (this->Coordinates)
  {
    this->Polygons->Visit(CopyVertices{}, element, this->Coordinates, vertices);
    return;
  }
  this->GetVertexIds(element, this->Ids);
  vertices.clear();
  for (const vtkIdType id : this->Ids)
  {
    double point[3];
    this->Points->GetPoint(id, point);
    vertices.push_back({ point[0], point[1] });
  }
}

} // namespace pemesh

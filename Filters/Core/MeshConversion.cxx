// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshConversion.h"

#include "ElementAccess.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace pemesh
{

PolygonMesh ToPolygonMesh(vtkPolyData* input)
{
  constexpr vtkIdType Most = std::numeric_limits<int>::max();
  vtkCellArray* polygons = input->GetPolys();
  if (input->GetNumberOfPoints() > Most || polygons->GetNumberOfConnectivityIds() > Most)
  {
    throw std::length_error("The mesh has more than 2147483647 points or sides.");
  }
  PolygonMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    double point[3];
    input->GetPoint(static_cast<vtkIdType>(i), point);
    mesh.Points[i] = { point[0], point[1] };
  }
  ElementAccess access(input);
  const vtkIdType elements = access.GetNumberOfElements();
  mesh.Offsets.reserve(static_cast<std::size_t>(elements) + 1);
  mesh.Vertices.reserve(static_cast<std::size_t>(polygons->GetNumberOfConnectivityIds()));
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < elements; ++element)
  {
    access.GetVertexIds(element, ids);
    std::transform(ids.begin(), ids.end(), std::back_inserter(mesh.Vertices),
      [](vtkIdType id) { return static_cast<int>(id); });
    mesh.Offsets.push_back(mesh.NumberOfSides());
  }
  return mesh;
}

void SetPolygonMesh(vtkPolyData* output, const PolygonMesh& mesh)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Points.size()));
  double* coordinate = coordinates->GetPointer(0);
  for (const Point2& point : mesh.Points)
  {
    *coordinate++ = point.x;
    *coordinate++ = point.y;
    *coordinate++ = 0.0;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(coordinates);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(mesh.Offsets.size()));
  std::copy(mesh.Offsets.begin(), mesh.Offsets.end(), offsets->GetPointer(0));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(mesh.NumberOfSides());
  std::copy(mesh.Vertices.begin(), mesh.Vertices.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetPolys(cells);
}

void CopyProvenance(vtkPolyData* input, const std::vector<int>& sources, vtkPolyData* output)
{
  for (const char* name : { ElementFamilyArray, PolygonIdArray })
  {
    vtkDataArray* from = input ? input->GetCellData()->GetArray(name) : nullptr;
    vtkNew<vtkIntArray> to;
    to->SetName(name);
    to->SetNumberOfValues(static_cast<vtkIdType>(sources.size()));
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      const bool isKnown = from && sources[i] >= 0;
      to->SetValue(
        static_cast<vtkIdType>(i), isKnown ? static_cast<int>(from->GetTuple1(sources[i])) : -1);
    }
    output->GetCellData()->AddArray(to);
  }
}

std::string ToDomain(vtkPolyData* input, Domain& domain)
{
  domain = UnitSquare();
  if (!input || input->GetNumberOfCells() == 0)
  {
    return {};
  }
  const std::string unusable = ElementAccess::WhyUnusable(input);
  if (!unusable.empty())
  {
    return "The domain cannot be used: " + unusable + ".";
  }
  ElementAccess access(input);
  std::vector<std::vector<Point2>> loops(static_cast<std::size_t>(access.GetNumberOfElements()));
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    access.GetVertices(static_cast<vtkIdType>(i), loops[i]);
  }
  return MakeDomain(std::move(loops), domain);
}

} // namespace pemesh

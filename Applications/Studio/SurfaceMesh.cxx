// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceMesh.h"

#include "ElementAccess.h"
#include "TriangulatePolygon.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr vtkIdType ElementsOfBlock = 20000;

/** Some elements with points of their own: what is shared between blocks is doubled. */
vtkSmartPointer<vtkPolyData> MakeBlock(
  vtkPolyData* mesh, vtkDataArray* values, vtkIdType first, vtkIdType last)
{
  ElementAccess elements(mesh);
  PolygonTriangulator triangulator;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  std::vector<Point2> vertices;
  std::vector<vtkIdType> ids;
  for (vtkIdType element = first; element < last; ++element)
  {
    elements.GetVertices(element, vertices);
    elements.GetVertexIds(element, ids);
    const vtkIdType begin = points->GetNumberOfPoints();
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const double value = values->GetTuple1(ids[i]);
      points->InsertNextPoint(vertices[i].x, vertices[i].y, std::isfinite(value) ? value : 0.0);
      heights->InsertNextValue(value);
    }
    for (const PolygonTriangle& triangle : triangulator.Triangulate(vertices))
    {
      const vtkIdType corners[3] = { begin + triangle[0], begin + triangle[1],
        begin + triangle[2] };
      triangles->InsertNextCell(3, corners);
    }
  }
  auto block = vtkSmartPointer<vtkPolyData>::New();
  block->SetPoints(points);
  block->SetPolys(triangles);
  block->GetPointData()->SetScalars(heights);
  return block;
}

} // namespace

SurfaceMesh MakeSurface(
  const MeshPicture& picture, const std::string& array, const std::atomic<bool>& stop)
{
  SurfaceMesh surface;
  vtkPolyData* mesh = picture.GetMesh();
  vtkDataArray* values = mesh->GetPointData()->GetArray(array.c_str());
  if (!values)
  {
    return surface;
  }
  values->GetFiniteRange(surface.Range);
  const vtkIdType count = picture.GetNumberOfElements();
  for (vtkIdType first = 0; first < count && !stop; first += ElementsOfBlock)
  {
    surface.Blocks.push_back(
      MakeBlock(mesh, values, first, std::min(first + ElementsOfBlock, count)));
  }
  return surface;
}

} // namespace pemesh

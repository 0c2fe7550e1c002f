// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceMesh.h"

#include "ArrayValues.h"
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

SurfaceShape MakeSurfaceShape(const MeshPicture& picture, const std::atomic<bool>& stop)
{
  SurfaceShape shape;
  vtkPolyData* mesh = picture.GetMesh();
  shape.Points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < shape.Points.size(); ++i)
  {
    double point[3];
    mesh->GetPoint(static_cast<vtkIdType>(i), point);
    shape.Points[i] = { point[0], point[1] };
  }
  ElementAccess elements(mesh);
  PolygonTriangulator triangulator;
  std::vector<Point2> vertices;
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < picture.GetNumberOfElements() && !stop; ++element)
  {
    elements.GetVertices(element, vertices);
    elements.GetVertexIds(element, ids);
    for (const PolygonTriangle& triangle : triangulator.Triangulate(vertices))
    {
      shape.Triangles.push_back({ static_cast<std::uint32_t>(ids[triangle[0]]),
        static_cast<std::uint32_t>(ids[triangle[1]]),
        static_cast<std::uint32_t>(ids[triangle[2]]) });
    }
  }
  return shape;
}

SurfaceField MakeSurfaceField(const MeshPicture& picture, const std::string& array)
{
  SurfaceField field;
  vtkDataArray* values = picture.GetMesh()->GetPointData()->GetArray(array.c_str());
  if (!values)
  {
    return field;
  }
  double range[2] = { INFINITY, -INFINITY };
  if (ExtendRange(values, range))
  {
    std::copy_n(range, 2, field.Range);
  }
  field.Values.resize(static_cast<std::size_t>(values->GetNumberOfTuples()));
  for (std::size_t i = 0; i < field.Values.size(); ++i)
  {
    field.Values[i] = ValueOf(values, static_cast<vtkIdType>(i));
  }
  return field;
}

vtkSmartPointer<vtkPolyData> MakeSurfaceData(const SurfaceShape& shape, const SurfaceField& field)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (std::size_t i = 0; i < shape.Points.size(); ++i)
  {
    const double value = field.Values[i];
    points->InsertNextPoint(
      shape.Points[i].x, shape.Points[i].y, std::isfinite(value) ? value : 0.0);
    heights->InsertNextValue(value);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : shape.Triangles)
  {
    const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetPointData()->SetScalars(heights);
  return data;
}

SurfacePair MakeSurfacePair(const MeshPicture& picture, const std::string& run,
  std::size_t mostForVtk, const std::atomic<bool>& stop)
{
  SurfacePair pair;
  pair.Shape = MakeSurfaceShape(picture, stop);
  pair.Fields[0] = MakeSurfaceField(picture, run + "_Solution");
  pair.Fields[1] = MakeSurfaceField(picture, run + "_GroundTruth");
  for (int side = 0; side < 2 && pair.Shape.Triangles.size() <= mostForVtk; ++side)
  {
    if (!pair.Fields[side].Values.empty())
    {
      pair.Data[side] = MakeSurfaceData(pair.Shape, pair.Fields[side]);
    }
  }
  return pair;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes for the tests of metrics, and the values that a filter found. No C++20 here: the test of
 * threads is compiled as C++17.
 */
#ifndef MetricMeshes_h
#define MetricMeshes_h

#include <array>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pemesh::test
{

using Coordinates = std::vector<std::array<double, 2>>;

/** A mesh of polygons that share no vertices. */
inline vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<Coordinates>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Coordinates& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const auto& point : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point[0], point[1], 0.0));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/** A mesh of polygons given by the numbers of their points. */
inline vtkSmartPointer<vtkPolyData> MakeSharedMesh(
  const Coordinates& coordinates, const std::vector<std::vector<vtkIdType>>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : coordinates)
  {
    points->InsertNextPoint(point[0], point[1], 0.0);
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

inline double CellValue(vtkPolyData* mesh, const std::string& name, vtkIdType element)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray(name.c_str());
  return array ? array->GetComponent(element, 0) : -1e300;
}

inline const Coordinates& SquareCoordinates()
{
  static const Coordinates square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  return square;
}

} // namespace pemesh::test

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTriangulate.h"

#include "CaseStatus.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace
{

/** A star of 2 n vertices with so thin spikes that fans and centroids are far off. */
vtkSmartPointer<vtkPolyData> MakeStarInSquare(int n)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> star;
  for (int i = 0; i < 2 * n; ++i)
  {
    const double radius = i % 2 == 0 ? 1.0 : 0.01;
    const double angle = std::acos(-1.0) * i / n;
    star->InsertNextId(
      points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  cells->InsertNextCell(star);
  cells->InsertNextCell({ 0, 1, 2 });
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/** By the shoelace formula, with a sign. */
double AreaOf(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  double twice = 0.0;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    double a[3];
    double b[3];
    mesh->GetPoint(ids->GetId(i), a);
    mesh->GetPoint(ids->GetId((i + 1) % ids->GetNumberOfIds()), b);
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2.0;
}

} // namespace

TEST(Triangulate, FillsConcaveElementsAndNothingElse)
{
  const int spikes = 7;
  const auto mesh = MakeStarInSquare(spikes);
  vtkNew<vtkPEMTriangulate> filter;
  filter->SetInputData(mesh);
  filter->Update();
  vtkPolyData* triangles = filter->GetOutput();
  ASSERT_EQ(triangles->GetNumberOfPolys(), 2 * spikes - 2 + 1);
  vtkDataArray* element = triangles->GetCellData()->GetArray("OriginalElement");
  ASSERT_NE(element, nullptr);
  std::map<int, double> areas;
  for (vtkIdType i = 0; i < triangles->GetNumberOfPolys(); ++i)
  {
    EXPECT_EQ(triangles->GetPolys()->GetCellSize(i), 3);
    const double area = AreaOf(triangles, i);
    if (element->GetTuple1(i) == 0.0)
    {
      EXPECT_GT(area, 0.0) << i; // all counter-clockwise: positive areas with the right sum fill it
    }
    areas[static_cast<int>(element->GetTuple1(i))] += area;
  }
  EXPECT_NEAR(areas[0], AreaOf(mesh, 0), 1e-15);
  EXPECT_EQ(areas[1], AreaOf(mesh, 1));
  EXPECT_EQ(triangles->GetPoints(), mesh->GetPoints()) << "the points are shared";
}

TEST(Triangulate, NeedlesKeepTheirArea)
{
  // A vertex that rounding almost puts on the opposite side: VTK's ear cut gives no triangle here.
  const auto mesh = pemesh::MakeTestMesh(
    { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1e-15 }, { 0, 1 } }, { { 0, 1, 2, 3, 4 } });
  vtkNew<vtkPEMTriangulate> filter;
  filter->SetInputData(mesh);
  filter->Update();
  double sum = 0.0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPolys(); ++i)
  {
    sum += AreaOf(filter->GetOutput(), i);
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 3);
  EXPECT_NEAR(sum, 1.0, 1e-14);
}

TEST(Triangulate, CarriesArraysAlong)
{
  const auto mesh = pemesh::MakeHouse();
  const vtkIdType elements = mesh->GetNumberOfPolys();
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < elements; ++i)
  {
    values->InsertNextValue(10.0 + static_cast<double>(i));
    names->InsertNextValue("element " + std::to_string(i));
  }
  mesh->GetCellData()->AddArray(values);
  mesh->GetCellData()->AddArray(names);
  pemesh::SetFieldNumber(mesh, "t", 0.5);
  vtkNew<vtkPEMTriangulate> filter;
  filter->SetInputData(mesh);
  filter->Update();
  vtkPolyData* triangles = filter->GetOutput();
  vtkCellData* data = triangles->GetCellData();
  for (vtkIdType i = 0; i < triangles->GetNumberOfPolys(); ++i)
  {
    const auto element = static_cast<vtkIdType>(data->GetArray("OriginalElement")->GetTuple1(i));
    EXPECT_EQ(data->GetArray("Value")->GetTuple1(i), values->GetValue(element));
    auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
    EXPECT_EQ(texts->GetValue(i), names->GetValue(element));
  }
  EXPECT_EQ(triangles->GetFieldData()->GetArray("t")->GetTuple1(0), 0.5);
  EXPECT_EQ(
    triangles->GetPointData()->GetNumberOfArrays(), mesh->GetPointData()->GetNumberOfArrays());
}

TEST(Triangulate, PassesOnWhatFailed)
{
  vtkNew<vtkPolyData> failed;
  pemesh::SetCaseFailed(failed, "invalid-layout", "Two polygons overlap.");
  vtkNew<vtkPEMTriangulate> filter;
  filter->SetInputData(failed);
  filter->Update();
  EXPECT_EQ(pemesh::GetCaseStatusMessage(filter->GetOutput()), "Two polygons overlap.");

  const auto lines = pemesh::MakeHouse();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  lines->SetLines(line);
  filter->SetInputData(lines);
  filter->Update();
  EXPECT_TRUE(pemesh::IsCaseFailed(filter->GetOutput()));
}

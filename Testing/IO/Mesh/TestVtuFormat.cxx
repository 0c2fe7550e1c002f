// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, std::vector<double> values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

} // namespace

TEST(VtuFormat, KeepsAllArraysAndTheTypesOfCells)
{
  const auto mesh = MakeHouse();
  mesh->GetCellData()->AddArray(MakeArray("Area", { 0.5, 0.25, 0.1 }));
  mesh->GetPointData()->AddArray(MakeArray("u", { 1, 2, 3, 4, 5, 1.0 / 3.0 }));
  mesh->GetFieldData()->AddArray(MakeArray("t", { 0.7 }));
  const std::filesystem::path path = TestFolder() / "mesh.vtu";
  WriteMesh(path, mesh);
  const auto again = ReadMesh(path);
  ExpectSameMesh(again, mesh);
  EXPECT_EQ(again->GetCellData()->GetArray("Area")->GetTuple1(2), 0.1);
  EXPECT_EQ(again->GetPointData()->GetArray("u")->GetTuple1(5), 1.0 / 3.0);
  EXPECT_EQ(again->GetFieldData()->GetArray("t")->GetTuple1(0), 0.7);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(reader->GetOutput()->GetCellType(1), VTK_TRIANGLE);
}

TEST(VtuFormat, LeavesOutLinesWithTheirValues)
{
  const auto house = MakeHouse();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(house->GetPoints());
  const vtkIdType cells[3][4] = { { 0, 1, 0, 0 }, { 0, 1, 3, 2 }, { 1, 4, 2, 0 } };
  grid->InsertNextCell(VTK_LINE, 2, cells[0]);
  grid->InsertNextCell(VTK_PIXEL, 4, cells[1]);
  grid->InsertNextCell(VTK_VERTEX, 1, cells[0]);
  grid->InsertNextCell(VTK_TRIANGLE, 3, cells[2]);
  grid->GetCellData()->AddArray(MakeArray("Id", { 10, 11, 12, 13 }));
  const std::filesystem::path path = TestFolder() / "mesh.vtu";
  const auto write = [&]
  {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileName(path.c_str());
    writer->Write();
  };
  write();
  const auto mesh = ReadMesh(path);
  EXPECT_EQ(PolygonsOf(mesh), (TestPolygons{ { 0, 1, 2, 3 }, { 1, 4, 2 } }));
  EXPECT_EQ(mesh->GetCellData()->GetArray("Id")->GetTuple1(0), 11);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Id")->GetTuple1(1), 13);
  grid->InsertNextCell(VTK_TETRA, 4, cells[1]);
  grid->GetCellData()->Initialize();
  write();
  EXPECT_THAT([&] { ReadMesh(path); },
    testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("cell, 4, of VTK's type 10")));
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>

using namespace pemesh;

namespace
{

/** Arrays of every place, and ranges that VTK writes as METADATA. */
void AddArrays(vtkDataSet* mesh)
{
  const auto make = [](const char* name, vtkIdType count)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(2);
    array->SetComponentName(0, "first");
    array->SetNumberOfTuples(count);
    array->Fill(0.5);
    return vtkSmartPointer<vtkDataArray>(array);
  };
  mesh->GetPointData()->AddArray(make("u", mesh->GetNumberOfPoints()));
  mesh->GetCellData()->AddArray(make("Area", mesh->GetNumberOfCells()));
  mesh->GetFieldData()->AddArray(make("t", 3));
  double range[2];
  static_cast<vtkPointSet*>(mesh)->GetPoints()->GetData()->GetRange(range, -1);
}

template <typename Writer>
void WriteLegacy(const std::filesystem::path& path, vtkDataSet* mesh, int version, bool binary)
{
  vtkNew<Writer> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(path.c_str());
  writer->SetFileVersion(version);
  binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
  writer->Write();
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid()
{
  const auto house = MakeHouse();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(house->GetPoints());
  const vtkIdType line[] = { 0, 1 };
  const vtkIdType pixel[] = { 0, 1, 3, 2 };
  const vtkIdType triangle[] = { 1, 4, 2 };
  const vtkIdType polygon[] = { 4, 5, 2 };
  grid->InsertNextCell(VTK_LINE, 2, line);
  grid->InsertNextCell(VTK_PIXEL, 4, pixel);
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  grid->InsertNextCell(VTK_POLYGON, 3, polygon);
  return grid;
}

constexpr int Versions[] = { vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2,
  vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1 };

} // namespace

TEST(VtkLegacyFormat, ReadsWhatVtkWrites)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtk";
  for (const int version : Versions)
  {
    for (const bool binary : { false, true })
    {
      SCOPED_TRACE(std::to_string(version) + (binary ? " binary" : " text"));
      const auto mesh = MakeHouse();
      AddArrays(mesh);
      WriteLegacy<vtkPolyDataWriter>(path, mesh, version, binary);
      ExpectSameMesh(ReadMesh(path), mesh);
      const auto grid = MakeGrid();
      AddArrays(grid);
      WriteLegacy<vtkUnstructuredGridWriter>(path, grid, version, binary);
      ExpectSameMesh(ReadMesh(path), MakeHouse());
    }
  }
}

TEST(VtkLegacyFormat, BinaryKeepsTheBits)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtk";
  for (const int version : Versions)
  {
    WriteLegacy<vtkPolyDataWriter>(path, MakeAwkwardMesh(), version, true);
    ExpectSameMesh(ReadMesh(path), MakeAwkwardMesh());
  }
}

TEST(VtkLegacyFormat, NumbersMayStandOnAnyLines)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtk";
  WriteBytes(path,
    "# vtk DataFile Version 2.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0\n0 0 1 0\n"
    "LINES 1 3\n2 0 1\nPOLYGONS 1 4 3\n0 1\n2\nPOINT_DATA 3\nSCALARS u float 1\n");
  ExpectSameMesh(ReadMesh(path), MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } }));
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * VTU, VTK's XML format for unstructured grids, with all arrays. Triangles, quadrilaterals and
 * polygons are elements; points and lines are dropped, with their values.
 */
#include "FormatFunctions.h"

#include "ElementAccess.h"
#include "MeshText.h"
#include "VtkXmlFile.h"

#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace pemesh
{

namespace
{

bool IsPolygon(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON || type == VTK_PIXEL;
}

/** Whether the cells of the grid are elements as they stand. */
bool HasOnlyPolygons(vtkUnstructuredGrid* grid)
{
  const vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (const int type = types->GetValue(i); !IsPolygon(type) || type == VTK_PIXEL)
    {
      return false;
    }
  }
  return true;
}

/** The polygons of the grid and the numbers of their cells. */
vtkSmartPointer<vtkCellArray> PolygonsOfGrid(
  const std::filesystem::path& path, vtkUnstructuredGrid* grid, vtkIdList* kept)
{
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const int type = grid->GetCellType(i);
    if (type >= VTK_EMPTY_CELL && type <= VTK_POLY_LINE)
    {
      continue;
    }
    if (!IsPolygon(type))
    {
      FailMeshFile(path,
        "has a cell, " + std::to_string(i) + ", of VTK's type " + std::to_string(type) +
          "; a planar mesh has triangles (5), polygons (7) and quadrilaterals (9)");
    }
    grid->GetCells()->GetCellAtId(i, ids);
    if (type == VTK_PIXEL && ids->GetNumberOfIds() == 4)
    {
      std::swap(*ids->GetPointer(2), *ids->GetPointer(3)); // pixels go row by row
    }
    polygons->InsertNextCell(ids);
    kept->InsertNextId(i);
  }
  return polygons;
}

void CheckUsable(const std::filesystem::path& path, vtkPolyData* mesh)
{
  const std::string reason = ElementAccess::WhyUnusable(mesh);
  if (!reason.empty())
  {
    FailMeshFile(path, "cannot be used: " + reason);
  }
}

/** The elements of the grid with their arrays and those of the vertices. */
void TakePolygons(const std::filesystem::path& path, vtkUnstructuredGrid* grid, vtkPolyData* mesh)
{
  if (HasOnlyPolygons(grid)) // as in all that WriteVtu writes: nothing is copied
  {
    mesh->SetPolys(grid->GetCells());
    CheckUsable(path, mesh);
    mesh->GetPointData()->ShallowCopy(grid->GetPointData());
    mesh->GetCellData()->ShallowCopy(grid->GetCellData());
    return;
  }
  vtkNew<vtkIdList> kept;
  mesh->SetPolys(PolygonsOfGrid(path, grid, kept));
  CheckUsable(path, mesh);
  mesh->GetPointData()->ShallowCopy(grid->GetPointData());
  mesh->GetCellData()->CopyAllOn();
  mesh->GetCellData()->CopyAllocate(grid->GetCellData(), kept->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    mesh->GetCellData()->CopyData(grid->GetCellData(), kept->GetId(i), i);
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadVtu(const std::filesystem::path& path)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  ReadVtkXml(path, reader, "VTU");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->GetFieldData()->ShallowCopy(grid->GetFieldData());
  MakePointsPlanar(path, grid);
  mesh->SetPoints(grid->GetPoints());
  if (grid->GetNumberOfCells() == 0 && grid->GetNumberOfPoints() == 0)
  {
    return mesh; // of a case that failed
  }
  CheckOffsets(path, grid->GetCells(), "VTU");
  if (grid->GetCellTypesArray()->GetNumberOfValues() != grid->GetCells()->GetNumberOfCells())
  {
    FailMeshFile(path, "cannot be read as VTU: it has not as many cells as types of cells");
  }
  TakePolygons(path, grid, mesh);
  return mesh;
}

void WriteVtu(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckOnlyPolygons(path, mesh);
  const auto bare = BareCopy(mesh);
  vtkNew<vtkUnsignedCharArray> types;
  for (vtkIdType i = 0; i < bare->GetNumberOfPolys(); ++i)
  {
    const vtkIdType corners = bare->GetPolys()->GetCellSize(i);
    const auto type = corners == 3 ? VTK_TRIANGLE : corners == 4 ? VTK_QUAD : VTK_POLYGON;
    types->InsertNextValue(static_cast<unsigned char>(type));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(bare->GetPoints());
  grid->SetCells(types, bare->GetPolys());
  grid->GetPointData()->ShallowCopy(bare->GetPointData());
  grid->GetCellData()->ShallowCopy(bare->GetCellData());
  grid->GetFieldData()->ShallowCopy(bare->GetFieldData());
  vtkNew<WriterWithoutRanges<vtkXMLUnstructuredGridWriter>> writer;
  WriteVtkXml(path, writer, grid);
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * VTP, VTK's XML format for vtkPolyData, with all arrays. The bytes of
 * a file are the same for the same mesh.
 */
#include "FormatFunctions.h"

#include "ElementAccess.h"
#include "MeshText.h"
#include "VtkXmlFile.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace pemesh
{

vtkSmartPointer<vtkPolyData> ReadVtp(const std::filesystem::path& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  ReadVtkXml(path, reader, "VTP");
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(reader->GetOutput());
  CheckOffsets(path, mesh->GetPolys(), "VTP");
  MakePointsPlanar(path, mesh);
  if (mesh->GetNumberOfCells() == 0 && mesh->GetNumberOfPoints() == 0)
  {
    return mesh; // of a case that failed
  }
  const std::string reason = ElementAccess::WhyUnusable(mesh);
  if (!reason.empty())
  {
    FailMeshFile(path, "cannot be used: " + reason);
  }
  return mesh;
}

void WriteVtp(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckOnlyPolygons(path, mesh);
  vtkNew<WriterWithoutRanges<vtkXMLPolyDataWriter>> writer;
  WriteVtkXml(path, writer, BareCopy(mesh));
}

} // namespace pemesh

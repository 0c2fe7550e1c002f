// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshText.h"

#include <stdexcept>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace pemesh
{

std::string TextOfMesh(vtkPolyData* mesh)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

vtkSmartPointer<vtkPolyData> MeshOfText(const std::string& text)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw std::runtime_error("A process has sent half a mesh.");
  }
  return reader->GetOutput();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshWriter.h"

#include "MeshFormats.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkPEMMeshWriter);

vtkPEMMeshWriter::vtkPEMMeshWriter() = default;

void vtkPEMMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}

void vtkPEMMeshWriter::SetFileName(const std::string& fileName)
{
  if (this->FileName != fileName)
  {
    this->FileName = fileName;
    this->Modified();
  }
}

std::string vtkPEMMeshWriter::GetFileName() const
{
  return this->FileName;
}

int vtkPEMMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkPEMMeshWriter::WriteData()
{
  if (this->FileName.empty())
  {
    vtkErrorMacro("No file name is given: set where to write the mesh.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    pemesh::WriteMesh(this->FileName, vtkPolyData::SafeDownCast(this->GetInput()));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

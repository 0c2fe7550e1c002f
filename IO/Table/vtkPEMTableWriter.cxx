// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTableWriter.h"

#include "CsvTable.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <exception>

vtkStandardNewMacro(vtkPEMTableWriter);

vtkPEMTableWriter::vtkPEMTableWriter() = default;

void vtkPEMTableWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}

void vtkPEMTableWriter::SetFileName(const std::string& fileName)
{
  if (this->FileName != fileName)
  {
    this->FileName = fileName;
    this->Modified();
  }
}

std::string vtkPEMTableWriter::GetFileName() const
{
  return this->FileName;
}

int vtkPEMTableWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

void vtkPEMTableWriter::WriteData()
{
  if (this->FileName.empty())
  {
    vtkErrorMacro("No file name is given: set where to write the table.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    pemesh::WriteCsvFile(this->FileName, vtkTable::SafeDownCast(this->GetInput()));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

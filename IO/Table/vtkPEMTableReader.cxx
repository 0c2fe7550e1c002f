// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTableReader.h"

#include "CsvTable.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <exception>

vtkStandardNewMacro(vtkPEMTableReader);

vtkPEMTableReader::vtkPEMTableReader()
{
  this->SetNumberOfInputPorts(0);
}

void vtkPEMTableReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}

void vtkPEMTableReader::SetFileName(const std::string& fileName)
{
  if (this->FileName != fileName)
  {
    this->FileName = fileName;
    this->Modified();
  }
}

std::string vtkPEMTableReader::GetFileName() const
{
  return this->FileName;
}

int vtkPEMTableReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (this->FileName.empty())
  {
    vtkErrorMacro("No file name is given: set which table to read.");
    return 0;
  }
  try
  {
    vtkTable::GetData(output, 0)->ShallowCopy(pemesh::ReadCsvFile(this->FileName));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

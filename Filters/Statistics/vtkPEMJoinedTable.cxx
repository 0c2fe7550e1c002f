// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMJoinedTable.h"

#include "PooledTable.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include <exception>

vtkStandardNewMacro(vtkPEMJoinedTable);

//------------------------------------------------------------------------------
vtkPEMJoinedTable::vtkPEMJoinedTable()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkPEMJoinedTable::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMJoinedTable::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* joined = vtkTable::GetData(output, 0);
  joined->ShallowCopy(vtkTable::GetData(input[0], 0));
  try
  {
    pemesh::JoinPerformances(joined, vtkTable::GetData(input[1], 0), this->SourceName);
  }
  catch (const std::exception& error)
  {
    joined->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPEMJoinedTable::SetSourceName(const std::string& name)
{
  if (this->SourceName != name)
  {
    this->SourceName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkPEMJoinedTable::GetSourceName() const
{
  return this->SourceName;
}

//------------------------------------------------------------------------------
void vtkPEMJoinedTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceName: " << this->SourceName << "\n";
}

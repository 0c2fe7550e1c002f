// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPooledTable.h"

#include "PooledTable.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkPEMPooledTable);

//------------------------------------------------------------------------------
int vtkPEMPooledTable::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMPooledTable::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  const int count = input[0]->GetNumberOfInformationObjects();
  if (!this->StudyNames.empty() && static_cast<int>(this->StudyNames.size()) != count)
  {
    vtkErrorMacro(<< "There are " << this->StudyNames.size() << " names of studies for " << count
                  << " tables: name every one, or none.");
    return 0;
  }
  std::vector<pemesh::NamedTable> studies;
  for (int i = 0; i < count; ++i)
  {
    studies.emplace_back(this->StudyNames.empty() ? "study-" + std::to_string(i + 1)
                                                  : this->StudyNames[static_cast<std::size_t>(i)],
      vtkTable::GetData(input[0], i));
  }
  vtkTable::GetData(output, 0)->ShallowCopy(pemesh::PoolStudies(studies));
  return 1;
}

//------------------------------------------------------------------------------
void vtkPEMPooledTable::SetStudyNames(const std::vector<std::string>& names)
{
  if (this->StudyNames != names)
  {
    this->StudyNames = names;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkPEMPooledTable::GetStudyNames() const
{
  return this->StudyNames;
}

//------------------------------------------------------------------------------
void vtkPEMPooledTable::AddStudyName(const std::string& name)
{
  this->StudyNames.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPEMPooledTable::RemoveAllStudyNames()
{
  this->SetStudyNames({});
}

//------------------------------------------------------------------------------
void vtkPEMPooledTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StudyNames:";
  for (const std::string& name : this->StudyNames)
  {
    os << " " << name;
  }
  os << "\n";
}

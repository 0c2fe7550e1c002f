// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMCaseLabel.h"

#include "CaseStatus.h"

#include <algorithm>

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkPEMCaseLabel);

void vtkPEMCaseLabel::SetMeshName(const std::string& name)
{
  if (this->MeshName != name)
  {
    this->MeshName = name;
    this->Modified();
  }
}

void vtkPEMCaseLabel::SetParameter(const std::string& name, double value)
{
  this->ChangeParameter(name, value);
}

void vtkPEMCaseLabel::SetTextParameter(const std::string& name, const std::string& value)
{
  this->ChangeParameter(name, value);
}

void vtkPEMCaseLabel::ChangeParameter(const std::string& name, const ParameterValue& value)
{
  const auto found = std::find_if(this->Parameters.begin(), this->Parameters.end(),
    [&](const auto& parameter) { return parameter.first == name; });
  if (found == this->Parameters.end())
  {
    this->Parameters.emplace_back(name, value);
    this->Modified();
  }
  else if (found->second != value)
  {
    found->second = value;
    this->Modified();
  }
}

void vtkPEMCaseLabel::SetFailure(const std::string& status, const std::string& message)
{
  if (this->FailureStatus != status || this->FailureMessage != message)
  {
    this->FailureStatus = status;
    this->FailureMessage = message;
    this->Modified();
  }
}

void vtkPEMCaseLabel::RemoveAllParameters()
{
  if (!this->Parameters.empty())
  {
    this->Parameters.clear();
    this->Modified();
  }
}

int vtkPEMCaseLabel::RequestData(
  vtkInformation* vtkNotUsed(request), vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(vtkPolyData::GetData(inputs[0]));
  if (!this->MeshName.empty())
  {
    pemesh::SetFieldText(output, pemesh::MeshNameField, this->MeshName);
  }
  for (const auto& [name, value] : this->Parameters)
  {
    if (const double* number = std::get_if<double>(&value))
    {
      pemesh::SetFieldNumber(output, name, *number);
    }
    else
    {
      pemesh::SetFieldText(output, name, std::get<std::string>(value));
    }
    pemesh::AddToFieldList(output, pemesh::ParametersList, name);
  }
  if (!this->FailureStatus.empty() && !pemesh::IsCaseFailed(output))
  {
    vtkNew<vtkFieldData> fields; // a copy: Initialize() empties those of the mesh
    fields->ShallowCopy(output->GetFieldData());
    output->Initialize();
    output->SetFieldData(fields);
    pemesh::SetCaseFailed(output, this->FailureStatus, this->FailureMessage);
  }
  return 1;
}

void vtkPEMCaseLabel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshName: " << this->MeshName << "\n";
  os << indent << "Failure: " << this->FailureStatus << " " << this->FailureMessage << "\n";
  for (const auto& [name, value] : this->Parameters)
  {
    os << indent << "Parameter " << name << ": ";
    std::visit([&os](const auto& shown) { os << shown; }, value);
    os << "\n";
  }
}

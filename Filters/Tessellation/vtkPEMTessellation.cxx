// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTessellation.h"

#include "CaseStatus.h"
#include "MeshConversion.h"
#include "NumberText.h"
#include "Progress.h"
#include "Tessellations.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkPEMTessellation);

struct vtkPEMTessellation::ParametersOfKinds
{
  std::vector<pemesh::ParameterValues> Values; ///< a kind each
};

namespace
{

constexpr const char* KindField = "Tessellation";

void WriteMesh(const pemesh::PolygonMesh& mesh, vtkPolyData* output)
{
  constexpr int NoSource = -1;
  pemesh::SetPolygonMesh(output, mesh);
  pemesh::CopyProvenance(
    nullptr, std::vector<int>(static_cast<std::size_t>(mesh.NumberOfElements()), NoSource), output);
}

void WriteResult(const pemesh::TessellationResult& result, vtkPolyData* output)
{
  switch (result.Status)
  {
    case pemesh::TessellationStatus::Done:
      WriteMesh(result.Mesh, output);
      break;
    case pemesh::TessellationStatus::Failed:
      pemesh::SetCaseFailed(output, "tessellation-failed", result.Message);
      break;
    case pemesh::TessellationStatus::TooManyElements:
      pemesh::SetCaseFailed(output, "too-many-elements", result.Message);
      break;
    case pemesh::TessellationStatus::Stopped: // by the caller, who does not want the output
      output->Initialize();
      break;
  }
}

} // namespace

vtkPEMTessellation::vtkPEMTessellation()
  : Parameters(new ParametersOfKinds)
{
  for (const pemesh::Tessellation& kind : pemesh::Tessellations())
  {
    this->Parameters->Values.emplace_back(kind.Parameters);
  }
}

vtkPEMTessellation::~vtkPEMTessellation()
{
  delete this->Parameters;
}

void vtkPEMTessellation::SetKindByName(const std::string& name)
{
  const int kind = pemesh::FindTessellation(name);
  if (kind < 0)
  {
    vtkErrorMacro(<< "There is no tessellation \"" << name << "\"; did you mean \""
                  << pemesh::NearestWord(name, this->GetKindNames()) << "\"?");
  }
  else if (kind != this->Kind)
  {
    this->Kind = kind;
    this->Modified();
  }
}

std::string vtkPEMTessellation::GetKindName() const
{
  return pemesh::Tessellations()[this->Kind].Name;
}

std::vector<std::string> vtkPEMTessellation::GetKindNames() const
{
  std::vector<std::string> names;
  for (const pemesh::Tessellation& kind : pemesh::Tessellations())
  {
    names.emplace_back(kind.Name);
  }
  return names;
}

void vtkPEMTessellation::SetParameter(const std::string& name, double value)
{
  pemesh::ParameterValues changed = this->Parameters->Values[this->Kind];
  const std::string why = changed.Set(name, value);
  if (!why.empty())
  {
    vtkErrorMacro(<< "Tessellation \"" << this->GetKindName() << "\": " << why);
  }
  else if (!(changed == this->Parameters->Values[this->Kind]))
  {
    this->Parameters->Values[this->Kind] = changed;
    this->Modified();
  }
}

double vtkPEMTessellation::GetParameter(const std::string& name)
{
  const double value = this->Parameters->Values[this->Kind].Get(name);
  if (std::isnan(value))
  {
    vtkErrorMacro(<< "Tessellation \"" << this->GetKindName() << "\" has no parameter \"" << name
                  << "\".");
  }
  return value;
}

std::vector<std::string> vtkPEMTessellation::GetParameterNames() const
{
  std::vector<std::string> names;
  for (const pemesh::Parameter& parameter : this->Parameters->Values[this->Kind].GetParameters())
  {
    names.emplace_back(parameter.Name);
  }
  return names;
}

int vtkPEMTessellation::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, information);
}

int vtkPEMTessellation::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input && pemesh::IsCaseFailed(input))
  {
    output->ShallowCopy(input);
    return 1;
  }
  if (input)
  {
    output->GetFieldData()->PassData(input->GetFieldData());
  }
  const pemesh::ParameterValues& values = this->Parameters->Values[this->Kind];
  pemesh::SetFieldText(output, KindField, this->GetKindName());
  for (const pemesh::Parameter& parameter : values.GetParameters())
  {
    pemesh::SetFieldNumber(output, parameter.Name, values.Get(parameter.Name));
  }
  pemesh::TessellationInput task;
  const std::string fault = pemesh::ToDomain(input, task.Region);
  if (!fault.empty())
  {
    pemesh::SetCaseFailed(output, "invalid-domain", fault);
    return 1;
  }
  task.Values = values;
  task.MaximumElements = static_cast<double>(this->MaximumNumberOfElements);
  task.Progress = [this](double done) { return pemesh::ReportProgress(this, done); };
  WriteResult(pemesh::MakeTessellation(pemesh::Tessellations()[this->Kind], task), output);
  return 1;
}

void vtkPEMTessellation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindName() << "\n";
  for (const std::string& name : this->GetParameterNames())
  {
    os << indent << name << ": " << this->GetParameter(name) << "\n";
  }
  os << indent << "MaximumNumberOfElements: " << this->MaximumNumberOfElements << "\n";
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMAgglomerate.h"

#include "Agglomeration.h"
#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MeshConversion.h"
#include "MetricRegistry.h"
#include "Progress.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkPEMAgglomerate);

struct vtkPEMAgglomerate::Internals
{
  const pemesh::AgglomerationRule* Rule = &pemesh::AgglomerationRules().front();
  pemesh::ParameterValues Parameters = pemesh::ParameterValues(Rule->Parameters);
  std::string Metric;
};

namespace
{

std::vector<bool> FindPlaced(vtkPolyData* input)
{
  std::vector<bool> placed(static_cast<std::size_t>(input->GetNumberOfPolys()), false);
  vtkDataArray* ids = input->GetCellData()->GetArray(pemesh::PolygonIdArray);
  for (std::size_t i = 0; ids && i < placed.size(); ++i)
  {
    placed[i] = ids->GetTuple1(static_cast<vtkIdType>(i)) >= 0.0;
  }
  return placed;
}

int CountUsedPoints(const pemesh::PolygonMesh& mesh)
{
  std::vector<bool> used(mesh.Points.size(), false);
  int count = 0;
  for (const int vertex : mesh.Vertices)
  {
    count += used[vertex] ? 0 : 1;
    used[vertex] = true;
  }
  return count;
}

/** Of each new element the only old one it is made of, or -1 if it was merged. */
std::vector<int> FindSources(const std::vector<int>& group, int elements)
{
  constexpr int Unknown = -2;
  std::vector<int> sources(static_cast<std::size_t>(elements), Unknown);
  for (int old = 0; old < static_cast<int>(group.size()); ++old)
  {
    int& source = sources[group[old]];
    source = source == Unknown ? old : -1;
  }
  return sources;
}

void WriteResult(vtkPolyData* input, const pemesh::PolygonMesh& before,
  const pemesh::AgglomerationResult& result, vtkPolyData* output)
{
  pemesh::SetPolygonMesh(output, result.Mesh);
  pemesh::CopyProvenance(input, FindSources(result.Group, result.Mesh.NumberOfElements()), output);
  pemesh::SetFieldNumber(output, "ElementsBefore", before.NumberOfElements());
  pemesh::SetFieldNumber(output, "VerticesBefore", CountUsedPoints(before));
  pemesh::SetFieldNumber(output, "MovedArea", result.MovedArea);
}

} // namespace

vtkPEMAgglomerate::vtkPEMAgglomerate()
  : Internal(std::make_unique<Internals>())
{
}

vtkPEMAgglomerate::~vtkPEMAgglomerate() = default;

void vtkPEMAgglomerate::SetRuleByName(const std::string& name)
{
  const pemesh::AgglomerationRule* rule = pemesh::FindAgglomerationRule(name);
  if (!rule)
  {
    vtkErrorMacro(<< pemesh::DescribeUnknownAgglomerationRule(name));
    return;
  }
  if (rule != this->Internal->Rule)
  {
    this->Internal->Rule = rule;
    this->Internal->Parameters = pemesh::ParameterValues(rule->Parameters);
    this->Modified();
  }
}

std::string vtkPEMAgglomerate::GetRuleName() const
{
  return this->Internal->Rule->Name;
}

std::vector<std::string> vtkPEMAgglomerate::GetAvailableRules()
{
  std::vector<std::string> names;
  for (const pemesh::AgglomerationRule& rule : pemesh::AgglomerationRules())
  {
    names.emplace_back(rule.Name);
  }
  return names;
}

void vtkPEMAgglomerate::SetParameter(const std::string& name, double value)
{
  pemesh::ParameterValues changed = this->Internal->Parameters;
  const std::string problem = changed.Set(name, value);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "Agglomeration rule " << this->GetRuleName() << ": " << problem);
    return;
  }
  if (!(changed == this->Internal->Parameters))
  {
    this->Internal->Parameters = std::move(changed);
    this->Modified();
  }
}

double vtkPEMAgglomerate::GetParameter(const std::string& name) const
{
  return this->Internal->Parameters.Get(name);
}

std::vector<std::string> vtkPEMAgglomerate::GetParameterNames() const
{
  std::vector<std::string> names;
  for (const pemesh::Parameter& parameter : this->Internal->Rule->Parameters)
  {
    names.emplace_back(parameter.Name);
  }
  return names;
}

void vtkPEMAgglomerate::SetMetric(const std::string& name)
{
  if (!name.empty() && !pemesh::FindElementMetric(name))
  {
    vtkErrorMacro(<< pemesh::DescribeUnknownMetric(name));
    return;
  }
  if (name != this->Internal->Metric)
  {
    this->Internal->Metric = name;
    this->Modified();
  }
}

std::string vtkPEMAgglomerate::GetMetric() const
{
  return this->Internal->Metric;
}

int vtkPEMAgglomerate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (pemesh::IsCaseFailed(input))
  {
    output->ShallowCopy(input);
    return 1;
  }
  const std::string unusable = pemesh::ElementAccess::WhyUnusable(input);
  if (!unusable.empty())
  {
    output->ShallowCopy(input);
    pemesh::SetCaseFailed(
      output, "not-agglomerable", "The mesh cannot be agglomerated: " + unusable + ".");
    return 1;
  }
  pemesh::AgglomerationOptions options(*this->Internal->Rule);
  options.Parameters = this->Internal->Parameters;
  if (!this->Internal->Metric.empty())
  {
    options.Metric = pemesh::FindElementMetric(this->Internal->Metric);
  }
  options.TargetElements = this->TargetNumberOfElements;
  options.TargetPercentage = this->TargetPercentage;
  options.Placed = FindPlaced(input);
  options.KeepPlaced = this->KeepPolygons;
  options.StraightVertices = static_cast<pemesh::StraightVertices>(this->StraightVertices);
  const pemesh::PolygonMesh mesh = pemesh::ToPolygonMesh(input);
  const pemesh::AgglomerationResult result = pemesh::Agglomerate(
    mesh, options, [this](double fraction) { return pemesh::ReportProgress(this, fraction); });
  switch (result.Status)
  {
    case pemesh::AgglomerationStatus::Misconfigured:
      vtkErrorMacro(<< result.Message);
      return 0;
    case pemesh::AgglomerationStatus::NotAgglomerable:
      output->ShallowCopy(input);
      pemesh::SetCaseFailed(output, "not-agglomerable", result.Message);
      return 1;
    case pemesh::AgglomerationStatus::Stopped:
      return 1; // by the caller, who does not want the output
    case pemesh::AgglomerationStatus::Done:
      break;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  WriteResult(input, mesh, result, output);
  return 1;
}

void vtkPEMAgglomerate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rule: " << this->GetRuleName() << "\n";
  for (const std::string& name : this->GetParameterNames())
  {
    os << indent << "Parameter " << name << ": " << this->GetParameter(name) << "\n";
  }
  os << indent << "Metric: " << this->GetMetric() << "\n";
  os << indent << "TargetNumberOfElements: " << this->TargetNumberOfElements << "\n";
  os << indent << "TargetPercentage: " << this->TargetPercentage << "\n";
  os << indent << "KeepPolygons: " << this->KeepPolygons << "\n";
  os << indent << "StraightVertices: " << this->StraightVertices << "\n";
}

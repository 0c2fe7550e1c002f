// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetrics.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MeshMeasurer.h"
#include "MetricSelection.h"
#include "Progress.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMMetrics);

namespace
{

using pemesh::ElementCondition;

std::string DescribeCondition(
  const std::vector<ElementCondition>& conditions, ElementCondition which, const char* what)
{
  const auto count = std::count(conditions.begin(), conditions.end(), which);
  if (count == 0)
  {
    return {};
  }
  const auto first = std::find(conditions.begin(), conditions.end(), which) - conditions.begin();
  return std::to_string(count) + " of " + std::to_string(conditions.size()) + " elements " + what +
    " (the first is element " + std::to_string(first) + ")";
}

/** The names, and the metrics of which the mesh brings an array: it may have been moved since. */
std::vector<std::string> WithThoseOf(vtkPolyData* mesh, std::vector<std::string> names)
{
  for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
  {
    const char* name = mesh->GetCellData()->GetArrayName(i);
    const pemesh::Metric* metric = name ? pemesh::FindMetric(name) : nullptr;
    if (metric && std::string_view(metric->Name) == name)
    {
      names.emplace_back(name);
    }
  }
  return names;
}

} // namespace

vtkPEMMetrics::vtkPEMMetrics()
  : Metrics(pemesh::MetricNames())
{
}

vtkPEMMetrics::~vtkPEMMetrics() = default;

void vtkPEMMetrics::SetMetrics(const std::vector<std::string>& names)
{
  const pemesh::NamesTaken taken = pemesh::TakeMetricNames(this->Metrics, names);
  if (!taken.Fault.empty())
  {
    vtkErrorMacro(<< taken.Fault);
  }
  else if (taken.IsChange)
  {
    this->Modified();
  }
}

void vtkPEMMetrics::AddMetric(const std::string& name)
{
  std::vector<std::string> names = this->Metrics;
  names.push_back(name);
  this->SetMetrics(names);
}

void vtkPEMMetrics::RemoveAllMetrics()
{
  this->SetMetrics({});
}

void vtkPEMMetrics::SelectAllMetrics()
{
  this->SetMetrics(pemesh::MetricNames());
}

std::vector<std::string> vtkPEMMetrics::GetMetrics() const
{
  return this->Metrics;
}

std::vector<std::string> vtkPEMMetrics::GetAvailableMetrics()
{
  return pemesh::MetricNames();
}

int vtkPEMMetrics::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);
  if (pemesh::IsCaseFailed(input))
  {
    return 1;
  }
  const std::string problem = pemesh::ElementAccess::WhyUnusable(output);
  if (!problem.empty())
  {
    pemesh::SetCaseFailed(output, "unusable-mesh", "The mesh cannot be measured: " + problem + ".");
    return 1;
  }
  std::vector<pemesh::MetricColumn> columns;
  for (const pemesh::Metric* metric : pemesh::SelectMetrics(WithThoseOf(input, this->Metrics)))
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(metric->Name);
    array->SetNumberOfValues(output->GetNumberOfPolys());
    columns.push_back({ metric, array->GetPointer(0) });
    output->GetCellData()->AddArray(array);
  }
  pemesh::MeshMeasurer measurer(output);
  try
  {
    if (!measurer.Measure(
          columns, [this](double done) { return pemesh::ReportProgress(this, done); }))
    {
      output->Initialize();
      return 1;
    }
  }
  catch (const std::length_error& error)
  {
    output->ShallowCopy(input);
    pemesh::SetCaseFailed(
      output, "mesh-too-large", "Neighbours cannot be found: " + std::string(error.what()));
    return 1;
  }
  this->WarnOfElements(measurer.GetConditions());
  return 1;
}

void vtkPEMMetrics::WarnOfElements(const std::vector<ElementCondition>& conditions)
{
  const std::string degenerate = DescribeCondition(conditions, ElementCondition::Degenerate,
    "cannot be measured and have NaN: fewer than three distinct vertices, no area, edges that "
    "cross or run along each other, or coordinates that are not finite");
  const std::string repeated =
    DescribeCondition(conditions, ElementCondition::Repeated, "repeat a vertex, which was ignored");
  if (!degenerate.empty() || !repeated.empty())
  {
    vtkWarningMacro(<< degenerate << (degenerate.empty() || repeated.empty() ? "" : "; ")
                    << repeated << ".");
  }
}

void vtkPEMMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metrics:";
  for (const std::string& name : this->Metrics)
  {
    os << ' ' << name;
  }
  os << '\n';
}

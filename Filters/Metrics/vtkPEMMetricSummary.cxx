// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"

#include "CaseStatus.h"
#include "ElementSelection.h"
#include "MeshMetrics.h"
#include "MeshValues.h"
#include "MetricSelection.h"
#include "Progress.h"
#include "SummaryColumns.h"
#include "ValueStatistics.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>

vtkStandardNewMacro(vtkPEMMetricSummary);

namespace
{

/** Whether each element is of the selection; empty if the mesh has no values to select by. */
std::vector<unsigned char> FindSelected(
  const pemesh::MeshValues& values, const pemesh::ElementSelection& selection)
{
  std::vector<unsigned char> selected;
  for (const double value : values.Get(selection.Array))
  {
    selected.push_back(selection.Contains(value) ? 1 : 0);
  }
  return selected;
}

} // namespace

vtkPEMMetricSummary::vtkPEMMetricSummary()
  : Metrics(pemesh::MetricNames())
{
}

vtkPEMMetricSummary::~vtkPEMMetricSummary() = default;

void vtkPEMMetricSummary::Report(const pemesh::NamesTaken& taken)
{
  if (!taken.Fault.empty())
  {
    vtkErrorMacro(<< taken.Fault);
  }
  else if (taken.IsChange)
  {
    this->Modified();
  }
}

void vtkPEMMetricSummary::SetMetrics(const std::vector<std::string>& names)
{
  this->Report(pemesh::TakeMetricNames(this->Metrics, names));
}

void vtkPEMMetricSummary::SetMeshMetrics(const std::vector<std::string>& names)
{
  this->Report(pemesh::TakeNames(this->MeshMetrics, names, pemesh::MeshMetricChoices()));
}

std::vector<std::string> vtkPEMMetricSummary::GetMeshMetrics() const
{
  return pemesh::SelectMeshMetrics(this->MeshMetrics, this->Metrics);
}

void vtkPEMMetricSummary::SetStatistics(const std::vector<std::string>& names)
{
  this->Report(pemesh::TakeNames(this->Statistics, names, pemesh::StatisticChoices()));
}

void vtkPEMMetricSummary::SetGroups(const std::vector<std::string>& names)
{
  this->Report(pemesh::TakeNames(this->Groups, names, pemesh::ElementGroupChoices()));
}

void vtkPEMMetricSummary::SetQuantiles(const std::vector<double>& fractions)
{
  const bool areGood = std::ranges::all_of(
    fractions, [](double fraction) { return fraction >= 0.0 && fraction <= 1.0; });
  if (!areGood)
  {
    vtkErrorMacro(<< "A quantile has to be between 0 and 1.");
  }
  else if (fractions != this->Quantiles)
  {
    this->Quantiles = fractions;
    this->Modified();
  }
}

void vtkPEMMetricSummary::SetHistogramBins(int bins)
{
  const int most = pemesh::MostHistogramBins;
  const int clamped = std::clamp(bins, 0, most);
  if (clamped != this->HistogramBins)
  {
    this->HistogramBins = clamped;
    this->Modified();
  }
}

void vtkPEMMetricSummary::SetSelection(const std::string& text)
{
  std::string fault;
  pemesh::ParseElementSelection(text, fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
  }
  else if (text != this->Selection)
  {
    this->Selection = text;
    this->Modified();
  }
}

void vtkPEMMetricSummary::AddMetric(const std::string& name)
{
  std::vector<std::string> names = this->Metrics;
  names.push_back(name);
  this->SetMetrics(names);
}

void vtkPEMMetricSummary::RemoveAllMetrics()
{
  this->SetMetrics({});
}

void vtkPEMMetricSummary::SelectAllMetrics()
{
  this->SetMetrics(pemesh::MetricNames());
}

std::vector<std::string> vtkPEMMetricSummary::GetMetrics() const
{
  return this->Metrics;
}

int vtkPEMMetricSummary::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkPEMMetricSummary::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkTable* table = vtkTable::GetData(outputVector);
  pemesh::AddText(table, pemesh::MeshNameField, pemesh::GetFieldText(mesh, pemesh::MeshNameField));
  pemesh::AddParameterColumns(table, mesh);
  const std::vector<const pemesh::Metric*> metrics = pemesh::SelectMetrics(this->Metrics);
  const std::vector<std::string> meshMetrics = this->GetMeshMetrics();
  std::string fault;
  const pemesh::ElementSelection selection = pemesh::ParseElementSelection(this->Selection, fault);
  pemesh::MeshValues values(mesh);
  values.Provide(this->FindBaseMetrics(selection.Array));
  pemesh::ReportProgress(this, 0.3);
  const std::vector<unsigned char> selected = FindSelected(values, selection);
  pemesh::SummaryChoice choice;
  choice.Quantiles = this->Quantiles;
  choice.Bins = this->HistogramBins;
  for (const std::string& name : this->Statistics)
  {
    choice.Statistics.push_back(pemesh::FindStatistic(name));
  }
  for (const std::string& name : this->Groups)
  {
    const pemesh::ElementGroup* group = pemesh::FindElementGroup(name);
    choice.Groups.push_back(group);
    choice.Members.push_back(
      *group->Suffix ? pemesh::FindMembers(mesh, *group, selected) : std::vector<unsigned char>{});
  }
  choice.Areas = values.Get("Area");
  pemesh::AddMeshColumns(table, mesh, values, meshMetrics, metrics);
  pemesh::ReportProgress(this, 0.6);
  pemesh::AddMetricColumns(table, mesh, values, metrics, choice);
  pemesh::AddOtherFieldColumns(table, mesh);
  const bool isMissing = !selection.Array.empty() && selected.empty() &&
    mesh->GetNumberOfPolys() > 0 && !pemesh::IsCaseFailed(mesh);
  pemesh::AddText(table, "Status", isMissing ? "no-such-array" : pemesh::GetCaseStatus(mesh));
  pemesh::AddText(table, "StatusMessage",
    isMissing ? pemesh::DescribeMissingSelection(selection.Array)
              : pemesh::GetCaseStatusMessage(mesh));
  pemesh::CopyList(table, mesh, pemesh::ParametersList);
  pemesh::CopyList(table, mesh, pemesh::MeasuredList);
  return 1;
}

/** What numbers of the mesh, weights and the selection are made of. */
std::vector<std::string> vtkPEMMetricSummary::FindBaseMetrics(const std::string& selected) const
{
  std::vector<std::string> names;
  if (!selected.empty())
  {
    names.push_back(selected);
  }
  for (const std::string& name : this->GetMeshMetrics())
  {
    const pemesh::MeshMetric& metric = *pemesh::FindMeshMetric(name);
    if (*metric.Base && std::ranges::count(names, metric.Base) == 0)
    {
      names.emplace_back(metric.Base);
    }
  }
  const bool needsArea = std::ranges::count(this->Statistics, "area-mean") > 0;
  if (needsArea && std::ranges::count(names, "Area") == 0)
  {
    names.emplace_back("Area");
  }
  return names;
}

void vtkPEMMetricSummary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto Print = [&](const char* what, const auto& values)
  {
    os << indent << what << ':';
    for (const auto& value : values)
    {
      os << ' ' << value;
    }
    os << '\n';
  };
  Print("Metrics", this->Metrics);
  Print("MeshMetrics", this->GetMeshMetrics());
  Print("Statistics", this->Statistics);
  Print("Groups", this->Groups);
  Print("Quantiles", this->Quantiles);
  os << indent << "HistogramBins: " << this->HistogramBins << '\n';
  os << indent << "Selection: " << this->Selection << '\n';
}

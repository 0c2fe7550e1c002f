// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"

#include "CaseStatus.h"
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
#include <cmath>

vtkStandardNewMacro(vtkPEMMetricSummary);

namespace
{

/** Whether a metric is cheap enough to be measured for a number of the mesh that needs it. */
bool IsCheap(const pemesh::Metric& metric)
{
  constexpr unsigned int Cheap = pemesh::NeedsArea | pemesh::NeedsEdges | pemesh::NeedsDistances;
  return (metric.Needs & ~Cheap) == 0;
}

/** Empty, or a sentence about the first name that is in no entry of a table. */
template <typename Table>
std::string WhyUnknown(const char* what, const std::vector<std::string>& names, const Table& table)
{
  for (const std::string& name : names)
  {
    std::string known;
    bool isKnown = false;
    for (const auto& entry : table)
    {
      known += (known.empty() ? "" : ", ") + std::string(entry.Name);
      isKnown = isKnown || name == entry.Name;
    }
    if (!isKnown)
    {
      return "There is no " + std::string(what) + " \"" + name + "\"; there are " + known + ".";
    }
  }
  return {};
}

} // namespace

vtkPEMMetricSummary::vtkPEMMetricSummary()
  : Metrics(pemesh::MetricNames())
{
}

vtkPEMMetricSummary::~vtkPEMMetricSummary() = default;

std::string vtkPEMMetricSummary::WhyUnknownStatistic(const std::vector<std::string>& names)
{
  return WhyUnknown("statistic", names, pemesh::Statistics());
}

std::string vtkPEMMetricSummary::WhyUnknownGroup(const std::vector<std::string>& names)
{
  return WhyUnknown("group of elements", names, pemesh::ElementGroups());
}

template <typename Value>
void vtkPEMMetricSummary::Change(Value& own, const Value& value, const std::string& problem)
{
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
  else if (own != value)
  {
    own = value;
    this->Modified();
  }
}

void vtkPEMMetricSummary::SetMetrics(const std::vector<std::string>& names)
{
  this->Change(this->Metrics, pemesh::NormalizeMetricNames(names), pemesh::WhyUnknownMetric(names));
}

void vtkPEMMetricSummary::SetMeshMetrics(const std::vector<std::string>& names)
{
  this->Change(this->MeshMetrics, std::optional(names),
    WhyUnknown("metric of a mesh", names, pemesh::MeshMetrics()));
}

void vtkPEMMetricSummary::SelectDefaultMeshMetrics()
{
  this->Change(this->MeshMetrics, std::optional<std::vector<std::string>>{}, {});
}

std::vector<std::string> vtkPEMMetricSummary::GetMeshMetrics() const
{
  if (this->MeshMetrics)
  {
    return *this->MeshMetrics;
  }
  std::vector<std::string> names;
  for (const pemesh::MeshMetric& metric : pemesh::MeshMetrics())
  {
    const pemesh::Metric* base = pemesh::FindMetric(metric.Base);
    if (!base || IsCheap(*base) || std::ranges::count(this->Metrics, metric.Base) > 0)
    {
      names.emplace_back(metric.Name);
    }
  }
  return names;
}

void vtkPEMMetricSummary::SetStatistics(const std::vector<std::string>& names)
{
  this->Change(this->Statistics, names, WhyUnknownStatistic(names));
}

void vtkPEMMetricSummary::SetGroups(const std::vector<std::string>& names)
{
  this->Change(this->Groups, names, WhyUnknownGroup(names));
}

void vtkPEMMetricSummary::SetQuantiles(const std::vector<double>& fractions)
{
  const bool areGood = std::ranges::all_of(
    fractions, [](double fraction) { return fraction >= 0.0 && fraction <= 1.0; });
  this->Change(this->Quantiles, fractions, areGood ? "" : "A quantile has to be between 0 and 1.");
}

void vtkPEMMetricSummary::SetSelectionArray(const std::string& name)
{
  this->Change(this->SelectionArray, name, {});
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
    choice.Members.push_back(*group->Suffix
        ? pemesh::FindMembers(mesh, *group, this->SelectionArray)
        : std::vector<unsigned char>{});
  }
  pemesh::MeshValues values(mesh);
  values.Provide(this->FindBaseMetrics());
  pemesh::ReportProgress(this, 0.3);
  choice.Areas = values.Get("Area");
  pemesh::AddMeshColumns(table, mesh, values, meshMetrics, metrics);
  pemesh::ReportProgress(this, 0.6);
  pemesh::AddMetricColumns(table, mesh, values, metrics, choice);
  pemesh::AddOtherFieldColumns(table, mesh);
  pemesh::AddText(table, "Status", pemesh::GetCaseStatus(mesh));
  pemesh::AddText(table, "StatusMessage", pemesh::GetCaseStatusMessage(mesh));
  pemesh::CopyList(table, mesh, pemesh::ParametersList);
  pemesh::CopyList(table, mesh, pemesh::MeasuredList);
  return 1;
}

/** The metrics of elements without which numbers of the mesh and weights cannot be had. */
std::vector<std::string> vtkPEMMetricSummary::FindBaseMetrics() const
{
  std::vector<std::string> names;
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
  os << indent << "SelectionArray: " << this->SelectionArray << '\n';
}

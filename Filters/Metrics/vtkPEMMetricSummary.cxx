// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"

#include "CaseStatus.h"
#include "MeshMetrics.h"
#include "MeshValues.h"
#include "MetricSelection.h"
#include "ParallelLoop.h"
#include "Progress.h"
#include "ValueStatistics.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <charconv>
#include <cmath>

vtkStandardNewMacro(vtkPEMMetricSummary);

namespace
{

void AddNumber(vtkTable* table, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void AddId(vtkTable* table, const std::string& name, vtkIdType value)
{
  vtkNew<vtkIdTypeArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void AddText(vtkTable* table, const std::string& name, const std::string& value)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

/** A number of the table; ids are whole. */
struct Cell
{
  std::string Column;
  bool IsId;
  double Number;
  vtkIdType Id;
};

Cell MakeNumber(const std::string& column, double number)
{
  return { column, false, number, 0 };
}

Cell MakeId(const std::string& column, vtkIdType id)
{
  return { column, true, 0.0, id };
}

void AddCells(vtkTable* table, const std::vector<Cell>& cells)
{
  for (const Cell& cell : cells)
  {
    cell.IsId ? AddId(table, cell.Column, cell.Id) : AddNumber(table, cell.Column, cell.Number);
  }
}

/** "0.05": the shortest text that is exactly this number. */
std::string ShortText(double number)
{
  char text[32];
  const auto end = std::to_chars(std::begin(text), std::end(text), number).ptr;
  return { std::begin(text), end };
}

/** Elements with an undefined value of one of the metrics. */
vtkIdType CountUndefined(vtkPolyData* mesh, const pemesh::MeshValues& values,
  const std::vector<const pemesh::Metric*>& metrics)
{
  std::vector<char> undefined(static_cast<std::size_t>(mesh->GetNumberOfPolys()), 0);
  for (const pemesh::Metric* metric : metrics)
  {
    const std::span<const double> own = values.Get(metric->Name);
    for (std::size_t i = 0; i < undefined.size(); ++i)
    {
      undefined[i] |= static_cast<char>(own.empty() || !std::isfinite(own[i]));
    }
  }
  return std::ranges::count(undefined, 1);
}

vtkIdType CountTriangles(vtkPolyData* mesh)
{
  vtkIdType count = 0;
  for (vtkIdType element = 0; element < mesh->GetNumberOfPolys(); ++element)
  {
    count += mesh->GetPolys()->GetCellSize(element) == 3 ? 1 : 0;
  }
  return count;
}

void AddMeshColumns(vtkTable* table, vtkPolyData* mesh, pemesh::MeshValues& values,
  const std::vector<std::string>& names, const std::vector<const pemesh::Metric*>& metrics)
{
  pemesh::MeshMeasures measures;
  measures.Elements = mesh->GetNumberOfPolys();
  measures.Vertices = mesh->GetNumberOfPoints();
  measures.Triangles = CountTriangles(mesh);
  measures.Undefined = CountUndefined(mesh, values, metrics);
  for (const std::string& name : names)
  {
    const pemesh::MeshMetric& metric = *pemesh::FindMeshMetric(name);
    measures.Base = values.Get(metric.Base);
    measures.Neighbours = metric.NeedsNeighbours ? values.GetNeighbours() : nullptr;
    const double value = metric.Function(measures);
    metric.IsCount ? AddId(table, name, static_cast<vtkIdType>(value))
                   : AddNumber(table, name, value);
  }
}

/** A field value of the mesh as a column, a number or a text; NaN where there is none. */
void AddFieldColumn(vtkTable* table, vtkPolyData* mesh, const std::string& name)
{
  if (vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name.c_str())))
  {
    AddText(table, name, pemesh::GetFieldText(mesh, name));
  }
  else
  {
    AddNumber(table, name, pemesh::GetFieldNumber(mesh, name));
  }
}

void AddParameterColumns(vtkTable* table, vtkPolyData* mesh)
{
  auto* names =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(pemesh::ParametersList));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    if (!table->GetColumnByName(names->GetValue(i).c_str()))
    {
      AddFieldColumn(table, mesh, names->GetValue(i));
    }
  }
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Provenance and performances: numbers, and what the runs say of themselves. */
void AddOtherFieldColumns(vtkTable* table, vtkPolyData* mesh)
{
  vtkFieldData* fields = mesh->GetFieldData();
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    if (!array->GetName() || array->GetNumberOfValues() != 1 ||
      table->GetColumnByName(array->GetName()))
    {
      continue;
    }
    const std::string name = array->GetName();
    if (vtkDataArray::SafeDownCast(array) || EndsWith(name, "_Status") ||
      EndsWith(name, "_StatusMessage"))
    {
      AddFieldColumn(table, mesh, name);
    }
  }
}

void CopyList(vtkTable* table, vtkPolyData* mesh, const char* list)
{
  if (vtkAbstractArray* names = mesh->GetFieldData()->GetAbstractArray(list))
  {
    table->GetFieldData()->AddArray(names);
  }
}

/** What is told of the values of a metric. */
struct SummaryChoice
{
  std::vector<const pemesh::Statistic*> Statistics;
  std::vector<const pemesh::ElementGroup*> Groups;
  std::vector<std::vector<unsigned char>> Members; // a group each; empty for all elements
  std::vector<double> Quantiles;
  int Bins = 0;
  std::span<const double> Areas;
};

pemesh::ValueSummary SummarizeGroup(std::span<const double> values,
  std::span<const unsigned char> members, vtkIdType elements, const SummaryChoice& choice)
{
  const bool spread = std::ranges::any_of(
    choice.Statistics, [](const pemesh::Statistic* statistic) { return statistic->NeedsSpread; });
  pemesh::ValueSummary summary = pemesh::SummarizeValues(values, members, choice.Areas, spread);
  if (values.empty()) // never measured
  {
    summary.Undefined =
      members.empty() ? elements : static_cast<vtkIdType>(std::ranges::count(members, 1));
  }
  return summary;
}

/** The columns of one metric: each group in turn. */
std::vector<Cell> MakeMetricCells(const std::string& name, std::span<const double> values,
  vtkIdType elements, const SummaryChoice& choice)
{
  std::vector<Cell> cells;
  for (std::size_t g = 0; g < choice.Groups.size(); ++g)
  {
    const std::span<const unsigned char> members = choice.Members[g];
    const std::string suffix = choice.Groups[g]->Suffix;
    const pemesh::ValueSummary summary = SummarizeGroup(values, members, elements, choice);
    for (const pemesh::Statistic* statistic : choice.Statistics)
    {
      cells.push_back(
        MakeNumber(name + "_" + statistic->Suffix + suffix, statistic->Function(summary)));
    }
    for (const pemesh::Statistic* statistic : choice.Statistics)
    {
      if (statistic->Element)
      {
        cells.push_back(MakeId(
          name + "_" + statistic->Suffix + "_element" + suffix, statistic->Element(summary)));
      }
    }
    if (choice.Quantiles.empty() && choice.Bins == 0)
    {
      continue;
    }
    const std::vector<double> sorted = pemesh::SortValues(values, members);
    for (const double fraction : choice.Quantiles)
    {
      cells.push_back(
        MakeNumber(name + "_q" + ShortText(fraction) + suffix, pemesh::Quantile(sorted, fraction)));
    }
    const std::vector<vtkIdType> counts = pemesh::Histogram(sorted, choice.Bins);
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
    {
      cells.push_back(MakeId(name + "_bin" + std::to_string(bin + 1) + suffix, counts[bin]));
    }
  }
  return cells;
}

/** Each metric by itself, so that threads change nothing. */
void AddMetricColumns(vtkTable* table, vtkPolyData* mesh, const pemesh::MeshValues& values,
  const std::vector<const pemesh::Metric*>& metrics, const SummaryChoice& choice)
{
  std::vector<std::vector<Cell>> cells(metrics.size());
  pemesh::ParallelLoop(0, static_cast<vtkIdType>(metrics.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto place = static_cast<std::size_t>(i);
        const char* name = metrics[place]->Name;
        cells[place] = MakeMetricCells(name, values.Get(name), mesh->GetNumberOfPolys(), choice);
      }
    });
  for (const std::vector<Cell>& row : cells)
  {
    AddCells(table, row);
  }
}

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
  AddText(table, pemesh::MeshNameField, pemesh::GetFieldText(mesh, pemesh::MeshNameField));
  AddParameterColumns(table, mesh);
  const std::vector<const pemesh::Metric*> metrics = pemesh::SelectMetrics(this->Metrics);
  const std::vector<std::string> meshMetrics = this->GetMeshMetrics();
  SummaryChoice choice;
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
  AddMeshColumns(table, mesh, values, meshMetrics, metrics);
  pemesh::ReportProgress(this, 0.6);
  AddMetricColumns(table, mesh, values, metrics, choice);
  AddOtherFieldColumns(table, mesh);
  AddText(table, "Status", pemesh::GetCaseStatus(mesh));
  AddText(table, "StatusMessage", pemesh::GetCaseStatusMessage(mesh));
  CopyList(table, mesh, pemesh::ParametersList);
  CopyList(table, mesh, pemesh::MeasuredList);
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SummaryColumns.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MeshMetrics.h"
#include "MeshValues.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "ParallelLoop.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

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

/** Elements with an undefined value of one of the metrics. */
vtkIdType CountUndefined(
  vtkPolyData* mesh, const MeshValues& values, const std::vector<const Metric*>& metrics)
{
  std::vector<char> undefined(static_cast<std::size_t>(mesh->GetNumberOfPolys()), 0);
  for (const Metric* metric : metrics)
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
  ElementAccess access(mesh);
  vtkIdType count = 0;
  for (vtkIdType element = 0; element < mesh->GetNumberOfPolys(); ++element)
  {
    count += access.CountVertices(element) == 3 ? 1 : 0;
  }
  return count;
}

/** A field value of the mesh as a column, a number or a text; NaN where there is none. */
void AddFieldColumn(vtkTable* table, vtkPolyData* mesh, const std::string& name)
{
  if (vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name.c_str())))
  {
    AddText(table, name, GetFieldText(mesh, name));
  }
  else
  {
    AddNumber(table, name, GetFieldNumber(mesh, name));
  }
}

ValueSummary SummarizeGroup(std::span<const double> values, std::span<const unsigned char> members,
  vtkIdType elements, const SummaryChoice& choice)
{
  const bool spread = std::ranges::any_of(
    choice.Statistics, [](const Statistic* statistic) { return statistic->NeedsSpread; });
  ValueSummary summary = SummarizeValues(values, members, choice.Areas, spread);
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
    const ValueSummary summary = SummarizeGroup(values, members, elements, choice);
    for (const Statistic* statistic : choice.Statistics)
    {
      cells.push_back(
        MakeNumber(name + "_" + statistic->Suffix + suffix, statistic->Function(summary)));
    }
    for (const Statistic* statistic : choice.Statistics)
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
    const std::vector<double> sorted = SortValues(values, members);
    for (const double fraction : choice.Quantiles)
    {
      cells.push_back(
        MakeNumber(name + "_q" + FormatNumber(fraction) + suffix, Quantile(sorted, fraction)));
    }
    const std::vector<vtkIdType> counts = Histogram(sorted, choice.Bins);
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
    {
      cells.push_back(MakeId(name + "_bin" + std::to_string(bin + 1) + suffix, counts[bin]));
    }
  }
  return cells;
}

} // namespace

void AddText(vtkTable* table, const std::string& name, const std::string& value)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void AddMeshColumns(vtkTable* table, vtkPolyData* mesh, MeshValues& values,
  const std::vector<std::string>& names, const std::vector<const Metric*>& metrics)
{
  MeshMeasures measures;
  measures.Elements = mesh->GetNumberOfPolys();
  measures.Vertices = mesh->GetNumberOfPoints();
  measures.Triangles = CountTriangles(mesh);
  measures.Undefined = CountUndefined(mesh, values, metrics);
  for (const std::string& name : names)
  {
    const MeshMetric& metric = *FindMeshMetric(name);
    measures.Base = values.Get(metric.Base);
    measures.Neighbours = metric.NeedsNeighbours ? values.GetNeighbours() : nullptr;
    const double value = metric.Function(measures);
    metric.IsCount ? AddId(table, name, static_cast<vtkIdType>(value))
                   : AddNumber(table, name, value);
  }
}

void AddParameterColumns(vtkTable* table, vtkPolyData* mesh)
{
  auto* names =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(ParametersList));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    if (!table->GetColumnByName(names->GetValue(i).c_str()))
    {
      AddFieldColumn(table, mesh, names->GetValue(i));
    }
  }
}

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
    if (vtkDataArray::SafeDownCast(array) || name.ends_with("_Status") ||
      name.ends_with("_StatusMessage"))
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

void AddMetricColumns(vtkTable* table, vtkPolyData* mesh, const MeshValues& values,
  const std::vector<const Metric*>& metrics, const SummaryChoice& choice)
{
  std::vector<std::vector<Cell>> cells(metrics.size());
  ParallelLoop(0, static_cast<vtkIdType>(metrics.size()), 1,
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

} // namespace pemesh

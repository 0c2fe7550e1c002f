// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResultPanels.h"

#include "ChartKinds.h"
#include "ColumnLabels.h"
#include "ColumnRoles.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "PolygonFamilies.h"
#include "Study.h"
#include "vtkPEMChart.h"
#include "vtkPEMMeshView.h"

#include <stdexcept>

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

/** All columns of numbers but the index. */
std::vector<std::string> ColumnsOfNumbers(vtkTable* table)
{
  std::vector<std::string> names = table ? NumericColumns(table) : std::vector<std::string>();
  std::erase_if(names, [](const std::string& n) { return n == "Index" || n == "Element"; });
  return names;
}

/** Whether a name means the smallest, mean and largest value of a metric, each a column. */
bool MeansBand(const ChartKind& kind, const std::string& name, vtkTable* table)
{
  return FindMetric(name) && !kind.OfElements && table && !table->GetColumnByName(name.c_str());
}

void AddOrdinates(vtkPEMChart* chart, const ChartKind& kind, const std::vector<std::string>& names,
  const ColumnLabels& labels)
{
  for (const std::string& name : names)
  {
    // A metric by its own name stands for its smallest, mean and largest value.
    if (MeansBand(kind, name, chart->GetTable()))
    {
      chart->AddBand(name + "_min", name + "_max", name + "_mean", labels.Title(name));
    }
    else
    {
      chart->AddYColumn(name, labels.Title(name));
    }
  }
}

/** Titles of the columns that kinds of several plots name by themselves. */
void SetTitles(vtkPEMChart* chart, vtkTable* table, const ColumnLabels& labels)
{
  for (vtkIdType i = 0; table && i < table->GetNumberOfColumns(); ++i)
  {
    const std::string name = table->GetColumnName(i);
    chart->SetColumnTitle(name, labels.Title(name));
  }
}

} // namespace

vtkSmartPointer<vtkPEMChart> MakeResultChart(
  const StudyPlot& plot, vtkTable* results, const ColumnLabels& labels)
{
  auto chart = vtkSmartPointer<vtkPEMChart>::New();
  chart->SetTable(results);
  const ChartKind* kind = FindChartKind(plot.Kind);
  if (!kind)
  {
    throw std::runtime_error("There is no kind of chart \"" + plot.Kind + "\"; the nearest is \"" +
      NearestWord(plot.Kind, ChartKindNames()) + "\".");
  }
  chart->SetKindByName(plot.Kind);
  SetTitles(chart, results, labels);
  chart->SetXColumn(plot.X);
  const std::vector<std::string> names = plot.Y.empty() ? ColumnsOfNumbers(results) : plot.Y;
  AddOrdinates(chart, *kind, names, labels);
  if (names.size() == 1 && kind->UsesX)
  {
    const bool band = MeansBand(*kind, names.front(), results);
    chart->SetYTitle(labels.Title(names.front()) + (band ? ": mean and range" : ""));
    chart->SetShowLegend(plot.Options.count("fit") > 0 || plot.Options.count("group-by") > 0 ||
      plot.Kind == "convergence" || !plot.ColorBy.empty());
  }
  chart->SetLogAxes(plot.Log);
  chart->SetColorColumn(plot.ColorBy);
  for (const auto& [name, value] : plot.Options)
  {
    if (const std::string problem = chart->SetOption(name, value); !problem.empty())
    {
      throw std::runtime_error(problem);
    }
  }
  chart->SetTitle(plot.Title);
  return chart;
}

vtkSmartPointer<vtkPEMMeshView> MakeMeshView(
  vtkPolyData* mesh, const std::string& array, const ColumnLabels& labels)
{
  auto view = vtkSmartPointer<vtkPEMMeshView>::New();
  view->SetMesh(mesh);
  view->SetColorArray(array);
  view->SetColorTitle(labels.Title(array));
  view->SetDiverging(array.ends_with("_Error") || array == "Error");
  if (array == "ElementFamily")
  {
    std::vector<std::string> names;
    for (const PolygonFamily& family : PolygonFamilies())
    {
      names.emplace_back(family.Label);
    }
    view->SetClassLabels(names);
  }
  return view;
}

} // namespace pemesh

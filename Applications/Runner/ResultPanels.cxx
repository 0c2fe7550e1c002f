// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResultPanels.h"

#include "ColumnLabels.h"
#include "MetricRegistry.h"
#include "PolygonFamilies.h"
#include "Study.h"
#include "vtkPEMChart.h"
#include "vtkPEMMeshView.h"

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

void AddOrdinates(
  vtkPEMChart* chart, const std::vector<std::string>& names, const ColumnLabels& labels)
{
  for (const std::string& name : names)
  {
    // A metric by its own name stands for its smallest, mean and largest value.
    if (FindMetric(name))
    {
      chart->AddBand(name + "_min", name + "_max", name + "_mean", labels.Title(name));
    }
    else
    {
      chart->AddYColumn(name, labels.Title(name));
    }
  }
}

} // namespace

vtkSmartPointer<vtkPEMChart> MakeResultChart(
  const StudyPlot& plot, vtkTable* results, const ColumnLabels& labels)
{
  auto chart = vtkSmartPointer<vtkPEMChart>::New();
  chart->SetTable(results);
  chart->SetKindByName(plot.Kind == "line" ? "line" : "scatter");
  chart->SetXColumn(plot.X);
  chart->SetXTitle(labels.Title(plot.X));
  AddOrdinates(chart, plot.Y, labels);
  if (plot.Y.size() == 1)
  {
    const bool band = FindMetric(plot.Y.front()) != nullptr;
    chart->SetYTitle(labels.Title(plot.Y.front()) + (band ? ": mean and range" : ""));
    chart->ShowLegendOff();
  }
  else
  {
    chart->SetYTitle(" "); // the legend says it
  }
  chart->SetLogAxes(plot.Log);
  if (!plot.ColorBy.empty())
  {
    chart->SetColorColumn(plot.ColorBy);
    chart->SetColorTitle(labels.Title(plot.ColorBy));
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolutionPanels.h"

#include "ArrayValues.h"
#include "ColumnLabels.h"
#include "GeometryPanels.h"
#include "ResultPanels.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "vtkPEMChart.h"
#include "vtkPEMMeshView.h"

#include <cmath>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

/** A view of the first array of that name: of the points, or else of the cells. */
vtkSmartPointer<vtkPEMMeshView> MakeFieldView(const MeshPicturePointer& picture,
  const std::string& array, const std::string& title, const ColumnLabels& labels)
{
  vtkPolyData* mesh = picture->GetMesh();
  if (!mesh->GetPointData()->GetArray(array.c_str()) &&
    !mesh->GetCellData()->GetArray(array.c_str()))
  {
    return nullptr;
  }
  vtkSmartPointer<vtkPEMMeshView> view = MakeMeshView(mesh, array, labels);
  view->SetTitle(title);
  return view;
}

/** The solution and the truth have one scale, so that they can be compared. */
void ShareRange(vtkPolyData* mesh, const std::string& run, vtkPEMMeshView* a, vtkPEMMeshView* b)
{
  double range[2] = { INFINITY, -INFINITY };
  for (const char* name : { "_Solution", "_GroundTruth" })
  {
    ExtendRange(mesh->GetPointData()->GetArray((run + name).c_str()), range);
  }
  if (a && b && range[0] < range[1])
  {
    a->SetColorRange(range);
    b->SetColorRange(range);
  }
}

/** The performances that a run was described to have; none if the description has gone since. */
std::vector<SolverPerformance> PerformancesOf(const Study& study, const std::string& run)
{
  for (const StudySolver& solver : study.Solvers)
  {
    try
    {
      if (solver.Name == run)
      {
        return FindSolver(solver.Solver, study.Folder).Performances;
      }
    }
    catch (const std::exception&)
    {
    }
  }
  return {};
}

} // namespace

PanelList MakeSolutionPanels(const MeshPicturePointer& picture, const std::string& run,
  const std::string& metric, const ColumnLabels& labels)
{
  const auto solution = MakeFieldView(picture, run + "_Solution", "Solution", labels);
  const auto truth = MakeFieldView(picture, run + "_GroundTruth", "Ground truth", labels);
  ShareRange(picture->GetMesh(), run, solution, truth);
  PanelList panels;
  for (const auto& view :
    { solution, truth, MakeFieldView(picture, run + "_Error", "Error", labels),
      MakeFieldView(picture, run + "_ErrorL2", "Error of each element", labels),
      MakeFieldView(picture, metric, metric, labels) })
  {
    if (view)
    {
      panels.emplace_back(view);
    }
  }
  return panels;
}

PanelList MakePerformancePanels(
  const Study& study, const std::string& run, vtkTable* results, const ColumnLabels& labels)
{
  PanelList panels;
  for (const SolverPerformance& performance : PerformancesOf(study, run))
  {
    const std::string column = run + "_" + performance.Name;
    if (results->GetColumnByName(column.c_str()))
    {
      StudyPlot plot;
      plot.Kind = "line";
      plot.X = AbscissaOf(study);
      plot.Y = { column };
      plot.Log = performance.Scale == "log" ? "y" : "";
      panels.emplace_back(MakeResultChart(plot, results, labels));
    }
  }
  return panels;
}

} // namespace pemesh

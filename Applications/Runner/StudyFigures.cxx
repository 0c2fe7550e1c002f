// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFigures.h"

#include "ColumnLabels.h"
#include "ResultPanels.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <algorithm>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

bool ShowsMesh(const StudyPlot& plot)
{
  return plot.Kind == "mesh" || plot.Kind == "overview";
}

/** Which of `count` cases a plot shows, or -1: negative numbers count from the last one. */
int CaseOfPlot(const StudyPlot& plot, int count)
{
  const int index = plot.Case < 0 ? count + plot.Case : plot.Case;
  return index >= 0 && index < count ? index : -1;
}

} // namespace

StudyFigures::StudyFigures(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<StudyCase>& cases)
  : TheStudy(study)
  , Solvers(solvers)
  , Cases(cases)
{
}

StudyFigures::~StudyFigures() = default;

bool StudyFigures::Shows(const StudyCase& studyCase) const
{
  const int count = static_cast<int>(this->Cases.size());
  const auto& plots = this->TheStudy.Plots;
  return std::any_of(plots.begin(), plots.end(),
    [&](const StudyPlot& plot)
    { return ShowsMesh(plot) && CaseOfPlot(plot, count) == studyCase.Index; });
}

void StudyFigures::KeepMesh(const StudyCase& studyCase, vtkPolyData* mesh)
{
  if (this->Shows(studyCase))
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(mesh);
    const std::scoped_lock lock(this->Mutex);
    this->Meshes[studyCase.Index] = copy;
  }
}

vtkPolyData* StudyFigures::FindMesh(const StudyPlot& plot) const
{
  const int count = static_cast<int>(this->Cases.size());
  const int index = CaseOfPlot(plot, count);
  if (index < 0)
  {
    throw std::runtime_error("it shows mesh " + std::to_string(plot.Case) + ", and there are " +
      std::to_string(count) + " (0 is the first, -1 the last)");
  }
  const auto found = this->Meshes.find(index);
  if (found == this->Meshes.end())
  {
    throw std::runtime_error("its mesh, " + std::to_string(index) + ", was not made");
  }
  return found->second;
}

std::vector<std::string> StudyFigures::Write(
  const std::filesystem::path& folder, vtkTable* results, std::vector<std::string>& files)
{
  std::vector<std::string> problems;
  for (const StudyPlot& plot : this->TheStudy.Plots)
  {
    try
    {
      this->WriteOne(plot, folder / plot.File, results);
      files.push_back((folder / plot.File).string());
    }
    catch (const std::exception& error)
    {
      problems.push_back("The plot \"" + plot.File + "\" was not made: " + error.what() + ".");
    }
  }
  return problems;
}

void StudyFigures::WriteOne(
  const StudyPlot& plot, const std::filesystem::path& file, vtkTable* results)
{
  const ColumnLabels labels(this->TheStudy, this->Solvers);
  vtkNew<vtkPEMFigure> figure;
  if (plot.Kind == "mesh")
  {
    auto view = MakeMeshView(this->FindMesh(plot), plot.ColorBy, labels);
    view->SetHighlightByName(plot.Highlight);
    view->SetLogColor(!plot.Log.empty());
    view->SetTitle(plot.Title);
    figure->AddPanel(view);
  }
  else if (plot.Kind == "overview")
  {
    this->AddOverview(plot, figure, results, labels);
  }
  else
  {
    figure->AddPanel(MakeResultChart(plot, results, labels));
  }
  for (int i = 0; i < figure->GetNumberOfPanels(); ++i)
  {
    if (const std::string reason = figure->GetPanel(i)->WhyNotDrawable(); !reason.empty())
    {
      throw std::runtime_error(reason);
    }
  }
  std::filesystem::create_directories(file.parent_path());
  if (!figure->Write(file.string()))
  {
    throw std::runtime_error(figure->GetErrorMessage());
  }
}

void StudyFigures::AddOverview(
  const StudyPlot& plot, vtkPEMFigure* figure, vtkTable* results, const ColumnLabels& labels)
{
  vtkPolyData* mesh = this->FindMesh(plot);
  const StudyCase& shown =
    this->Cases[static_cast<std::size_t>(CaseOfPlot(plot, static_cast<int>(this->Cases.size())))];
  const bool generated = mesh->GetCellData()->GetArray("ElementFamily") != nullptr;
  auto families = MakeMeshView(mesh, generated ? "ElementFamily" : "", labels);
  families->SetColorTitle("");
  families->SetTitle("Mesh " + shown.Name);
  figure->AddPanel(families);

  const std::string metric = plot.ColorBy.empty() ? "MinAngle" : plot.ColorBy;
  auto geometry = MakeMeshView(mesh, metric, labels);
  geometry->SetHighlightByName("both");
  geometry->SetTitle("Geometry");
  figure->AddPanel(geometry);

  if (!this->TheStudy.Solvers.empty())
  {
    auto solution = MakeMeshView(mesh, this->TheStudy.Solvers.front().Name + "_Solution", labels);
    solution->SetTitle("Solution");
    figure->AddPanel(solution);
  }
  StudyPlot scatter = plot;
  scatter.Kind = "scatter";
  scatter.ColorBy = HasMeshFiles(this->TheStudy) ? "Index" : "t";
  scatter.Title = "Correlation";
  figure->AddPanel(MakeResultChart(scatter, results, labels));
  figure->SetTitle(plot.Title);
}

} // namespace pemesh

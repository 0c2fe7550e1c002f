// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFigures.h"

#include "ChartKinds.h"
#include "ChartStyle.h"
#include "ChartStyleFile.h"
#include "ColumnLabels.h"
#include "CsvTable.h"
#include "ElementTable.h"
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

bool ShowsElements(const StudyPlot& plot)
{
  const ChartKind* kind = FindChartKind(plot.Kind);
  return kind && kind->OfElements;
}

/** Which of `count` cases a number means, or -1: negative numbers count from the last one. */
int CaseOfNumber(int number, int count)
{
  const int index = number < 0 ? count + number : number;
  return index >= 0 && index < count ? index : -1;
}

/** The numbers of the cases whose meshes a plot shows. */
std::vector<int> NumbersOf(const StudyPlot& plot)
{
  return ShowsMesh(plot) || (ShowsElements(plot) && plot.Cases.empty())
    ? std::vector<int>{ plot.Case }
    : plot.Cases;
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
    {
      const std::vector<int> numbers = NumbersOf(plot);
      return std::any_of(numbers.begin(), numbers.end(),
        [&](int number) { return CaseOfNumber(number, count) == studyCase.Index; });
    });
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

vtkPolyData* StudyFigures::FindMesh(int number) const
{
  const int count = static_cast<int>(this->Cases.size());
  const int index = CaseOfNumber(number, count);
  if (index < 0)
  {
    throw std::runtime_error("it shows mesh " + std::to_string(number) + ", and there are " +
      std::to_string(count) + " (0 is the first, -1 the last)");
  }
  const auto found = this->Meshes.find(index);
  if (found == this->Meshes.end())
  {
    throw std::runtime_error("its mesh, " + std::to_string(index) + ", was not made");
  }
  return found->second;
}

vtkSmartPointer<vtkTable> StudyFigures::MakeElements(const StudyPlot& plot) const
{
  std::vector<std::pair<std::string, vtkPolyData*>> meshes;
  for (const int number : NumbersOf(plot))
  {
    vtkPolyData* mesh = this->FindMesh(number);
    const int index = CaseOfNumber(number, static_cast<int>(this->Cases.size()));
    meshes.emplace_back(this->Cases[static_cast<std::size_t>(index)].Name, mesh);
  }
  return MakeElementTable(meshes);
}

vtkSmartPointer<vtkPEMChart> StudyFigures::MakeChart(
  const StudyPlot& plot, vtkTable* results, const ColumnLabels& labels) const
{
  if (!ShowsElements(plot))
  {
    return MakeResultChart(plot, results, labels);
  }
  StudyPlot asked = plot;
  if (plot.Cases.size() > 1)
  {
    asked.Options.emplace("group-by", "Mesh");
  }
  return MakeResultChart(asked, this->MakeElements(plot), labels);
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
  if (plot.Style != StudyStyle() || this->TheStudy.Style != StudyStyle())
  {
    figure->SetStyle(MakeChartStyle(this->TheStudy.Folder, { this->TheStudy.Style, plot.Style }));
  }
  if (plot.Kind == "mesh")
  {
    auto view = MakeMeshView(this->FindMesh(plot.Case), plot.ColorBy, labels);
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
    const auto chart = this->MakeChart(plot, results, labels);
    figure->AddPanel(chart);
    if (plot.Data)
    {
      std::filesystem::create_directories(file.parent_path());
      WriteCsvFile(std::filesystem::path(file).replace_extension(".csv"), chart->MakeDataTable());
    }
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
  vtkPolyData* mesh = this->FindMesh(plot.Case);
  const StudyCase& shown = this->Cases[static_cast<std::size_t>(
    CaseOfNumber(plot.Case, static_cast<int>(this->Cases.size())))];
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

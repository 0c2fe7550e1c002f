// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * render: mesh files, drawn side by side.
 */
#include "CaseStatus.h"
#include "ColumnLabels.h"
#include "Commands.h"
#include "ElementSelection.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "ResultPanels.h"
#include "Terminal.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMMeshView.h"
#include "vtkPEMMetrics.h"
#include "vtkPEMSelectElements.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pemesh
{

namespace
{

struct RenderArguments
{
  std::vector<std::string> Meshes;
  std::string Output;
  std::string ColorBy;
  std::string Highlight = "none";
  std::string Selection;
  std::string Title;
  std::vector<std::string> Captions;
  bool Log = false;
  int Columns = 0;
  double Width = 0.0; // centimetres; 0: by the number of columns
  double Resolution = 300.0;
};

/** The mesh of a file, with the metrics that it is to show: those of the file may be stale. */
vtkSmartPointer<vtkPolyData> ReadMesh(
  const std::string& file, const std::vector<std::string>& arrays)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  if (IsCaseFailed(mesh))
  {
    throw std::runtime_error(GetCaseStatusMessage(mesh));
  }
  std::vector<std::string> names;
  std::ranges::copy_if(arrays, std::back_inserter(names),
    [](const std::string& name) { return FindMetric(name) != nullptr; });
  if (!names.empty())
  {
    vtkNew<vtkPEMMetrics> metrics;
    metrics->SetInputData(mesh);
    metrics->SetMetrics(names);
    metrics->Update();
    mesh = metrics->GetOutput();
  }
  return mesh;
}

ElementSelection ReadSelection(const std::string& text)
{
  std::string fault;
  ElementSelection selection = ParseElementSelection(text, fault);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  return selection;
}

/** "Framed: 3 of 96 elements, MinAngle from 0.1 to 0.5." */
std::string DescribeMarks(std::size_t marked, vtkIdType all, const ElementSelection& selection)
{
  std::string bounds = " not zero";
  if (selection.HasRange)
  {
    const bool hasFrom = std::isfinite(selection.Minimum);
    const bool hasTo = std::isfinite(selection.Maximum);
    bounds = hasFrom ? " from " + FormatNumber(selection.Minimum) : std::string();
    bounds += hasTo ? (hasFrom ? " to " : " up to ") + FormatNumber(selection.Maximum) : "";
    bounds += !hasTo && hasFrom ? " on" : !hasTo ? " defined" : "";
  }
  return "Framed: " + std::to_string(marked) + " of " + std::to_string(all) +
    (all == 1 ? " element, " : " elements, ") + selection.Array + bounds + ".";
}

/** Frames the elements that are selected. */
void MarkSelection(vtkPEMMeshView* view, const std::string& text, const ElementSelection& selection)
{
  vtkPolyData* mesh = view->GetMesh();
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(mesh);
  filter->SetSelection(text);
  filter->Update();
  vtkPolyData* selected = filter->GetOutput();
  if (IsCaseFailed(selected))
  {
    throw std::runtime_error(DescribeMissingSelection(selection.Array));
  }
  vtkDataArray* ids = selected->GetCellData()->GetArray("OriginalElement");
  std::vector<vtkIdType> elements;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    elements.push_back(static_cast<vtkIdType>(ids->GetComponent(i, 0)));
  }
  view->SetMarkedElements(
    elements, DescribeMarks(elements.size(), mesh->GetNumberOfPolys(), selection));
}

std::string CaptionOf(const RenderArguments& arguments, std::size_t panel)
{
  if (arguments.Meshes.size() == 1 && arguments.Captions.empty())
  {
    return arguments.Title;
  }
  return panel < arguments.Captions.size()
    ? arguments.Captions[panel]
    : std::filesystem::path(arguments.Meshes[panel]).stem().string();
}

int Render(const RenderArguments& arguments)
{
  const std::size_t panels = arguments.Meshes.size();
  if (arguments.Captions.size() > panels)
  {
    throw std::runtime_error("There are more captions (" +
      std::to_string(arguments.Captions.size()) + ") than meshes (" + std::to_string(panels) +
      ").");
  }
  if (arguments.Highlight != "none" && arguments.ColorBy.empty())
  {
    throw std::runtime_error("--highlight " + arguments.Highlight +
      " needs --color-by: name the metric whose extreme elements are meant.");
  }
  const ElementSelection selection = ReadSelection(arguments.Selection);
  const ColumnLabels labels;
  vtkNew<vtkPEMFigure> figure;
  for (std::size_t i = 0; i < panels; ++i)
  {
    const vtkSmartPointer<vtkPolyData> mesh =
      ReadMesh(arguments.Meshes[i], { arguments.ColorBy, selection.Array });
    const auto view = MakeMeshView(mesh, arguments.ColorBy, labels);
    view->SetHighlightByName(arguments.Highlight);
    view->SetLogColor(arguments.Log);
    view->SetTitle(CaptionOf(arguments, i));
    if (const std::string reason = view->WhyNotDrawable(); !reason.empty())
    {
      throw std::runtime_error(arguments.Meshes[i] + ": " + reason);
    }
    if (!selection.Array.empty())
    {
      MarkSelection(view, arguments.Selection, selection);
    }
    figure->AddPanel(view);
  }
  const double columns =
    arguments.Columns > 0 ? arguments.Columns : std::ceil(std::sqrt(static_cast<double>(panels)));
  const double usual = panels == 1 ? 12.0 : std::min(6.0 * columns, 30.0);
  figure->SetColumns(arguments.Columns);
  figure->SetTitle(panels == 1 ? std::string() : arguments.Title);
  figure->SetSizeInCentimeters(arguments.Width > 0.0 ? arguments.Width : usual, 0.0);
  figure->SetDPI(arguments.Resolution);
  if (!figure->Write(arguments.Output))
  {
    return PartFailed; // it has said why
  }
  std::cout << arguments.Output << "\n";
  return AllDone;
}

} // namespace

void AddRenderCommand(CLI::App& program, int& exitCode)
{
  auto draw = std::make_shared<RenderArguments>();
  CLI::App* render = program.add_subcommand("render", "Draw mesh files, several side by side");
  render->add_option("MESH", draw->Meshes, "Mesh files")->required();
  render->add_option("-o,--output", draw->Output, "Figure to write: .png, .svg or .pdf")
    ->required();
  render->add_option("--color-by", draw->ColorBy, "Metric, or array of the file");
  render->add_option("--selection", draw->Selection,
    std::string("Frame and count elements: ") + ElementSelectionForm +
      ", as in MinAngle:0.1:0.5 or MinAngle::0.5, or a cell array that is not zero there");
  render->add_option("--highlight", draw->Highlight, "Mark extreme elements of --color-by")
    ->check(CLI::IsMember({ "none", "min", "max", "both" }));
  render->add_option("--title", draw->Title, "Title above all of it");
  render
    ->add_option("--captions", draw->Captions,
      "Titles of the meshes, with commas (default, if there are several: their names)")
    ->delimiter(',');
  render->add_flag("--log", draw->Log, "Logarithmic colours");
  render->add_option("--columns", draw->Columns, "Meshes in a row (default: as near to a square)")
    ->check(CLI::Range(1, 100));
  render->add_option("--width", draw->Width, "Width in centimetres (default: 12; 6 a column)")
    ->check(CLI::Range(2.0, 200.0));
  render->add_option("--dpi", draw->Resolution, "Pixels an inch of a .png")
    ->capture_default_str()
    ->check(CLI::Range(36.0, 2400.0));
  render->callback([draw, &exitCode] { exitCode = Render(*draw); });
}

} // namespace pemesh

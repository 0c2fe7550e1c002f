// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * metrics and render: mesh files, one after the other.
 */
#include "CaseStatus.h"
#include "ColumnLabels.h"
#include "Commands.h"
#include "CsvTable.h"
#include "MetricRegistry.h"
#include "ResultPanels.h"
#include "TableRows.h"
#include "Terminal.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMMeshView.h"
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

struct MetricsArguments
{
  std::vector<std::string> Meshes;
  std::string Output;
  std::string Cells;
  std::vector<std::string> Only;
};

struct RenderArguments
{
  std::string Mesh;
  std::string Output;
  std::string ColorBy;
  std::string Highlight = "none";
  std::string Title;
  bool Log = false;
  double Width = 12.0;
};

void CheckMetricNames(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (!FindMetric(name))
    {
      throw std::runtime_error(DescribeUnknownMetric(name));
    }
  }
}

/** One row an element: its number, vertices and metrics. */
vtkSmartPointer<vtkTable> MakeCellTable(vtkPolyData* mesh)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkIdTypeArray> element;
  element->SetName("Element");
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    element->InsertNextValue(id);
  }
  table->AddColumn(element);
  for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = mesh->GetCellData()->GetArray(i);
        array && array->GetNumberOfComponents() == 1)
    {
      table->AddColumn(array);
    }
  }
  return table;
}

int Measure(const MetricsArguments& arguments)
{
  CheckMetricNames(arguments.Only);
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileNames(arguments.Meshes);
  vtkNew<vtkPEMMetrics> metrics;
  metrics->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetInputConnection(metrics->GetOutputPort());
  if (!arguments.Only.empty())
  {
    metrics->SetMetrics(arguments.Only);
    summary->SetMetrics(arguments.Only);
  }
  int failures = 0;
  vtkNew<vtkTable> rows;
  for (int i = 0; i < reader->GetNumberOfFileNames(); ++i)
  {
    summary->UpdateTimeStep(i);
    vtkPolyData* mesh = metrics->GetOutput();
    AppendTableRows(rows, summary->GetOutput());
    if (IsCaseFailed(mesh))
    {
      Complain(GetCaseStatusMessage(mesh));
      ++failures;
    }
    else if (!arguments.Cells.empty())
    {
      WriteCsvFile(
        fs::path(arguments.Cells) / (reader->GetMeshName(i) + ".csv"), MakeCellTable(mesh));
    }
  }
  NumberTableRows(rows);
  rows->RemoveColumnByName("StatusMessage");
  if (arguments.Output.empty())
  {
    std::cout << FormatCsv(rows);
  }
  else
  {
    WriteCsvFile(arguments.Output, rows);
  }
  return failures == 0 ? AllDone : PartFailed;
}

bool HasArray(vtkPolyData* mesh, const std::string& name)
{
  return mesh->GetCellData()->HasArray(name.c_str()) ||
    mesh->GetPointData()->HasArray(name.c_str());
}

int Render(const RenderArguments& arguments)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName(arguments.Mesh);
  vtkNew<vtkPEMMetrics> metrics;
  metrics->SetInputConnection(reader->GetOutputPort());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  if (IsCaseFailed(mesh))
  {
    throw std::runtime_error(GetCaseStatusMessage(mesh));
  }
  if (!arguments.ColorBy.empty() && !HasArray(mesh, arguments.ColorBy) &&
    FindMetric(arguments.ColorBy))
  {
    metrics->SetMetrics({ arguments.ColorBy });
    metrics->Update();
    mesh = metrics->GetOutput();
  }
  const auto view = MakeMeshView(mesh, arguments.ColorBy, ColumnLabels());
  view->SetHighlightByName(arguments.Highlight);
  view->SetLogColor(arguments.Log);
  view->SetTitle(arguments.Title);
  if (const std::string reason = view->WhyNotDrawable(); !reason.empty())
  {
    throw std::runtime_error(reason);
  }
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(view);
  figure->SetSizeInCentimeters(arguments.Width, 0.0);
  if (!figure->Write(arguments.Output))
  {
    return PartFailed; // it has said why
  }
  std::cout << arguments.Output << "\n";
  return AllDone;
}

} // namespace

void AddMeshCommands(CLI::App& program, int& exitCode)
{
  auto measure = std::make_shared<MetricsArguments>();
  CLI::App* metrics = program.add_subcommand("metrics", "Measure mesh files: one row a mesh");
  metrics->add_option("MESH", measure->Meshes, "Mesh files")->required();
  metrics->add_option(
    "-o,--output", measure->Output, "Table to write (.csv; default: standard output)");
  metrics->add_option("--cells", measure->Cells, "Folder for a table a mesh, one row an element");
  metrics->add_option("--only", measure->Only, "Names of metrics, with commas (default: all)")
    ->delimiter(',');
  metrics->callback([measure, &exitCode] { exitCode = Measure(*measure); });

  auto draw = std::make_shared<RenderArguments>();
  CLI::App* render = program.add_subcommand("render", "Draw a mesh file");
  render->add_option("MESH", draw->Mesh, "Mesh file")->required();
  render->add_option("-o,--output", draw->Output, "Figure to write: .png, .svg or .pdf")
    ->required();
  render->add_option("--color-by", draw->ColorBy, "Metric, or array of the file");
  render->add_option("--highlight", draw->Highlight, "Mark extreme elements")
    ->check(CLI::IsMember({ "none", "min", "max", "both" }));
  render->add_option("--title", draw->Title, "Title above the mesh");
  render->add_flag("--log", draw->Log, "Logarithmic colours");
  render->add_option("--width", draw->Width, "Width in centimetres")
    ->capture_default_str()
    ->check(CLI::Range(2.0, 200.0));
  render->callback([draw, &exitCode] { exitCode = Render(*draw); });
}

} // namespace pemesh

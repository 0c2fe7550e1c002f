// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * metrics: mesh files, measured one after the other.
 */
#include "CaseStatus.h"
#include "Commands.h"
#include "CsvTable.h"
#include "MetricSelection.h"
#include "TableRows.h"
#include "Terminal.h"
#include "vtkPEMMeshReader.h"
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
  const std::string unknown = WhyUnknownMetric(arguments.Only);
  if (!unknown.empty())
  {
    throw std::runtime_error(unknown);
  }
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

} // namespace

void AddMetricsCommand(CLI::App& program, int& exitCode)
{
  auto measure = std::make_shared<MetricsArguments>();
  CLI::App* metrics = program.add_subcommand("metrics", "Measure mesh files: one row a mesh");
  metrics->add_option("MESH", measure->Meshes, "Mesh files")->required();
  metrics->add_option(
    "-o,--output", measure->Output, "Table to write (.csv; default: standard output)");
  metrics->add_option("--cells", measure->Cells, "Folder for a table a mesh, one row an element");
  metrics
    ->add_option("--only", measure->Only,
      "Names of metrics, with commas, or all, neighbourhood, jumps, solver (default: all)")
    ->delimiter(',');
  metrics->callback([measure, &exitCode] { exitCode = Measure(*measure); });
}

} // namespace pemesh

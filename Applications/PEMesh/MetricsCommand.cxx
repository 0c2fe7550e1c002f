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
  std::vector<std::string> Statistics = { "min", "max", "mean" };
  std::vector<std::string> Groups = { "all" };
  std::vector<double> Quantiles;
  int Bins = 0;
  std::string Selection;
};

void CheckNames(const MetricsArguments& arguments)
{
  for (const std::string& problem : { WhyUnknownMetric(arguments.Only),
         vtkPEMMetricSummary::WhyUnknownStatistic(arguments.Statistics),
         vtkPEMMetricSummary::WhyUnknownGroup(arguments.Groups) })
  {
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
    }
  }
}

void Configure(vtkPEMMetricSummary* summary, const MetricsArguments& arguments)
{
  summary->SetStatistics(arguments.Statistics);
  summary->SetGroups(arguments.Groups);
  summary->SetQuantiles(arguments.Quantiles);
  summary->SetHistogramBins(arguments.Bins);
  summary->SetSelectionArray(arguments.Selection);
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
  CheckNames(arguments);
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
  Configure(summary, arguments);
  reader->ReleaseDataFlagOn();
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
    mesh->ReleaseData(); // so that there is never more than one mesh in memory
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
      "Metrics, with commas, or all, neighbourhood, jumps, solver (default: all)")
    ->delimiter(',');
  metrics
    ->add_option("--statistics", measure->Statistics,
      "Of each metric: min, max, mean, standard-deviation, area-mean, undefined (default: "
      "min,max,mean)")
    ->delimiter(',');
  metrics
    ->add_option("--groups", measure->Groups,
      "Over which elements: all, triangles, polygons, placed, filler, selected (default: all)")
    ->delimiter(',');
  metrics->add_option("--quantiles", measure->Quantiles, "Fractions between 0 and 1, with commas")
    ->delimiter(',')
    ->check(CLI::Range(0.0, 1.0));
  metrics->add_option("--histogram", measure->Bins, "Parts of a histogram of each metric")
    ->check(CLI::Range(0, 10000));
  metrics->add_option(
    "--selection", measure->Selection, "Cell array that is not zero in the group selected");
  metrics->callback([measure, &exitCode] { exitCode = Measure(*measure); });
}

} // namespace pemesh

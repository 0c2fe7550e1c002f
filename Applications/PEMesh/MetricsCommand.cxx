// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * metrics: mesh files, measured one after the other.
 */
#include "CaseStatus.h"
#include "Commands.h"
#include "CsvTable.h"
#include "ElementSelection.h"
#include "MetricSelection.h"
#include "MetricSettings.h"
#include "Study.h"
#include "TableRows.h"
#include "Terminal.h"
#include "ValueStatistics.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkVariant.h>

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
  StudyMetrics Settings;
};

/** Set by an interrupt from the keyboard: what is measured by then is written. */
volatile std::sig_atomic_t IsInterrupted = 0;

void Interrupt(int)
{
  IsInterrupted = 1;
}

/** Throws the sentence about the first choice that is wrong. */
void CheckSettings(const StudyMetrics& settings)
{
  std::string fault;
  ParseElementSelection(settings.Selection, fault);
  const bool asksForSelected = std::ranges::count(settings.Groups, "selected") > 0;
  if (asksForSelected && settings.Selection.empty())
  {
    fault = std::string("The group selected needs --selection: say which elements, as ") +
      ElementSelectionForm + " or by the name of a cell array.";
  }
  else if (!asksForSelected && !settings.Selection.empty() && fault.empty())
  {
    fault = "--selection is of no use without the group selected: add --groups all,selected.";
  }
  for (const std::string& problem :
    { MetricChoices().WhyUnknown(settings.Names), MeshMetricChoices().WhyUnknown(settings.Mesh),
      StatisticChoices().WhyUnknown(settings.Statistics),
      ElementGroupChoices().WhyUnknown(settings.Groups), fault })
  {
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
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

/** Stops a filter at its next sign of progress after an interrupt. */
vtkSmartPointer<vtkCallbackCommand> MakeStopper()
{
  auto stopper = vtkSmartPointer<vtkCallbackCommand>::New();
  stopper->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      if (IsInterrupted)
      {
        static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
      }
    });
  return stopper;
}

void WriteRows(vtkTable* rows, const std::string& output)
{
  NumberTableRows(rows);
  rows->RemoveColumnByName("StatusMessage");
  if (output.empty())
  {
    std::cout << FormatCsv(rows);
  }
  else
  {
    WriteCsvFile(output, rows);
  }
}

std::string TextOfRow(vtkTable* row, const char* column)
{
  return row->GetValueByName(0, column).ToString();
}

/** Reads, measures and summarizes one mesh after the other. */
class FileMeasurer
{
public:
  explicit FileMeasurer(const MetricsArguments& arguments)
    : Cells(arguments.Cells)
  {
    this->Reader->SetFileNames(arguments.Meshes);
    this->Reader->ReleaseDataFlagOn();
    this->Metrics->SetInputConnection(this->Reader->GetOutputPort());
    this->Summary->SetInputConnection(this->Metrics->GetOutputPort());
    ConfigureMetrics(arguments.Settings, this->Metrics, this->Summary);
    const auto stopper = MakeStopper();
    this->Metrics->AddObserver(vtkCommand::ProgressEvent, stopper);
    this->Summary->AddObserver(vtkCommand::ProgressEvent, stopper);
  }

  int GetNumberOfMeshes() { return this->Reader->GetNumberOfFileNames(); }

  /** Appends the row of a mesh; false if it failed, or was interrupted. */
  bool Measure(int place, vtkTable* rows)
  {
    this->Summary->UpdateTimeStep(place);
    if (IsInterrupted)
    {
      return false; // the row may be of half a mesh
    }
    vtkTable* row = this->Summary->GetOutput();
    vtkPolyData* mesh = this->Metrics->GetOutput();
    AppendTableRows(rows, row);
    const bool isGood = TextOfRow(row, "Status") == "ok";
    if (!isGood)
    {
      Complain(TextOfRow(row, "StatusMessage"));
    }
    if (!this->Cells.empty() && !IsCaseFailed(mesh))
    {
      WriteCsvFile(
        fs::path(this->Cells) / (this->Reader->GetMeshName(place) + ".csv"), MakeCellTable(mesh));
    }
    mesh->ReleaseData(); // so that there is never more than one mesh in memory
    return isGood;
  }

private:
  std::string Cells;
  vtkNew<vtkPEMMeshReader> Reader;
  vtkNew<vtkPEMMetrics> Metrics;
  vtkNew<vtkPEMMetricSummary> Summary;
};

int Measure(const MetricsArguments& arguments)
{
  CheckSettings(arguments.Settings);
  FileMeasurer measurer(arguments);
  const int meshes = measurer.GetNumberOfMeshes();
  std::signal(SIGINT, Interrupt);
  std::signal(SIGTERM, Interrupt);
  vtkNew<vtkTable> rows;
  bool isAllGood = true;
  for (int i = 0; i < meshes && !IsInterrupted; ++i)
  {
    isAllGood = measurer.Measure(i, rows) && isAllGood;
  }
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (IsInterrupted)
  {
    Complain("Interrupted: " + std::to_string(rows->GetNumberOfRows()) + " of " +
      std::to_string(meshes) + " meshes were measured; their rows are written.");
    isAllGood = false;
  }
  if (rows->GetNumberOfRows() > 0)
  {
    WriteRows(rows, arguments.Output);
  }
  return isAllGood ? AllDone : PartFailed;
}

/** "min, max, mean" */
std::string Listed(const NameChoices& choices)
{
  std::string text;
  for (const std::string& name : choices.Known)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
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
  StudyMetrics& settings = measure->Settings;
  metrics
    ->add_option("--only", settings.Names,
      "Metrics, with commas, or all, neighbourhood, jumps, solver (default: all)")
    ->delimiter(',');
  metrics
    ->add_option("--mesh", settings.Mesh,
      "Numbers of whole meshes: " + Listed(MeshMetricChoices()) + " (default: usual)")
    ->delimiter(',');
  metrics
    ->add_option("--statistics", settings.Statistics,
      "Of each metric: " + Listed(StatisticChoices()) + " (default: min,max,mean)")
    ->delimiter(',');
  metrics
    ->add_option("--groups", settings.Groups,
      "Over which elements: " + Listed(ElementGroupChoices()) + " (default: all)")
    ->delimiter(',');
  metrics->add_option("--quantiles", settings.Quantiles, "Fractions between 0 and 1, with commas")
    ->delimiter(',')
    ->check(CLI::Range(0.0, 1.0));
  metrics->add_option("--histogram", settings.HistogramBins, "Bins of a histogram of each metric")
    ->check(CLI::Range(0, MostHistogramBins));
  metrics->add_option("--selection", settings.Selection,
    std::string("Elements of the group selected: ") + ElementSelectionForm +
      ", as in MinAngle:0.1:0.5 or MinAngle::0.5, or a cell array that is not zero there");
  metrics->callback([measure, &exitCode] { exitCode = Measure(*measure); });
}

} // namespace pemesh

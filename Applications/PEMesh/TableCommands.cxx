// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * correlate and plot: what is done with a table of results.
 */
#include "ColumnLabels.h"
#include "Commands.h"
#include "CsvTable.h"
#include "NumberText.h"
#include "ResultPanels.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "TableColumns.h"
#include "Terminal.h"
#include "vtkPEMChart.h"
#include "vtkPEMCorrelation.h"
#include "vtkPEMFigure.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

struct CorrelateArguments
{
  std::string Table;
  std::string Output;
  std::vector<std::string> X;
  std::vector<std::string> Y;
  bool Independent = false;
};

struct PlotArguments
{
  std::string Table;
  std::string Output;
  std::string X;
  std::vector<std::string> Y;
  std::string Log;
  std::string Kind = "scatter";
  std::string ColorBy;
  std::string Title;
  double Width = 10.0;
};

int Correlate(const CorrelateArguments& arguments)
{
  const vtkSmartPointer<vtkTable> table = ReadCsvFile(arguments.Table);
  CheckNumericColumns(table, arguments.X);
  CheckNumericColumns(table, arguments.Y);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetXColumns(arguments.X);
  correlation->SetYColumns(arguments.Y);
  correlation->SetIndependentRows(arguments.Independent);
  correlation->Update();
  if (arguments.Output.empty())
  {
    std::cout << FormatCsv(correlation->GetOutput());
  }
  else
  {
    WriteCsvFile(arguments.Output, correlation->GetOutput());
  }
  return AllDone;
}

/** A table alone does not say which runs it holds: those named like a known solver are labelled. */
ColumnLabels LabelsOfKnownSolvers()
{
  Study study;
  std::vector<SolverDescription> descriptions;
  for (const FoundSolver& found : ListSolvers())
  {
    if (found.Error.empty())
    {
      StudySolver run;
      run.Name = found.Description.Name;
      study.Solvers.push_back(run);
      descriptions.push_back(found.Description);
    }
  }
  return { study, descriptions };
}

int Plot(const PlotArguments& arguments)
{
  const vtkSmartPointer<vtkTable> table = ReadCsvFile(arguments.Table);
  StudyPlot plot;
  plot.Kind = arguments.Kind;
  plot.X = arguments.X;
  plot.Y = arguments.Y;
  plot.Log = arguments.Log;
  plot.ColorBy = arguments.ColorBy;
  plot.Title = arguments.Title;
  const auto chart = MakeResultChart(plot, table, LabelsOfKnownSolvers());
  if (const std::string reason = chart->WhyNotDrawable(); !reason.empty())
  {
    throw std::runtime_error(reason);
  }
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  figure->SetSizeInCentimeters(arguments.Width, 0.0);
  if (!figure->Write(arguments.Output))
  {
    return PartFailed; // it has said why
  }
  std::cout << arguments.Output << "\n";
  return AllDone;
}

} // namespace

void AddTableCommands(CLI::App& program, int& exitCode)
{
  auto pairs = std::make_shared<CorrelateArguments>();
  CLI::App* correlate =
    program.add_subcommand("correlate", "Correlate the columns of a table of results");
  correlate->add_option("TABLE", pairs->Table, "Table (.csv), one row a mesh")->required();
  correlate->add_option(
    "-o,--output", pairs->Output, "Table to write (.csv; default: standard output)");
  correlate->add_option("--x", pairs->X, "Columns, with commas (default: all metrics)")
    ->delimiter(',');
  correlate
    ->add_option("--y", pairs->Y, "Columns, with commas (default: all metrics and performances)")
    ->delimiter(',');
  correlate->add_flag(
    "--independent", pairs->Independent, "The meshes do not come from one family: give p-values");
  correlate->callback([pairs, &exitCode] { exitCode = Correlate(*pairs); });

  auto figure = std::make_shared<PlotArguments>();
  CLI::App* plot = program.add_subcommand("plot", "Plot columns of a table of results");
  plot->add_option("TABLE", figure->Table, "Table (.csv), one row a mesh")->required();
  plot->add_option("--x", figure->X, "Column")->required();
  plot->add_option("--y", figure->Y, "Columns, with commas; a metric's name plots min, mean, max")
    ->delimiter(',')
    ->required();
  plot->add_option("-o,--output", figure->Output, "Figure to write: .png, .svg or .pdf")
    ->required();
  plot->add_option("--log", figure->Log, "Logarithmic axes")
    ->check(CLI::IsMember({ "x", "y", "xy" }));
  plot->add_option("--kind", figure->Kind, "Joined points or not")
    ->capture_default_str()
    ->check(CLI::IsMember({ "line", "scatter" }));
  plot->add_option("--color-by", figure->ColorBy, "Column that colours the points");
  plot->add_option("--title", figure->Title, "Title above the plot");
  plot->add_option("--width", figure->Width, "Width in centimetres")
    ->capture_default_str()
    ->check(CLI::Range(2.0, 200.0));
  plot->callback([figure, &exitCode] { exitCode = Plot(*figure); });
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * plot: charts of tables of results and of elements.
 */
#include "ChartKinds.h"
#include "ChartOptions.h"
#include "ChartStyle.h"
#include "ChartStyleFile.h"
#include "ColumnLabels.h"
#include "Commands.h"
#include "CsvTable.h"
#include "ElementTable.h"
#include "ResultPanels.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "Terminal.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

struct PlotArguments
{
  std::vector<std::string> Tables;
  std::string Output;
  StudyPlot Plot;
  std::map<std::string, std::string> Options; // as given; empty where they were not
  std::string StyleFile;
  std::vector<std::string> Settings; // NAME=VALUE
  double Width = 0.0;
  double Height = 0.0;
  double Resolution = 0.0;
};

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

ChartStyle StyleOf(const PlotArguments& arguments)
{
  StudyStyle asked{ arguments.StyleFile, {} };
  for (const std::string& setting : arguments.Settings)
  {
    const std::size_t split = setting.find('=');
    if (split == std::string::npos)
    {
      throw std::runtime_error(
        "--set \"" + setting + "\" must be NAME=VALUE: see pemesh list style.");
    }
    asked.Settings[setting.substr(0, split)] = setting.substr(split + 1);
  }
  ChartStyle style = MakeChartStyle({}, { asked });
  style.Width = arguments.Width > 0.0 ? arguments.Width : style.Width;
  style.Height = arguments.Height > 0.0 ? arguments.Height : style.Height;
  style.Resolution = arguments.Resolution > 0.0 ? arguments.Resolution : style.Resolution;
  return style;
}

/** What is given must be something that the kind knows, and what it needs must be given. */
void CheckArguments(const StudyPlot& plot, const ChartKind& kind)
{
  const std::string name = "The kind " + plot.Kind;
  if (kind.LeastY == 1 && plot.Y.empty() && plot.Kind != "small-multiples")
  {
    throw std::runtime_error(name + " needs --y: " + kind.Columns + ".");
  }
  if (kind.UsesX && plot.X.empty() && plot.Kind != "line" && plot.Kind != "small-multiples" &&
    plot.Kind != "correlation-matrix")
  {
    throw std::runtime_error(name + " needs --x: " + kind.Columns + ".");
  }
  const auto refuse = [&name](bool isGiven, const std::string& option)
  {
    if (isGiven)
    {
      throw std::runtime_error(name + " has no --" + option + ".");
    }
  };
  refuse(!kind.UsesX && !plot.X.empty(), "x");
  refuse(!kind.UsesColor && !plot.ColorBy.empty(), "color-by");
  refuse(!kind.UsesLog && !plot.Log.empty(), "log");
  for (const auto& [option, value] : plot.Options)
  {
    refuse(!HasOption(kind, option), option);
  }
}

vtkSmartPointer<vtkTable> ReadTables(const std::vector<std::string>& files)
{
  std::vector<std::pair<std::string, vtkSmartPointer<vtkTable>>> tables;
  for (const std::string& file : files)
  {
    tables.emplace_back(std::filesystem::path(file).stem().string(), ReadCsvFile(file));
  }
  return StackTables(tables);
}

int Plot(const PlotArguments& arguments)
{
  StudyPlot plot = arguments.Plot;
  for (const auto& [name, value] : arguments.Options)
  {
    if (!value.empty())
    {
      plot.Options[name] = value;
    }
  }
  CheckArguments(plot, *FindChartKind(plot.Kind));
  const ChartStyle style = StyleOf(arguments);
  const vtkSmartPointer<vtkTable> table = ReadTables(arguments.Tables);
  const auto chart = MakeResultChart(plot, table, LabelsOfKnownSolvers());
  if (const std::string reason = chart->WhyNotDrawable(); !reason.empty())
  {
    throw std::runtime_error(reason);
  }
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  figure->SetStyle(style);
  if (!figure->Write(arguments.Output))
  {
    return PartFailed; // it has said why
  }
  std::cout << arguments.Output << "\n";
  if (plot.Data)
  {
    const auto data = std::filesystem::path(arguments.Output).replace_extension(".csv");
    WriteCsvFile(data, chart->MakeDataTable());
    std::cout << data.string() << "\n";
  }
  return AllDone;
}

void AddColumns(CLI::App* plot, PlotArguments& arguments)
{
  plot
    ->add_option("TABLE", arguments.Tables,
      "Tables (.csv), one row a mesh or an element; several are put one below the other")
    ->required();
  plot->add_option("--kind", arguments.Plot.Kind, "Kind of chart: see pemesh list charts")
    ->capture_default_str()
    ->check(CLI::IsMember(ChartKindNames()));
  plot->add_option("--x", arguments.Plot.X, "Column");
  plot
    ->add_option(
      "--y", arguments.Plot.Y, "Columns, with commas; a metric's name plots min, mean, max")
    ->delimiter(',');
  plot->add_option("--log", arguments.Plot.Log, "Logarithmic axes")
    ->check(CLI::IsMember({ "x", "y", "xy" }));
  plot->add_option("--color-by", arguments.Plot.ColorBy, "Column that colours the points");
  for (const SettingField<ChartOptions>& option : ChartOptionFields())
  {
    plot->add_option("--" + option.Name, arguments.Options[option.Name],
      option.Description + " (" + DescribeSetting(option) + ")");
  }
}

void AddLooks(CLI::App* plot, PlotArguments& arguments)
{
  plot->add_option("--title", arguments.Plot.Title, "Title above the plot");
  plot->add_option("--style", arguments.StyleFile, "File (.json) of a style")
    ->check(CLI::ExistingFile);
  plot->add_option(
    "--set", arguments.Settings, "Settings NAME=VALUE on top of the style: see pemesh list style");
  plot->add_option("--width", arguments.Width, "Width in centimetres (default 10)")
    ->check(CLI::Range(2.0, 200.0));
  plot->add_option("--height", arguments.Height, "Height in centimetres (default: what suits it)")
    ->check(CLI::Range(2.0, 200.0));
  plot->add_option("--dpi", arguments.Resolution, "Pixels an inch of a PNG (default 300)")
    ->check(CLI::Range(36.0, 2400.0));
  plot->add_flag("--data", arguments.Plot.Data, "Also write the numbers behind it, as .csv");
  plot->add_option("-o,--output", arguments.Output, "Figure to write: .png, .svg or .pdf")
    ->required();
}

} // namespace

void AddPlotCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<PlotArguments>();
  arguments->Plot.Kind = "scatter";
  CLI::App* plot = program.add_subcommand("plot", "Draw a chart of tables of results or elements");
  AddColumns(plot, *arguments);
  AddLooks(plot, *arguments);
  plot->callback([arguments, &exitCode] { exitCode = Plot(*arguments); });
}

} // namespace pemesh

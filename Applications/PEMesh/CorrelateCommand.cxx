// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * correlate: what the columns of one or several tables of results have to do with each other.
 */
#include "CoefficientKinds.h"
#include "Commands.h"
#include "CsvTable.h"
#include "ErrorText.h"
#include "Study.h"
#include "StudyFile.h"
#include "Terminal.h"
#include "vtkPEMCorrelation.h"
#include "vtkPEMFindings.h"
#include "vtkPEMJoinedTable.h"
#include "vtkPEMPooledTable.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

struct CorrelateArguments
{
  std::vector<std::string> Tables;
  std::string Output;
  std::string Findings;
  std::string Pooled;
  std::string Join;
  std::vector<std::string> X;
  std::vector<std::string> Y;
  std::vector<std::string> Given;
  std::string Family;
  std::string Coefficient = "spearman";
  bool Independent = false;
  int Permutations = 999;
  int Bootstrap = 0;
  double Level = 0.95;
  int Seed = 1;
  int Most = 10;
};

/** results.csv is called after its study, or after its folder; any other table after itself. */
std::string StudyNameOf(const fs::path& file)
{
  if (file.filename() != "results.csv")
  {
    return file.stem().string();
  }
  const fs::path folder = fs::absolute(file).parent_path();
  try
  {
    return ReadStudy(folder / "study.json").Name;
  }
  catch (const std::exception&)
  {
    return folder.filename().string(); // a table that has left its study
  }
}

void UpdateOrThrow(vtkAlgorithm* step)
{
  if (const std::string reason = UpdateExplaining(step); !reason.empty())
  {
    throw std::runtime_error(reason);
  }
}

/** All tables as one, with the performances to be joined. */
vtkSmartPointer<vtkTable> ReadTables(const CorrelateArguments& arguments)
{
  vtkNew<vtkPEMPooledTable> pooled;
  for (const std::string& file : arguments.Tables)
  {
    pooled->AddInputDataObject(0, ReadCsvFile(file));
    pooled->AddStudyName(StudyNameOf(file));
  }
  if (arguments.Join.empty())
  {
    UpdateOrThrow(pooled);
    return pooled->GetOutput();
  }
  vtkNew<vtkPEMJoinedTable> joined;
  joined->SetInputConnection(0, pooled->GetOutputPort());
  joined->SetInputData(1, ReadCsvFile(arguments.Join));
  joined->SetSourceName(arguments.Join);
  UpdateOrThrow(joined);
  return joined->GetOutput();
}

int Correlate(const CorrelateArguments& arguments)
{
  const vtkSmartPointer<vtkTable> table = ReadTables(arguments);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetXColumns(arguments.X);
  correlation->SetYColumns(arguments.Y);
  correlation->SetGivenColumns(arguments.Given);
  correlation->SetFamilyColumn(arguments.Family);
  correlation->SetCoefficient(arguments.Coefficient);
  correlation->SetIndependentRows(arguments.Independent);
  correlation->SetPermutations(arguments.Permutations);
  correlation->SetBootstrap(arguments.Bootstrap);
  correlation->SetConfidenceLevel(arguments.Level);
  correlation->SetSeed(arguments.Seed);
  vtkNew<vtkPEMFindings> findings;
  findings->SetInputConnection(0, correlation->GetOutputPort());
  findings->SetInputData(1, table);
  findings->SetNumberOfSentences(arguments.Most);
  {
    const ProgressBar bar(correlation, "correlate");
    UpdateOrThrow(correlation);
    UpdateOrThrow(findings);
  }
  if (!arguments.Pooled.empty())
  {
    WriteCsvFile(arguments.Pooled, table);
  }
  if (!arguments.Findings.empty())
  {
    WriteCsvFile(arguments.Findings, findings->GetOutput());
  }
  // One of both to standard output, so that the table can be piped.
  if (arguments.Output.empty())
  {
    std::cout << FormatCsv(correlation->GetOutput());
    std::cerr << findings->GetText();
  }
  else
  {
    WriteCsvFile(arguments.Output, correlation->GetOutput());
    std::cout << findings->GetText();
  }
  return AllDone;
}

std::vector<std::string> CoefficientNames()
{
  std::vector<std::string> names;
  for (const CoefficientKind& kind : CoefficientKinds())
  {
    names.emplace_back(kind.Name);
  }
  return names;
}

void AddColumnOptions(CLI::App* command, CorrelateArguments& arguments)
{
  command->add_option("--x", arguments.X, "Columns, with commas (default: all metrics)")
    ->delimiter(',');
  command
    ->add_option("--y", arguments.Y, "Columns, with commas (default: all metrics and performances)")
    ->delimiter(',');
  command
    ->add_option("--given", arguments.Given,
      "Columns to hold fixed, with commas: partial coefficients, as of --given MeshSize")
    ->delimiter(',');
  command->add_option("--family", arguments.Family,
    "Column that tells families of meshes apart (default: the study, of several tables)");
  command->add_option("--join", arguments.Join,
    "Table (.csv) with a column Mesh and performances of your own, joined by mesh name");
}

void AddTestOptions(CLI::App* command, CorrelateArguments& arguments)
{
  command
    ->add_option(
      "--coefficient", arguments.Coefficient, "What ranks, words, p-values and intervals go by")
    ->capture_default_str()
    ->check(CLI::IsMember(CoefficientNames()));
  command->add_flag("--independent", arguments.Independent,
    "The meshes do not come from families: each row is independent of the others");
  command
    ->add_option("--permutations", arguments.Permutations, "Arrangements of families for p-values")
    ->capture_default_str()
    ->check(CLI::Range(1, 10000000));
  command
    ->add_option("--bootstrap", arguments.Bootstrap,
      "Samples of families for confidence intervals; 0: no intervals")
    ->capture_default_str()
    ->check(CLI::Range(0, 10000000));
  command->add_option("--level", arguments.Level, "Confidence level of the intervals")
    ->capture_default_str()
    ->check(CLI::Range(0.5, 0.9999));
  command->add_option("--seed", arguments.Seed, "Seed of arrangements and samples")
    ->capture_default_str()
    ->check(CLI::NonNegativeNumber);
}

} // namespace

void AddCorrelateCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<CorrelateArguments>();
  CLI::App* command = program.add_subcommand(
    "correlate", "Correlate the columns of tables of results, and say what drives what");
  command
    ->add_option("TABLE", arguments->Tables, "Tables (.csv), one row a mesh; several are pooled")
    ->required();
  AddColumnOptions(command, *arguments);
  AddTestOptions(command, *arguments);
  command->add_option("--top", arguments->Most, "Sentences for each performance")
    ->capture_default_str()
    ->check(CLI::Range(1, 1000000));
  command->add_option("-o,--output", arguments->Output,
    "Table of pairs to write (.csv); without it the table goes to standard output, and the "
    "sentences to standard error");
  command->add_option("--findings", arguments->Findings, "Table of ranked metrics to write (.csv)");
  command->add_option("--pooled", arguments->Pooled,
    "Table of all rows to write (.csv), for \"pemesh plot --color-by Study\"");
  command->callback([arguments, &exitCode] { exitCode = Correlate(*arguments); });
}

} // namespace pemesh

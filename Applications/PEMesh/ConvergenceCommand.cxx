// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * convergence: the observed orders of the errors in a table of results.
 */
#include "Commands.h"

#include "Convergence.h"
#include "CsvTable.h"
#include "TableColumns.h"
#include "Terminal.h"
#include "TextFile.h"
#include "vtkPEMConvergence.h"

#include <CLI/CLI.hpp>

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <iostream>
#include <memory>
#include <stdexcept>

namespace pemesh
{

namespace
{

struct ConvergenceArguments
{
  std::string Table;
  std::string Output;
  std::string Size = "MeshSize";
  std::string Count;
  std::vector<std::string> Errors;
  std::string Format = "csv";
};

int ShowConvergence(const ConvergenceArguments& arguments)
{
  vtkNew<vtkPEMConvergence> convergence;
  const vtkSmartPointer<vtkTable> table = ReadCsvFile(arguments.Table);
  const std::string& size = arguments.Count.empty() ? arguments.Size : arguments.Count;
  CheckNumericColumns(table, { size });
  CheckNumericColumns(table, arguments.Errors);
  convergence->SetInputData(table);
  convergence->SetSizeIsCount(!arguments.Count.empty());
  convergence->SetSizeColumn(size);
  convergence->SetErrorColumns(arguments.Errors);
  convergence->Update();
  if (convergence->GetOutput()->GetNumberOfRows() < 2 ||
    convergence->GetOutput()->GetNumberOfColumns() < 2)
  {
    throw std::runtime_error("The table \"" + arguments.Table +
      "\" has not two meshes with a size and a column of errors: name them with --size and "
      "--errors.");
  }
  const std::string text = convergence->FormatOutput(arguments.Format);
  if (arguments.Output.empty())
  {
    std::cout << text;
  }
  else
  {
    WriteTextFile(arguments.Output, text);
  }
  return AllDone;
}

} // namespace

void AddConvergenceCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<ConvergenceArguments>();
  CLI::App* command = program.add_subcommand(
    "convergence", "Show the observed orders of convergence in a table of results");
  command->add_option("TABLE", arguments->Table, "Table (.csv), one row a mesh")->required();
  CLI::Option* size =
    command->add_option("--size", arguments->Size, "The column with the size of the mesh")
      ->capture_default_str();
  command
    ->add_option("--count", arguments->Count,
      "A column that counts unknowns or elements, whose -1/2nd power is the size")
    ->excludes(size);
  command
    ->add_option("--errors", arguments->Errors,
      "Columns, with commas (default: all with \"error\" in their name)")
    ->delimiter(',');
  std::vector<std::string> formats;
  for (const ConvergenceFormat& format : ConvergenceFormats())
  {
    formats.emplace_back(format.Name);
  }
  command->add_option("--format", arguments->Format, "Of the text")
    ->check(CLI::IsMember(formats))
    ->capture_default_str();
  command->add_option("-o,--output", arguments->Output, "File to write (default: the terminal)");
  command->callback([arguments, &exitCode] { exitCode = ShowConvergence(*arguments); });
}

} // namespace pemesh

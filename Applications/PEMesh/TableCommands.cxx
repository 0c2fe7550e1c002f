// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * correlate: what goes with what in a table of results.
 */
#include "Commands.h"
#include "CsvTable.h"
#include "NumberText.h"
#include "Terminal.h"
#include "vtkPEMCorrelation.h"

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

void CheckNumericColumns(vtkTable* table, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str())))
    {
      continue;
    }
    std::vector<std::string> known;
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      if (vtkDataArray::SafeDownCast(table->GetColumn(i)))
      {
        known.emplace_back(table->GetColumnName(i));
      }
    }
    throw std::runtime_error("The table has no column \"" + name +
      "\" of numbers; the nearest is \"" + NearestWord(name, known) + "\".");
  }
}

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
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * report: the results of a study on one page.
 */
#include "Commands.h"
#include "Terminal.h"
#include "vtkPEMReport.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include <vtkNew.h>

namespace pemesh
{

int WriteReport(const std::string& folder, const std::string& file)
{
  vtkNew<vtkPEMReport> report;
  report->SetFolder(folder);
  report->SetFileName(file);
  if (!report->Write())
  {
    Complain(report->GetErrorMessage());
    return WrongUsage;
  }
  for (const std::string& remark : report->GetRemarks())
  {
    Complain(remark);
  }
  std::cout << report->GetFileName() << "\n";
  return AllDone;
}

void AddReportCommand(CLI::App& program, int& exitCode)
{
  struct Arguments
  {
    std::string Folder;
    std::string Output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
    "report", "Put the results of a study on one HTML page that needs no other file");
  command->add_option("DIR", arguments->Folder, "Folder that \"pemesh run\" left")->required();
  command->add_option(
    "-o,--output", arguments->Output, "Page to write (.html; default: report.html in that folder)");
  command->callback(
    [arguments, &exitCode] { exitCode = WriteReport(arguments->Folder, arguments->Output); });
}

} // namespace pemesh

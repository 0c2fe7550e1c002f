// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * solvers: tries a solver on a tiny mesh and says what is wrong.
 */
#include "Commands.h"
#include "SolverCheck.h"
#include "SolverDescription.h"
#include "SolverDescriptionFile.h"
#include "Terminal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace pemesh
{

namespace
{

struct CheckArguments
{
  std::string Solver;
  std::string Output;
  std::vector<std::string> Options;
};

std::map<std::string, std::string> SplitOptions(const std::vector<std::string>& options)
{
  std::map<std::string, std::string> values;
  for (const std::string& option : options)
  {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos || equals == 0)
    {
      throw std::runtime_error("--option \"" + option + "\" is not of the form name=value.");
    }
    values[option.substr(0, equals)] = option.substr(equals + 1);
  }
  return values;
}

int CheckOne(const CheckArguments& arguments)
{
  std::map<std::string, std::string> options = SplitOptions(arguments.Options);
  const SolverDescription description = FindSolver(arguments.Solver);
  for (const auto& [name, value] : options)
  {
    const auto isIt = [&n = name](const SolverOption& option) { return option.Name == n; };
    if (std::none_of(description.Options.begin(), description.Options.end(), isIt))
    {
      throw std::runtime_error(
        "The solver " + description.Name + " has no option \"" + name + "\".");
    }
  }
  const std::vector<SolverFinding> findings = CheckSolver(description, options, arguments.Output);
  const auto errors = std::count_if(
    findings.begin(), findings.end(), [](const SolverFinding& finding) { return finding.IsError; });
  std::cout << description.Name << ": " << (errors == 0 ? "OK" : std::to_string(errors) + " wrong")
            << "\n";
  for (const SolverFinding& finding : findings)
  {
    std::cout << "  " << (finding.IsError ? "error: " : "note: ") << finding.Sentence << "\n";
  }
  return errors == 0 ? AllDone : PartFailed;
}

} // namespace

void AddSolversCommand(CLI::App& program, int& exitCode)
{
  CLI::App* solvers = program.add_subcommand("solvers", "Try solvers before a study does");
  solvers->require_subcommand(1);
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* check = solvers->add_subcommand(
    "check", "Run a solver on a tiny mesh and say what is wrong with it or its description");
  check->add_option("SOLVER", arguments->Solver, "Name or file (.json) of a solver description")
    ->required();
  check->add_option("--option", arguments->Options, "Option of the solver: problem=linear")
    ->type_name("NAME=VALUE")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  check->add_option(
    "-o,--output", arguments->Output, "Folder in which the files of the run stay (default: none)");
  check->callback([arguments, &exitCode] { exitCode = CheckOne(*arguments); });
}

} // namespace pemesh

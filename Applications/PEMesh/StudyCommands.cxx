// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * run, generate and solve: studies, handed to the Runner.
 */
#include "Commands.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "RankChannel.h"
#include "Ranks.h"
#include "Terminal.h"
#include "vtkPEMRunner.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include <vtkNew.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

/** How a study is run, whatever it is. */
struct RunArguments
{
  std::string Output;
  int Workers = 0;
  bool Resume = false;
  int Retries = 0;
  double Memory = 0.0;
};

struct StudyArguments : RunArguments
{
  std::string Study;
  std::vector<std::string> Settings;
  std::vector<std::string> Formats;
  bool Report = false;
};

struct SolveArguments : RunArguments
{
  std::vector<std::string> Meshes;
  std::string Solver;
  double TimeLimit = -1.0;
  std::vector<std::string> Options;
};

/** The run that an interrupt from the keyboard stops. */
vtkPEMRunner* ActiveRunner = nullptr;

void StopActiveRunner(int)
{
  if (ActiveRunner)
  {
    ActiveRunner->RequestStop();
  }
}

/** Runs, tells what went wrong and where the results are. */
int RunToEnd(vtkPEMRunner* runner, RankChannel* channel, const std::string& label)
{
  runner->SetRankChannel(channel);
  ActiveRunner = runner;
  std::signal(SIGINT, StopActiveRunner);
  std::signal(SIGTERM, StopActiveRunner);
  std::signal(SIGUSR1, StopActiveRunner); // mpiexec passes it on and waits
  std::signal(SIGXFSZ, SIG_IGN);          // a file that may not grow is an error as on a full disk
  bool done = false;
  {
    const ProgressBar bar(runner, label, channel != nullptr);
    done = runner->Run();
  }
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
  ActiveRunner = nullptr;
  for (const std::string& message : runner->GetMessages())
  {
    Complain(message);
  }
  if (runner->GetRefused())
  {
    return WrongUsage;
  }
  const int reused = runner->GetNumberOfReusedCases();
  std::cout << FormatCount(runner->GetNumberOfCases(), "mesh", "meshes")
            << (reused > 0 ? " (" + std::to_string(reused) + " as they were)" : "") << ", "
            << FormatCount(runner->GetNumberOfFailures(), "failure", "failures")
            << ". Results: " << runner->GetOutputDirectory() << "\n";
  for (const std::string& file : runner->GetFigureFiles())
  {
    std::cout << "  " << file << "\n";
  }
  return done ? AllDone : PartFailed;
}

/** All but the output, whose meaning differs. */
void AddRunOptions(CLI::App* command, RunArguments& arguments)
{
  command
    ->add_option("-j,--jobs", arguments.Workers,
      "Meshes worked on at the same time, by each process (default: one a core)")
    ->check(CLI::Range(1, 1024));
  command->add_flag("--resume", arguments.Resume,
    "Go on from what the folder holds: what is done and has not changed is not done again");
}

void AddSolverOptions(CLI::App* command, RunArguments& arguments)
{
  command
    ->add_option("--retry", arguments.Retries, "Times to try a mesh again where a solver fails")
    ->check(CLI::Range(0, 1000));
  command
    ->add_option("--memory", arguments.Memory,
      "MiB that solvers at work on one machine may take together; they wait for each other "
      "(default: any)")
    ->check(CLI::PositiveNumber);
}

void ApplyRunOptions(vtkPEMRunner* runner, const RunArguments& arguments)
{
  runner->SetOutputDirectory(arguments.Output);
  runner->SetNumberOfWorkers(arguments.Workers);
  runner->SetResume(arguments.Resume);
  runner->SetRetries(arguments.Retries);
  runner->SetSolverMemory(arguments.Memory);
}

int RunStudy(const StudyArguments& arguments, RankChannel* channel)
{
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyFile(arguments.Study);
  ApplyRunOptions(runner, arguments);
  for (const std::string& setting : arguments.Settings)
  {
    runner->AddSetting(setting);
  }
  const int exitCode = RunToEnd(runner, channel, "run");
  return arguments.Report && exitCode != WrongUsage
    ? std::max(exitCode, WriteReport(runner->GetOutputDirectory(), ""))
    : exitCode;
}

void AddRun(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = program.add_subcommand("run", "Run a study: meshes, metrics, solvers, plots");
  command->add_option("STUDY", arguments->Study, "Study document (.json)")->required();
  command->add_option(
    "-o,--output", arguments->Output, "Folder for the results (default: the name of the study)");
  AddRunOptions(command, *arguments);
  AddSolverOptions(command, *arguments);
  command
    ->add_option("--set", arguments->Settings, "Change a value of the study: mesh.min-angle=25")
    ->type_name("PATH=VALUE")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag(
    "--report", arguments->Report, "Put all of it on one page too: report.html in that folder");
  command->callback(
    [arguments, &exitCode] {
      exitCode = RunWithRanks([&](RankChannel* channel) { return RunStudy(*arguments, channel); });
    });
}

void AddGenerate(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command =
    program.add_subcommand("generate", "Make the meshes of a study, nothing else");
  command->add_option("STUDY", arguments->Study, "Study document (.json)")->required();
  command->add_option("-o,--output", arguments->Output, "Folder for the meshes")->required();
  AddRunOptions(command, *arguments);
  command
    ->add_option(
      "--format", arguments->Formats, "Names of formats, with commas (see pemesh list formats)")
    ->delimiter(',')
    ->check(CLI::IsMember(MeshFormatNames()));
  command->callback(
    [arguments, &exitCode]
    {
      vtkNew<vtkPEMRunner> runner;
      runner->SetStudyFile(arguments->Study);
      ApplyRunOptions(runner, *arguments);
      runner->SetMeshesOnly(true);
      runner->SetMeshFormats(arguments->Formats);
      exitCode =
        RunWithRanks([&](RankChannel* channel) { return RunToEnd(runner, channel, "generate"); });
    });
}

/** A study of mesh files with one solver, as a document. */
std::string SolveDocument(const SolveArguments& arguments)
{
  nlohmann::ordered_json solver;
  solver["solver"] = arguments.Solver;
  if (arguments.TimeLimit >= 0.0)
  {
    solver["time-limit"] = arguments.TimeLimit;
  }
  for (const std::string& option : arguments.Options)
  {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos || equals == 0)
    {
      throw std::runtime_error("--option \"" + option + "\" is not of the form name=value.");
    }
    const std::string value = option.substr(equals + 1);
    const auto parsed = nlohmann::ordered_json::parse(value, nullptr, false);
    solver[option.substr(0, equals)] =
      parsed.is_primitive() && !parsed.is_discarded() ? parsed : nlohmann::ordered_json(value);
  }
  nlohmann::ordered_json study;
  study["pemesh"] = 1;
  study["name"] = fs::path(arguments.Solver).stem().string() + "-results";
  study["meshes"] = arguments.Meshes;
  study["solvers"] = nlohmann::ordered_json::array({ solver });
  return study.dump();
}

void AddSolve(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command =
    program.add_subcommand("solve", "Run a solver on mesh files; metrics and results in one table");
  command->add_option("MESH", arguments->Meshes, "Mesh files")->required();
  command->add_option("--solver", arguments->Solver, "Name or file (.json) of a solver description")
    ->required();
  command->add_option(
    "-o,--output", arguments->Output, "Folder for the results (default: SOLVER-results)");
  AddRunOptions(command, *arguments);
  AddSolverOptions(command, *arguments);
  command
    ->add_option("--timeout", arguments->TimeLimit, "Seconds allowed for each mesh; 0: no limit")
    ->check(CLI::NonNegativeNumber);
  command->add_option("--option", arguments->Options, "Option of the solver: problem=linear")
    ->type_name("NAME=VALUE")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->callback(
    [arguments, &exitCode]
    {
      vtkNew<vtkPEMRunner> runner;
      runner->SetStudyText(SolveDocument(*arguments), fs::current_path().string());
      ApplyRunOptions(runner, *arguments);
      exitCode =
        RunWithRanks([&](RankChannel* channel) { return RunToEnd(runner, channel, "solve"); });
    });
}

} // namespace

void AddStudyCommands(CLI::App& program, int& exitCode)
{
  AddRun(program, exitCode);
  AddGenerate(program, exitCode);
  AddSolve(program, exitCode);
}

} // namespace pemesh

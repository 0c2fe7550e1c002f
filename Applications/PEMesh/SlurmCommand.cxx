// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * slurm: a study as a batch script for Slurm.
 */
#include "Commands.h"
#include "NumberText.h"
#include "SolverDescription.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFile.h"
#include "Terminal.h"
#include "TextFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

/** An option that goes to sbatch under its own name. */
struct BatchOption
{
  const char* Name;
  const char* Default; // "": left to Slurm
  const char* Help;
};

constexpr std::array<BatchOption, 9> BatchOptions{ {
  { "nodes", "1", "Machines" },
  { "ntasks", "1", "Processes in all: mpiexec starts so many" },
  { "cpus-per-task", "1", "Cores of each process: it works on so many meshes at the same time" },
  { "time", "", "Longest run, as in 12:00:00; a longer study is queued again and goes on" },
  { "mem", "", "Memory of each machine, as in 32G" },
  { "partition", "", "Where to queue" },
  { "account", "", "Who pays" },
  { "qos", "", "Quality of service" },
  { "constraint", "", "Features that the machines must have" },
} };

struct SlurmArguments
{
  std::string Study;
  std::string Script;
  std::string Output;
  std::vector<std::string> Settings;
  std::vector<std::pair<std::string, std::string>> Passed; // to pemesh run, as they are
  std::array<std::string, BatchOptions.size()> Batch;
};

/** One word of a shell, whatever is in it. */
std::string ShellWord(const std::string& word)
{
  std::string quoted = "'";
  for (const char c : word)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

/** Lines of #SBATCH know no quotes. */
std::string BatchWord(const std::string& name, const std::string& value)
{
  const auto isPlain = [](unsigned char c) { return std::isgraph(c) && c != '#' && c != '\''; };
  if (!std::all_of(value.begin(), value.end(), isPlain))
  {
    throw std::runtime_error("--" + name + " \"" + value + "\" is no single plain word.");
  }
  return value;
}

std::string JobName(const std::string& name)
{
  std::string plain = name;
  std::replace_if(
    plain.begin(), plain.end(),
    [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_' && c != '.'; }, '-');
  return plain;
}

std::string BatchLines(const SlurmArguments& arguments, const std::string& name)
{
  std::string text = "#SBATCH --job-name=" + JobName(name) + "\n";
  for (std::size_t i = 0; i < BatchOptions.size(); ++i)
  {
    const std::string option = BatchOptions[i].Name;
    if (!arguments.Batch[i].empty())
    {
      text += "#SBATCH --" + option + "=" + BatchWord(option, arguments.Batch[i]) + "\n";
    }
  }
  return text;
}

std::string RunWords(const SlurmArguments& arguments, const std::string& output)
{
  std::string words = ShellWord(fs::absolute(arguments.Study).string()) + " -o " +
    ShellWord(fs::absolute(output).string());
  for (const std::string& setting : arguments.Settings)
  {
    words += " --set " + ShellWord(setting);
  }
  for (const auto& [name, value] : arguments.Passed)
  {
    words += " " + name + (value.empty() ? "" : " " + ShellWord(value));
  }
  return words;
}

/**
 * Ninety seconds before the time is over Slurm tells the script, which tells pemesh, which saves;
 * then the job goes to the queue again. mpiexec passes SIGUSR1 on to its processes, where it would
 * end them on any other signal.
 */
constexpr const char* Body = R"(#SBATCH --output=%x-%j.log
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --signal=B:USR1@90
set -u

launch=()
if [ "${SLURM_NTASKS:-1}" -gt 1 ]; then
  # Slurm confines the job to its cores; each process may use all that it has been given.
  launch=(mpiexec -n "$SLURM_NTASKS" --bind-to none)
fi

stopped=no
stop() { stopped=yes; kill -USR1 "$!"; }
trap stop USR1

${launch[@]+"${launch[@]}"} @PROGRAM@ run @WORDS@ \
  -j "${SLURM_CPUS_PER_TASK:-1}" --resume &
running=$!
wait "$running"
status=$?
while kill -0 "$running" 2>/dev/null; do # it was the trap that ended the wait
  wait "$running"
  status=$?
done

if [ "$stopped" = yes ] && [ "$status" -ne 0 ] && [ -n "${SLURM_JOB_ID:-}" ]; then
  echo "The time is over; the study is queued again and will go on."
  scontrol requeue "$SLURM_JOB_ID"
fi
exit "$status"
)";

void Replace(std::string& text, const std::string& mark, const std::string& by)
{
  text.replace(text.find(mark), mark.size(), by);
}

int WriteScript(const SlurmArguments& arguments)
{
  std::string document = ReadTextFile(arguments.Study);
  for (const std::string& setting : arguments.Settings)
  {
    document = ApplySetting(document, setting);
  }
  Study study = ParseStudy(document, arguments.Study);
  const auto cases = MakeStudyCases(study); // better refused here than hours later in the queue
  FindStudySolvers(study);
  const std::string output = arguments.Output.empty() ? study.Name : arguments.Output;
  if (output.empty())
  {
    throw std::runtime_error("The study has no name: name its output folder with -o.");
  }
  const std::string script = arguments.Script.empty()
    ? JobName(fs::path(output).filename().string()) + ".slurm"
    : arguments.Script;
  std::string body = Body;
  Replace(body, "@PROGRAM@", ShellWord(fs::read_symlink("/proc/self/exe").string()));
  Replace(body, "@WORDS@", RunWords(arguments, output));
  WriteTextFile(script,
    "#!/bin/bash\n# A study of PEMesh, written by \"pemesh slurm\". Queue it: sbatch FILE\n" +
      BatchLines(arguments, study.Name.empty() ? "pemesh" : study.Name) + body);
  fs::permissions(script, fs::perms::owner_exec, fs::perm_options::add);
  std::cout << script << "\n";
  Complain(FormatCount(static_cast<long long>(cases.size()), "mesh", "meshes") +
    ". Queue them: sbatch " + ShellWord(script));
  return AllDone;
}

} // namespace

void AddSlurmCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<SlurmArguments>();
  CLI::App* command = program.add_subcommand("slurm", "Write a study as a batch script for Slurm");
  command->add_option("STUDY", arguments->Study, "Study document (.json)")->required();
  command->add_option(
    "--script", arguments->Script, "Script to write (default: the name of that folder, .slurm)");
  command->add_option(
    "-o,--output", arguments->Output, "Folder for the results (default: the name of the study)");
  command->add_option("--set", arguments->Settings, "Change a value of the study")
    ->type_name("PATH=VALUE")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  for (std::size_t i = 0; i < BatchOptions.size(); ++i)
  {
    arguments->Batch[i] = BatchOptions[i].Default;
    command->add_option(
      std::string("--") + BatchOptions[i].Name, arguments->Batch[i], BatchOptions[i].Help);
  }
  for (const char* name : { "--retry", "--memory" })
  {
    command->add_option_function<std::string>(
      name,
      [arguments, name](const std::string& value) { arguments->Passed.emplace_back(name, value); },
      "As of pemesh run");
  }
  command->add_flag_callback(
    "--report", [arguments] { arguments->Passed.emplace_back("--report", ""); },
    "As of pemesh run");
  command->callback([arguments, &exitCode] { exitCode = WriteScript(*arguments); });
}

} // namespace pemesh

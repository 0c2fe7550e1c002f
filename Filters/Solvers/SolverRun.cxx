// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverRun.h"

#include "CaseStatus.h"
#include "ChildProcess.h"
#include "ContentDigest.h"
#include "ElementAccess.h"
#include "MemoryBudget.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "SolverCommand.h"
#include "SolverFolder.h"
#include "TextFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

const MeshFormat& NeedFormat(const std::string& name)
{
  const MeshFormat* format = FindMeshFormat(name);
  if (!format)
  {
    std::vector<std::string> names;
    for (const MeshFormat& known : MeshFormats())
    {
      names.emplace_back(known.Name);
    }
    throw std::runtime_error("The solver's mesh format \"" + name +
      "\" is unknown; did you mean \"" + NearestWord(name, names) + "\"?");
  }
  if (!format->KeepsVertices)
  {
    throw std::runtime_error("The solver's mesh format \"" + name +
      "\" does not keep the order of the vertices, by which the solution is read; use another "
      "one, such as off.");
  }
  return *format;
}

/** The values of all placeholders, for a mesh file that may be only imagined. */
std::map<std::string, std::string> PlaceholderValues(
  const SolverRun& run, const MeshFormat& format, const std::filesystem::path& mesh)
{
  std::map<std::string, std::string> values{ { "mesh", mesh.string() },
    { "output", mesh.parent_path().string() }, { "stem", mesh.stem().string() },
    { "threads", std::to_string(run.Threads) },
    { "folder", SolverDescriptionFolder(run.Description) } };
  if (format.Extensions.size() > 1) // a pair of files
  {
    values["node"] = std::filesystem::path(mesh).replace_extension(".node").string();
    values["ele"] = std::filesystem::path(mesh).replace_extension(".ele").string();
  }
  values.insert(run.Options.begin(), run.Options.end());
  return values;
}

/** A file name made of the mesh's name, whatever that holds. */
std::string MakeStem(vtkPolyData* mesh)
{
  std::string stem = GetFieldText(mesh, MeshNameField);
  for (char& c : stem)
  {
    c = c == '/' || static_cast<unsigned char>(c) < ' ' ? '_' : c;
  }
  constexpr std::size_t longest = 200; // file systems end at 255 with what the solver appends
  stem.resize(std::min(stem.size(), longest));
  return stem.find_first_not_of('.') == std::string::npos ? "mesh" : stem;
}

/** The command as a line for a shell, so that a user can repeat a run by hand. */
std::string ShellLine(const std::vector<std::string>& arguments)
{
  std::string line;
  for (const std::string& argument : arguments)
  {
    line += line.empty() ? "'" : " '";
    for (const char c : argument)
    {
      line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    line += '\'';
  }
  return line + '\n';
}

std::string EndSentence(std::string text)
{
  if (text.empty() || text.back() != '.')
  {
    text += '.';
  }
  return text;
}

SolverOutcome Failure(const std::string& status, const std::string& message)
{
  return { status, EndSentence(message), "", {} };
}

/** What a run is called in messages. */
std::string NameOf(const SolverRun& run)
{
  const std::string& name = run.Description.Name;
  return name.empty() ? std::filesystem::path(run.Description.Command[0]).filename().string()
                      : name;
}

/** An ending by force, or by a limit: its status, and what follows the name of the solver. */
SolverOutcome JudgeForce(const SolverRun& run, const ChildProcessResult& result)
{
  const SolverDescription& description = run.Description;
  const std::string disk = " wrote more than the " + FormatNumber(description.DiskLimit) +
    " MiB of its disk limit and was stopped";
  using Ending = ChildProcessResult::Ending;
  switch (result.How)
  {
    case Ending::Signal:
      return result.IsFileTooLarge
        ? SolverOutcome{ "disk-limit", disk, "", {} }
        : SolverOutcome{ "crashed", " was ended by the signal " + result.Reason, "", {} };
    case Ending::TimeLimit:
      return { "time-out",
        " did not end within the time limit of " + FormatNumber(description.TimeLimit) +
          " s and was stopped",
        "", {} };
    case Ending::ProcessorLimit:
      return { "cpu-limit",
        " took more than the " + FormatNumber(description.ProcessorLimit) +
          " s of processor time that it may and was stopped",
        "", {} };
    case Ending::MemoryLimit:
      return { "memory-limit",
        " took more than the " + FormatNumber(description.MemoryLimit) +
          " MiB of memory that it may and was stopped",
        "", {} };
    case Ending::Cancelled: // not by the user, or nobody would judge
      return { "disk-limit", disk, "", {} };
    default:
      return { "exit-status", " ended with exit status " + std::to_string(result.ExitStatus), "",
        {} };
  }
}

/** The outcome of a program that did not end well; "ok" if it did. */
SolverOutcome JudgeEnding(
  const SolverRun& run, const ChildProcessResult& result, bool isFolderTooLarge)
{
  const std::string name = NameOf(run);
  using Ending = ChildProcessResult::Ending;
  if (result.How == Ending::Exited && result.ExitStatus == 0)
  {
    return { "ok", "", "", {} };
  }
  if (result.How == Ending::NotStarted)
  {
    return Failure("not-found", "The program " + name + " cannot be started: " + result.Reason);
  }
  if (result.How == Ending::Cancelled && !isFolderTooLarge)
  {
    return Failure("cancelled", "The run of " + name + " was cancelled");
  }
  const SolverOutcome force = JudgeForce(run, result);
  return Failure(force.Status,
    name + force.Message +
      (result.LastErrorLine.empty() ? "; it wrote nothing to its standard error"
                                    : "; it last wrote: " + result.LastErrorLine));
}

constexpr double MebiByte = 1024.0 * 1024.0;

ChildProcess PrepareChild(
  const SolverRun& run, const std::filesystem::path& folder, const std::filesystem::path& mesh)
{
  const SolverDescription& description = run.Description;
  ChildProcess child;
  child.Arguments = ExpandCommand(
    description.Command, PlaceholderValues(run, NeedFormat(description.MeshFormat), mesh));
  child.WorkingDirectory = folder;
  child.OutputFile = folder / "stdout.log";
  child.ErrorFile = folder / "stderr.log";
  child.TimeLimit = description.TimeLimit;
  child.ProcessorLimit = description.ProcessorLimit;
  child.MemoryLimit = MebiByte * description.MemoryLimit;
  child.FileLimit = MebiByte * description.DiskLimit;
  for (const char* variable : { "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS" })
  {
    child.Environment.emplace_back(variable, std::to_string(run.Threads));
  }
  return child;
}

/** Runs the child and looks at its folder from time to time. */
ChildProcessResult RunWatched(
  const SolverRun& run, ChildProcess& child, const SolverFolder& folder, bool& isFolderTooLarge)
{
  constexpr double secondsBetweenLooks = 0.5;
  double nextLook = secondsBetweenLooks;
  child.GoOn = [&](double seconds)
  {
    if (seconds >= nextLook && child.FileLimit > 0.0)
    {
      nextLook = seconds + secondsBetweenLooks;
      isFolderTooLarge = static_cast<double>(folder.GetSize()) > child.FileLimit;
    }
    return !isFolderTooLarge && (!run.GoOn || run.GoOn(seconds));
  };
  return RunChildProcess(child);
}

/** The same, once there is room for it in the memory. */
ChildProcessResult RunWithinBudget(
  const SolverRun& run, ChildProcess& child, const SolverFolder& folder, bool& isFolderTooLarge)
{
  if (!run.Budget)
  {
    return RunWatched(run, child, folder, isFolderTooLarge);
  }
  const std::string name = NameOf(run);
  const double taken =
    run.Budget->Take(name, child.MemoryLimit, [&] { return !run.GoOn || run.GoOn(0.0); });
  ChildProcessResult result;
  result.How = ChildProcessResult::Ending::Cancelled;
  if (taken >= 0.0)
  {
    result = RunWatched(run, child, folder, isFolderTooLarge);
    run.Budget->GiveBack(name, taken, result.PeakMemory);
  }
  return result;
}

/** What may explain that files are missing: others, and processes that were to write them. */
std::string Explanation(const SolverFolder& folder,
  const std::vector<std::filesystem::path>& expected, const ChildProcessResult& result)
{
  std::error_code error;
  if (!std::filesystem::exists(folder.GetPath(), error))
  {
    return "It has removed its own folder.";
  }
  std::string text;
  constexpr std::size_t most = 3;
  const std::vector<std::string> strays = folder.FindNew(expected);
  for (std::size_t i = 0; i < std::min(most, strays.size()); ++i)
  {
    text += (i == 0 ? "It has written \"" : ", \"") + strays[i] + '"';
  }
  if (!strays.empty())
  {
    text += strays.size() > most ? ", …" : "";
    text += ", which nobody asked for.";
  }
  if (result.ProcessesLeft > 0)
  {
    text +=
      (text.empty() ? "" : " ") + std::string("Processes that it had left running were stopped.");
  }
  return text;
}

/** Reads the answer of a program that ended well; what is no good is told, the rest is kept. */
SolverOutcome JudgeAnswer(const SolverRun& run, SolverAnswer answer, const std::string& explanation)
{
  if (answer.Faults.empty())
  {
    return { "ok", "", explanation, std::move(answer) };
  }
  const bool isSomethingGood = answer.Solution || answer.GroundTruth ||
    std::any_of(answer.Performances.begin(), answer.Performances.end(),
      [](double value) { return std::isfinite(value); });
  const std::size_t others = answer.Faults.size() - 1;
  std::string message = answer.Faults.front() + (explanation.empty() ? "" : " ") + explanation;
  if (others > 0)
  {
    message += " " + std::to_string(others) + " more of its files " + (others == 1 ? "is" : "are") +
      " no good.";
  }
  message += isSomethingGood ? " The rest of its answer is kept." : "";
  const std::size_t files = run.Description.Performances.size();
  answer.Performances.resize(files, std::numeric_limits<double>::quiet_NaN());
  return { isSomethingGood ? "partial" : "bad-output", message, explanation, std::move(answer) };
}

constexpr const char* SolvedFile = "solved.txt";

/** The question that is put to the solver, as a digest. The mesh file is written. */
std::string QuestionOf(const SolverRun& run, const std::filesystem::path& meshFile)
{
  ContentDigest digest;
  digest.Add(SolverFingerprint(run.Description));
  digest.Add(run.Version);
  for (const auto& [name, value] : run.Options)
  {
    digest.Add(name + '=' + value);
  }
  for (const std::string& extension :
    { meshFile.extension().string(), std::string(".node"), std::string(".ele") })
  {
    digest.AddFile(std::filesystem::path(meshFile).replace_extension(extension));
  }
  return digest.Finish();
}

/** The question and the answer that was given, files in order. */
std::string SolvedText(
  const std::string& question, const std::vector<std::filesystem::path>& answers)
{
  ContentDigest digest;
  for (const std::filesystem::path& file : answers)
  {
    digest.AddFile(file);
  }
  return "question " + question + "\nanswer " + digest.Finish() + "\n";
}

bool IsSolved(const std::filesystem::path& file, const std::string& question,
  const std::vector<std::filesystem::path>& answers)
{
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error)) &&
    ReadTextFile(file) == SolvedText(question, answers);
}

/** One attempt in a folder where the mesh file lies. */
SolverOutcome RunOnce(const SolverRun& run, vtkPolyData* mesh, SolverFolder& folder,
  const std::filesystem::path& meshFile)
{
  const std::string stem = meshFile.stem().string();
  ChildProcess child = PrepareChild(run, folder.GetPath(), meshFile);
  const std::string program = child.Arguments[0];
  child.Arguments[0] = FindSolverProgram(program, run.Description.Folder).string();
  if (child.Arguments[0].empty())
  {
    return Failure("not-found",
      "The program \"" + program +
        "\" is not there; give its path in the command of the solver, or put it beside pemesh or "
        "into a folder of PATH");
  }
  WriteTextFile(folder.GetPath() / "command.txt", ShellLine(child.Arguments));
  std::vector<std::filesystem::path> expected =
    SolverAnswerFiles(run.Description, folder.GetPath(), stem);
  expected.insert(expected.end(), { child.OutputFile, child.ErrorFile });
  folder.NoteNames();
  bool isFolderTooLarge = false;
  const ChildProcessResult result = RunWithinBudget(run, child, folder, isFolderTooLarge);
  const SolverOutcome outcome = JudgeEnding(run, result, isFolderTooLarge);
  if (outcome.Status != "ok")
  {
    return outcome;
  }
  return JudgeAnswer(run,
    ReadSolverAnswer(
      run.Description, folder.GetPath(), stem, mesh->GetNumberOfPoints(), mesh->GetNumberOfPolys()),
    Explanation(folder, expected, result));
}

/** Whether another attempt may end otherwise. */
bool MayGoWell(const std::string& status)
{
  return status != "ok" && status != "cancelled" && status != "not-found";
}

SolverOutcome RunInFolder(const SolverRun& run, vtkPolyData* mesh)
{
  const std::string stem = MakeStem(mesh);
  const MeshFormat& format = NeedFormat(run.Description.MeshFormat);
  SolverFolder folder(run.WorkDirectory, stem);
  const std::filesystem::path meshFile = folder.GetPath() / (stem + format.Extensions[0]);
  const std::filesystem::path solved = folder.GetPath() / SolvedFile;
  const std::vector<std::filesystem::path> answers =
    SolverAnswerFiles(run.Description, folder.GetPath(), stem);
  format.Write(meshFile, mesh);
  const std::string question = QuestionOf(run, meshFile);
  if (run.ReusesAnswer && IsSolved(solved, question, answers))
  {
    return { "ok", "", "",
      ReadSolverAnswer(run.Description, folder.GetPath(), stem, mesh->GetNumberOfPoints(),
        mesh->GetNumberOfPolys()) };
  }
  SolverOutcome outcome;
  for (int attempt = 0; attempt <= run.Retries; ++attempt)
  {
    folder.Remove({ solved });
    folder.Remove(answers);
    if (attempt > 0)
    {
      format.Write(meshFile, mesh); // the solver may have changed it
    }
    outcome = RunOnce(run, mesh, folder, meshFile);
    if (!MayGoWell(outcome.Status))
    {
      break;
    }
  }
  if (outcome.Status == "ok" && !run.WorkDirectory.empty())
  {
    WriteTextFile(solved, SolvedText(question, answers));
  }
  if (MayGoWell(outcome.Status) && run.Retries > 0)
  {
    outcome.Message += " It was tried " + std::to_string(run.Retries + 1) + " times.";
  }
  return outcome;
}

} // namespace

void CheckSolverRun(const SolverRun& run)
{
  const SolverDescription& description = run.Description;
  if (description.Command.empty() || description.Command[0].empty())
  {
    throw std::runtime_error("The solver has no command: set the argument list, program first.");
  }
  const MeshFormat& format = NeedFormat(description.MeshFormat);
  std::set<std::string> names{ "solution", "ground-truth" };
  for (const SolverPerformance& performance : description.Performances)
  {
    const std::string& name = performance.Name;
    if (name.empty() || name.find('/') != std::string::npos || !names.insert(name).second)
    {
      throw std::runtime_error("The solver's performance \"" + name +
        "\" must have a name of its own, without a slash, that is not solution or ground-truth.");
    }
  }
  ExpandCommand(description.Command,
    PlaceholderValues(run, format, std::string("/mesh") + format.Extensions[0]));
}

SolverOutcome RunSolver(const SolverRun& run, vtkPolyData* mesh)
{
  if (IsCaseFailed(mesh))
  {
    return Failure("no-mesh", "There is no mesh to solve on: " + GetCaseStatusMessage(mesh));
  }
  std::string reason = ElementAccess::WhyUnusable(mesh);
  const MeshFormat* format = FindMeshFormat(run.Description.MeshFormat);
  if (reason.empty() && format && CountElementsToCut(*format, mesh) > 0)
  {
    reason = "the format " + run.Description.MeshFormat + " holds elements of at most " +
      std::to_string(format->MostCorners) + " vertices, and this mesh has larger ones";
  }
  if (!reason.empty())
  {
    return Failure("no-mesh", "There is no mesh to solve on: " + reason);
  }
  try
  {
    return RunInFolder(run, mesh);
  }
  catch (const std::exception& error)
  {
    return Failure("not-written", error.what());
  }
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverRun.h"

#include "CaseStatus.h"
#include "ChildProcess.h"
#include "ElementAccess.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "SolverCommand.h"
#include "TextFile.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
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
      "\" does not keep the order of the vertices, by which the solution is read; use off, obj, "
      "node or vtp.");
  }
  return *format;
}

/** The values of all placeholders, for a mesh file that may be only imagined. */
std::map<std::string, std::string> PlaceholderValues(
  const SolverRun& run, const MeshFormat& format, const std::filesystem::path& mesh)
{
  std::map<std::string, std::string> values{ { "mesh", mesh.string() },
    { "output", mesh.parent_path().string() }, { "stem", mesh.stem().string() },
    { "threads", std::to_string(run.Threads) } };
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

/** The folder of a run: the user's, or one that is removed at the end. */
class RunFolder
{
public:
  RunFolder(const std::filesystem::path& workDirectory, const std::string& stem)
  {
    std::filesystem::path root = workDirectory;
    if (root.empty())
    {
      std::string name = (std::filesystem::temp_directory_path() / "pemesh-XXXXXX").string();
      if (!mkdtemp(name.data()))
      {
        throw std::runtime_error(
          "Cannot make a temporary folder: " + std::string(std::strerror(errno)) + ".");
      }
      root = this->Temporary = name;
    }
    this->Path = std::filesystem::absolute(root / stem).lexically_normal();
    std::error_code error;
    std::filesystem::create_directories(this->Path, error);
    if (error)
    {
      throw std::runtime_error(
        "Cannot make the folder \"" + this->Path.string() + "\": " + error.message() + ".");
    }
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder()
  {
    if (!this->Temporary.empty())
    {
      std::error_code ignored;
      std::filesystem::remove_all(this->Temporary, ignored);
    }
  }

  const std::filesystem::path& GetPath() const { return this->Path; }

private:
  std::filesystem::path Path;
  std::filesystem::path Temporary;
};

/** An answer of an earlier run must not be taken for a new one. */
void RemoveOldAnswer(const SolverDescription& description, const std::filesystem::path& folder,
  const std::string& stem)
{
  for (const std::filesystem::path& file : SolverAnswerFiles(description, folder, stem))
  {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error)
    {
      throw std::runtime_error(
        "Cannot remove the old file \"" + file.string() + "\": " + error.message() + ".");
    }
  }
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
  return { status, EndSentence(message), {} };
}

/** The outcome of a program that did not end well; "ok" if it did. */
SolverOutcome JudgeEnding(
  const SolverRun& run, const ChildProcessResult& result, const std::string& name)
{
  const std::string said = result.LastErrorLine.empty()
    ? "; it wrote nothing to its standard error"
    : "; it last wrote: " + result.LastErrorLine;
  using Ending = ChildProcessResult::Ending;
  switch (result.How)
  {
    case Ending::NotStarted:
      return Failure("not-found", "The program " + name + " cannot be started: " + result.Reason);
    case Ending::Signal:
      return Failure("crashed", name + " was ended by the signal " + result.Reason + said);
    case Ending::TimeLimit:
      return Failure("time-out",
        name + " did not end within the time limit of " + FormatNumber(run.Description.TimeLimit) +
          " s and was stopped" + said);
    case Ending::Cancelled:
      return Failure("cancelled", "The run of " + name + " was cancelled");
    case Ending::Exited:
      break;
  }
  return result.ExitStatus == 0
    ? SolverOutcome{ "ok", "", {} }
    : Failure("exit-status",
        name + " ended with exit status " + std::to_string(result.ExitStatus) + said);
}

ChildProcess PrepareChild(const SolverRun& run, vtkPolyData* mesh, const MeshFormat& format,
  const std::filesystem::path& folder, const std::string& stem)
{
  const std::filesystem::path meshFile = folder / (stem + format.Extensions[0]);
  RemoveOldAnswer(run.Description, folder, stem);
  format.Write(meshFile, mesh);
  ChildProcess child;
  child.Arguments =
    ExpandCommand(run.Description.Command, PlaceholderValues(run, format, meshFile));
  child.WorkingDirectory = folder;
  child.OutputFile = folder / "stdout.log";
  child.ErrorFile = folder / "stderr.log";
  child.TimeLimit = run.Description.TimeLimit;
  child.GoOn = run.GoOn;
  for (const char* variable : { "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS" })
  {
    child.Environment.emplace_back(variable, std::to_string(run.Threads));
  }
  return child;
}

SolverOutcome RunInFolder(const SolverRun& run, vtkPolyData* mesh)
{
  const std::string stem = MakeStem(mesh);
  const MeshFormat& format = NeedFormat(run.Description.MeshFormat);
  const RunFolder folder(run.WorkDirectory, stem);
  ChildProcess child = PrepareChild(run, mesh, format, folder.GetPath(), stem);
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
  const std::string& described = run.Description.Name;
  SolverOutcome outcome = JudgeEnding(run, RunChildProcess(child),
    described.empty() ? std::filesystem::path(program).filename().string() : described);
  if (outcome.Status == "ok")
  {
    try
    {
      outcome.Answer = ReadSolverAnswer(run.Description, folder.GetPath(), stem,
        mesh->GetNumberOfPoints(), mesh->GetNumberOfPolys());
    }
    catch (const std::exception& error)
    {
      outcome = Failure("bad-output", error.what());
    }
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
  const std::string reason = ElementAccess::WhyUnusable(mesh);
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverCall.h"

#include "MemoryBudget.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "SolverCommand.h"
#include "SolverFolder.h"
#include "SolverQueue.h"
#include "SolverRun.h"
#include "TextFile.h"

#include <functional>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pemesh
{

namespace
{

using Requests = std::vector<SolverRequest*>;

constexpr double MebiByte = 1024.0 * 1024.0;
constexpr const char* OutputFile = "stdout.log";
constexpr const char* ErrorFile = "stderr.log";
constexpr const char* CommandFile = "command.txt";
constexpr const char* ListFile = "list.txt";

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

/** Room in the memory, given back on every way out. */
class MemoryShare
{
public:
  MemoryShare(MemoryBudget& budget, const std::string& solver, double limit,
    const std::function<bool()>& goOn)
    : Budget(budget)
    , Solver(solver)
    , Taken(budget.Take(solver, limit, goOn))
  {
  }
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;
  ~MemoryShare()
  {
    if (this->IsGranted())
    {
      this->Budget.GiveBack(this->Solver, this->Taken, this->Peak);
    }
  }
  bool IsGranted() const { return this->Taken >= 0.0; }
  void SetPeak(double peak) { this->Peak = peak; }

private:
  MemoryBudget& Budget;
  std::string Solver;
  double Taken;
  double Peak = 0.0;
};

/** The child for all requests, in the folder of the first one, to which its logs go. */
ChildProcess PrepareChild(const Requests& requests)
{
  const SolverRequest& first = *requests.front();
  const SolverRun& run = first.Run;
  const SolverDescription& description = run.Description;
  const fs::path& folder = first.Folder.GetPath();
  const auto meshes = static_cast<double>(requests.size());
  ChildProcess child;
  child.Arguments = ExpandCommand(description.Command,
    SolverPlaceholders(run, SolverMeshFormat(description.MeshFormat), first.MeshFile));
  child.WorkingDirectory = TakesList(description) ? folder.parent_path() : folder;
  child.OutputFile = folder / OutputFile;
  child.ErrorFile = folder / ErrorFile;
  child.TimeLimit = meshes * description.TimeLimit;
  child.ProcessorLimit = meshes * description.ProcessorLimit;
  child.MemoryLimit = MebiByte * description.MemoryLimit;
  child.FileLimit = MebiByte * description.DiskLimit;
  for (const char* variable : { "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS" })
  {
    child.Environment.emplace_back(variable, std::to_string(run.Threads));
  }
  return child;
}

/** One mesh file a line, relative to the folder in which the child runs. */
void WriteList(const Requests& requests, const fs::path& workingDirectory)
{
  std::string list;
  for (const SolverRequest* request : requests)
  {
    list += request->MeshFile.lexically_relative(workingDirectory).string() + '\n';
  }
  WriteTextFile(requests.front()->Folder.GetPath() / ListFile, list);
}

/** Every mesh has the logs of its call in its own folder. */
void ShareFiles(const Requests& requests)
{
  const fs::path from = requests.front()->Folder.GetPath();
  for (std::size_t i = 1; i < requests.size() && requests.front()->Folder.IsThere(); ++i)
  {
    if (!requests[i]->Folder.IsThere())
    {
      continue;
    }
    const fs::path to = requests[i]->Folder.GetPath();
    for (const char* name : { OutputFile, ErrorFile, CommandFile, ListFile })
    {
      std::error_code ignored;
      fs::remove_all(to / name, ignored); // it may be a link, which is not to be written through
      if (fs::is_regular_file(fs::symlink_status(from / name, ignored)))
      {
        fs::copy_file(from / name, to / name, ignored);
      }
    }
  }
}

/** Runs the child and looks at the folders from time to time; whether one is too large. */
bool RunWatched(const Requests& requests, const std::function<bool(double)>& goOn,
  ChildProcess& child, ChildProcessResult& result)
{
  constexpr double secondsBetweenLooks = 0.5;
  double nextLook = secondsBetweenLooks;
  bool isTooLarge = false;
  child.GoOn = [&](double seconds)
  {
    if (seconds >= nextLook && child.FileLimit > 0.0)
    {
      nextLook = seconds + secondsBetweenLooks;
      for (const SolverRequest* request : requests)
      {
        isTooLarge = isTooLarge || static_cast<double>(request->Folder.GetSize()) > child.FileLimit;
      }
    }
    return !isTooLarge && (!goOn || goOn(seconds));
  };
  result = RunChildProcess(child);
  return isTooLarge;
}

/** The same, once there is room for it in the memory. */
bool RunWithinBudget(
  const Requests& requests, const SolverRun& own, ChildProcess& child, ChildProcessResult& result)
{
  if (!own.Budget)
  {
    return RunWatched(requests, own.GoOn, child, result);
  }
  result.How = ChildProcessResult::Ending::Cancelled;
  MemoryShare share(*own.Budget, NameOfSolver(own), child.MemoryLimit,
    [&own] { return !own.GoOn || own.GoOn(0.0); });
  if (!share.IsGranted())
  {
    return false;
  }
  const bool isTooLarge = RunWatched(requests, own.GoOn, child, result);
  share.SetPeak(result.PeakMemory);
  return isTooLarge;
}

/** Calls the solver for all; only `own` may be asked whether to go on, since it is its thread. */
void CallForAll(const Requests& requests, const SolverRun& own)
{
  ChildProcess child = PrepareChild(requests);
  const std::string program = child.Arguments[0];
  child.Arguments[0] = FindSolverProgram(program, own.Description.Folder).string();
  for (SolverRequest* request : requests)
  {
    request->IsShared = requests.size() > 1;
    request->IsMissing = child.Arguments[0].empty();
  }
  if (child.Arguments[0].empty())
  {
    throw std::runtime_error("The program \"" + program +
      "\" is not there; give its path in the command of the solver, or put it beside pemesh or "
      "into a folder of PATH");
  }
  for (const SolverRequest* request : requests)
  {
    request->Folder.Remove(SolverCallFiles(request->Folder)); // of an earlier call
  }
  WriteTextFile(requests.front()->Folder.GetPath() / CommandFile, ShellLine(child.Arguments));
  if (TakesList(own.Description))
  {
    WriteList(requests, child.WorkingDirectory);
  }
  ChildProcessResult result;
  const bool isTooLarge = RunWithinBudget(requests, own, child, result);
  ShareFiles(requests);
  for (SolverRequest* request : requests)
  {
    request->Result = result;
    request->IsFolderTooLarge = isTooLarge;
  }
}

/** What differs between two runs must not be answered by one call. */
std::string KeyOf(const SolverRun& run)
{
  std::string key = SolverFingerprint(run.Description) + '\n' + run.WorkDirectory.string();
  for (const auto& [name, value] : run.Options)
  {
    key += '\n' + name + '=' + value;
  }
  return key;
}

} // namespace

std::string NameOfSolver(const SolverRun& run)
{
  const std::string& name = run.Description.Name;
  return name.empty() ? std::filesystem::path(run.Description.Command[0]).filename().string()
                      : name;
}

const MeshFormat& SolverMeshFormat(const std::string& name)
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

std::map<std::string, std::string> SolverPlaceholders(
  const SolverRun& run, const MeshFormat& format, const std::filesystem::path& mesh)
{
  std::map<std::string, std::string> values{ { "threads", std::to_string(run.Threads) },
    { "folder", SolverDescriptionFolder(run.Description) } };
  if (TakesList(run.Description))
  {
    values["list"] = (mesh.parent_path() / ListFile).string();
  }
  else
  {
    values["mesh"] = mesh.string();
    values["output"] = mesh.parent_path().string();
    values["stem"] = mesh.stem().string();
    if (format.Extensions.size() > 1) // a pair of files
    {
      values["node"] = std::filesystem::path(mesh).replace_extension(".node").string();
      values["ele"] = std::filesystem::path(mesh).replace_extension(".ele").string();
    }
  }
  values.insert(run.Options.begin(), run.Options.end());
  return values;
}

std::vector<fs::path> SolverCallFiles(const SolverFolder& folder)
{
  std::vector<fs::path> files;
  for (const char* name : { OutputFile, ErrorFile, CommandFile, ListFile })
  {
    files.push_back(folder.GetPath() / name);
  }
  return files;
}

void CallSolver(SolverRequest& request, bool isAlone)
{
  const SolverRun& run = request.Run;
  const auto answer = [&run](const Requests& requests)
  {
    try
    {
      CallForAll(requests, run);
    }
    catch (const std::exception& error)
    {
      for (SolverRequest* each : requests)
      {
        each->Error = error.what();
      }
    }
  };
  request.Error.clear();
  request.IsFolderTooLarge = false;
  request.IsShared = false;
  if (isAlone || !run.Queue || !TakesList(run.Description))
  {
    answer({ &request });
    return;
  }
  run.Queue->Ask(KeyOf(run), static_cast<std::size_t>(run.Description.MeshesPerCall), &request,
    [&answer](const SolverQueue::Requests& all)
    {
      Requests requests;
      for (void* each : all)
      {
        requests.push_back(static_cast<SolverRequest*>(each));
      }
      answer(requests);
    });
}

} // namespace pemesh

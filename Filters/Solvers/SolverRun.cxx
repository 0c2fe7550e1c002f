// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverRun.h"

#include "CaseStatus.h"
#include "ChildProcess.h"
#include "ContentDigest.h"
#include "ElementAccess.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "SolverCall.h"
#include "SolverCommand.h"
#include "SolverFolder.h"
#include "TextFile.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** The first bytes of a text, at most so many, that do not end within a character of UTF-8. */
std::string CutText(const std::string& text, std::size_t most)
{
  std::size_t size = std::min(most, text.size());
  constexpr std::size_t longestCharacter = 4;
  for (std::size_t i = 1; size < text.size() && i < longestCharacter && (text[size] & 0xC0) == 0x80;
       ++i)
  {
    --size;
  }
  return text.substr(0, size);
}

/**
 * A file name made of the mesh's name, whatever that holds. A name that has to be changed gets a
 * digest of all of it, so that two meshes never share a folder.
 */
std::string MakeStem(vtkPolyData* mesh)
{
  const std::string name = GetFieldText(mesh, MeshNameField);
  constexpr std::size_t longest = 200; // file systems end at 255 with what the solver appends
  constexpr std::size_t digits = 16;
  std::string stem = CutText(name, name.size() > longest ? longest - digits - 1 : longest);
  for (char& c : stem)
  {
    c = c == '/' || static_cast<unsigned char>(c) < ' ' ? '_' : c;
  }
  if (stem.find_first_not_of('.') == std::string::npos)
  {
    stem = "mesh";
  }
  if (stem == name || name.empty())
  {
    return stem;
  }
  ContentDigest digest;
  digest.Add(name);
  return stem + '-' + digest.Finish().substr(0, digits);
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

/** An ending that is told by a sentence of its own. */
struct EndingRule
{
  ChildProcessResult::Ending How;
  const char* Status;
  std::string (*Words)(const SolverDescription& description, const ChildProcessResult& result);
};

std::string DiskWords(const SolverDescription& description, const ChildProcessResult&)
{
  return " wrote more than the " + FormatNumber(description.DiskLimit) +
    " MiB of its disk limit and was stopped";
}

using Ending = ChildProcessResult::Ending;

const EndingRule EndingRules[] = {
  { Ending::Exited, "exit-status",
    [](const SolverDescription&, const ChildProcessResult& result)
    { return " ended with exit status " + std::to_string(result.ExitStatus); } },
  { Ending::Signal, "crashed",
    [](const SolverDescription&, const ChildProcessResult& result)
    { return " was ended by the signal " + result.Reason; } },
  { Ending::TimeLimit, "time-out",
    [](const SolverDescription& description, const ChildProcessResult&)
    {
      return " did not end within the time limit of " + FormatNumber(description.TimeLimit) +
        " s and was stopped";
    } },
  { Ending::ProcessorLimit, "cpu-limit",
    [](const SolverDescription& description, const ChildProcessResult&)
    {
      return " took more than the " + FormatNumber(description.ProcessorLimit) +
        " s of processor time that it may and was stopped";
    } },
  { Ending::MemoryLimit, "memory-limit",
    [](const SolverDescription& description, const ChildProcessResult&)
    {
      return " took more than the " + FormatNumber(description.MemoryLimit) +
        " MiB of memory that it may and was stopped";
    } },
  // Not by the user, or nobody would judge.
  { Ending::Cancelled, "disk-limit", DiskWords },
};

/** The outcome of a program that did not end well; "ok" if it did. */
SolverOutcome JudgeEnding(
  const SolverRun& run, const ChildProcessResult& result, bool isFolderTooLarge)
{
  const std::string name = NameOfSolver(run);
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
  const Ending how = result.IsFileTooLarge ? Ending::Cancelled : result.How; // of the disk limit
  const EndingRule& rule = *std::find_if(std::begin(EndingRules), std::end(EndingRules),
    [how](const EndingRule& candidate) { return candidate.How == how; });
  return Failure(rule.Status,
    name + rule.Words(run.Description, result) +
      (result.LastErrorLine.empty() ? "; it wrote nothing to its standard error"
                                    : "; it last wrote: " + result.LastErrorLine));
}

/** What may explain that files are missing: others, and processes that were to write them. */
std::string Explanation(const SolverFolder& folder,
  const std::vector<std::filesystem::path>& expected, const ChildProcessResult& result)
{
  if (!folder.IsThere())
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

/** A solver may have put anything in place of a file of its folder: a pipe, a link to the endless.
 */
bool IsOwnFile(const std::filesystem::path& file)
{
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error));
}

void AddOwnFile(ContentDigest& digest, const std::filesystem::path& file)
{
  IsOwnFile(file) ? digest.AddFile(file) : digest.Add("no file");
}

/** The question that is put to the solver, as a digest. The mesh is written. */
std::string QuestionOf(const SolverRun& run, const std::filesystem::path& meshFile)
{
  ContentDigest digest;
  digest.Add(SolverFingerprint(run.Description));
  digest.Add(run.Version);
  for (const auto& [name, value] : run.Options)
  {
    digest.Add(name + '=' + value);
  }
  for (const char* extension : SolverMeshFormat(run.Description.MeshFormat).Extensions)
  {
    AddOwnFile(digest, std::filesystem::path(meshFile).replace_extension(extension));
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
    AddOwnFile(digest, file);
  }
  return "question " + question + "\nanswer " + digest.Finish() + "\n";
}

bool IsSolved(const std::filesystem::path& file, const std::string& question,
  const std::vector<std::filesystem::path>& answers)
{
  const std::string expected = IsOwnFile(file) ? SolvedText(question, answers) : std::string();
  return !expected.empty() && ReadTextFile(file, expected.size() + 1) == expected;
}

/** One attempt in a folder where the mesh file lies. */
SolverOutcome RunOnce(const SolverRun& run, vtkPolyData* mesh, SolverRequest& request, bool isAlone)
{
  SolverFolder& folder = request.Folder;
  const std::string stem = request.MeshFile.stem().string();
  std::vector<std::filesystem::path> expected =
    SolverAnswerFiles(run.Description, folder.GetPath(), stem);
  const std::vector<std::filesystem::path> ours = SolverCallFiles(folder);
  expected.insert(expected.end(), ours.begin(), ours.end());
  folder.NoteNames();
  CallSolver(request, isAlone);
  if (!request.Error.empty())
  {
    return Failure(request.IsMissing ? "not-found" : "not-written", request.Error);
  }
  const SolverOutcome outcome = JudgeEnding(run, request.Result, request.IsFolderTooLarge);
  if (outcome.Status != "ok")
  {
    return outcome;
  }
  std::error_code error;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(folder.GetPath(), error)))
  {
    return Failure("bad-output", NameOfSolver(run) + " has put a link in place of its own folder");
  }
  return JudgeAnswer(run,
    ReadSolverAnswer(
      run.Description, folder.GetPath(), stem, mesh->GetNumberOfPoints(), mesh->GetNumberOfPolys()),
    Explanation(folder, expected, request.Result));
}

/** Whether another attempt may end otherwise. */
bool MayGoWell(const std::string& status)
{
  return status != "ok" && status != "cancelled" && status != "not-found";
}

/** Whatever a solver may have left in their places goes first. */
void WriteMeshFiles(const MeshFormat& format, SolverFolder& folder,
  const std::filesystem::path& meshFile, vtkPolyData* mesh)
{
  folder.Make();
  std::vector<std::filesystem::path> files;
  for (const char* extension : format.Extensions)
  {
    files.push_back(std::filesystem::path(meshFile).replace_extension(extension));
  }
  folder.Remove(files);
  format.Write(meshFile, mesh);
}

SolverOutcome RunInFolder(const SolverRun& run, vtkPolyData* mesh)
{
  const std::string stem = MakeStem(mesh);
  const MeshFormat& format = SolverMeshFormat(run.Description.MeshFormat);
  SolverFolder folder(run.WorkDirectory, stem);
  const std::filesystem::path meshFile = folder.GetPath() / (stem + format.Extensions[0]);
  const std::filesystem::path solved = folder.GetPath() / SolvedFile;
  const std::vector<std::filesystem::path> answers =
    SolverAnswerFiles(run.Description, folder.GetPath(), stem);
  WriteMeshFiles(format, folder, meshFile, mesh);
  const std::string question = QuestionOf(run, meshFile);
  if (run.ReusesAnswer && IsSolved(solved, question, answers))
  {
    return { "ok", "", "",
      ReadSolverAnswer(run.Description, folder.GetPath(), stem, mesh->GetNumberOfPoints(),
        mesh->GetNumberOfPolys()) };
  }
  SolverOutcome outcome;
  SolverRequest request{ run, folder, meshFile, {}, false, false, {}, false };
  bool isAlone = false;
  for (int attempt = 0; attempt <= run.Retries;)
  {
    if (isAlone)
    {
      WriteMeshFiles(format, folder, meshFile, mesh); // the solver may have changed them
    }
    folder.Remove({ solved });
    folder.Remove(answers);
    outcome = RunOnce(run, mesh, request, isAlone);
    if (!MayGoWell(outcome.Status))
    {
      break;
    }
    // Where several meshes went wrong together, one of them may be to blame: that was no attempt.
    attempt += request.IsShared ? 0 : 1;
    isAlone = true;
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
  const MeshFormat& format = SolverMeshFormat(description.MeshFormat);
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
    SolverPlaceholders(run, format, std::string("/mesh") + format.Extensions[0]));
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

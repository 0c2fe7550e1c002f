// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverCommand.h"

#include "ChildProcess.h"
#include "ContentDigest.h"
#include "SolverDescription.h"
#include "SolverFolder.h"
#include "TextFile.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include <dlfcn.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

std::string KnownPlaceholders(const std::map<std::string, std::string>& values)
{
  std::string text;
  for (const auto& [name, value] : values)
  {
    text += (text.empty() ? "{" : " {") + name + '}';
  }
  return text;
}

std::string ExpandArgument(
  const std::string& argument, const std::map<std::string, std::string>& values)
{
  std::string text;
  for (std::size_t i = 0; i < argument.size(); ++i)
  {
    const char c = argument[i];
    if ((c == '{' || c == '}') && i + 1 < argument.size() && argument[i + 1] == c)
    {
      text += c;
      ++i;
      continue;
    }
    if (c != '{')
    {
      text += c;
      continue;
    }
    const std::size_t end = argument.find('}', i);
    if (end == std::string::npos)
    {
      throw std::runtime_error("The argument \"" + argument +
        "\" of the solver's command opens a brace that is never closed; write \"{{\" for a brace.");
    }
    const std::string name = argument.substr(i + 1, end - i - 1);
    const auto value = values.find(name);
    if (value == values.end())
    {
      throw std::runtime_error("The argument \"" + argument +
        "\" of the solver's command has the unknown placeholder {" + name + "}; known are " +
        KnownPlaceholders(values) + ", and \"{{\" is a brace.");
    }
    text += value->second;
    i = end;
  }
  return text;
}

bool IsProgram(const std::filesystem::path& path)
{
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

/** Where programs of PEMesh may be: beside the running one, and in bin beside this library's lib.
 */
std::vector<std::filesystem::path> ProgramFolders()
{
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error)
  {
    folders.push_back(self.parent_path());
  }
  Dl_info library = {};
  if (dladdr(reinterpret_cast<const void*>(&FindSolverProgram), &library) && library.dli_fname)
  {
    const auto file = std::filesystem::weakly_canonical(library.dli_fname, error);
    folders.push_back(file.parent_path().parent_path() / "bin");
  }
  return folders;
}

} // namespace

std::vector<std::string> ExpandCommand(
  const std::vector<std::string>& command, const std::map<std::string, std::string>& values)
{
  std::vector<std::string> arguments;
  for (const std::string& argument : command)
  {
    arguments.push_back(ExpandArgument(argument, values));
  }
  return arguments;
}

std::filesystem::path FindSolverProgram(
  const std::string& program, const std::filesystem::path& folder)
{
  std::error_code error;
  if (program.find('/') != std::string::npos)
  {
    const std::filesystem::path path =
      std::filesystem::absolute(folder / program, error).lexically_normal();
    return std::filesystem::is_regular_file(path, error) ? path : std::filesystem::path();
  }
  std::vector<std::filesystem::path> folders = ProgramFolders();
  const char* variable = std::getenv("PATH");
  std::string path = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t begin = 0; begin < path.size();)
  {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    folders.emplace_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  for (const std::filesystem::path& candidate : folders)
  {
    // An empty entry of PATH means the current folder: never searched, as a matter of safety.
    if (!program.empty() && !candidate.empty() && IsProgram(candidate / program))
    {
      return std::filesystem::absolute(candidate / program, error);
    }
  }
  return {};
}

bool TakesList(const SolverDescription& description)
{
  return std::any_of(description.Command.begin(), description.Command.end(),
    [](const std::string& argument) { return argument.find("{list}") != std::string::npos; });
}

std::string SolverDescriptionFolder(const SolverDescription& description)
{
  const std::filesystem::path& folder = description.Folder;
  std::error_code error;
  return std::filesystem::absolute(folder.empty() ? "." : folder, error)
    .lexically_normal()
    .string();
}

std::string SolverFingerprint(const SolverDescription& description)
{
  ContentDigest digest;
  digest.Add(description.Name);
  digest.Add(description.MeshFormat);
  for (const SolverOption& option : description.Options)
  {
    digest.Add(option.Name + '=' + option.Default);
  }
  for (const SolverPerformance& performance : description.Performances)
  {
    digest.Add(performance.Name + (performance.Measured ? " measured" : ""));
  }
  for (const SolverElementArray& array : description.Elements)
  {
    digest.Add("element " + array.Name);
  }
  for (const std::string& argument : description.Command)
  {
    digest.Add(argument);
    // The size and the time of a program stand for its bytes: an interpreter has millions.
    constexpr std::string_view folder = "{folder}/";
    const bool isScript = argument.rfind(folder, 0) == 0;
    std::filesystem::path file;
    if (argument.rfind('/', 0) == 0)
    {
      file = argument; // a script of an interpreter, may be
    }
    else if (isScript || &argument == &description.Command.front())
    {
      file = isScript ? description.Folder / argument.substr(folder.size())
                      : FindSolverProgram(argument, description.Folder);
    }
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!file.empty() && !error)
    {
      const auto time = std::filesystem::last_write_time(file, error).time_since_epoch().count();
      digest.Add(std::to_string(size) + ' ' + std::to_string(time));
    }
  }
  return digest.Finish();
}

std::string AskSolverVersion(const SolverDescription& description)
{
  if (description.VersionCommand.empty())
  {
    return {};
  }
  try
  {
    const SolverFolder folder({}, "version"); // of its own, gone at the end
    ChildProcess child;
    child.Arguments = ExpandCommand(
      description.VersionCommand, { { "folder", SolverDescriptionFolder(description) } });
    child.Arguments[0] = FindSolverProgram(child.Arguments[0], description.Folder);
    child.WorkingDirectory = folder.GetPath();
    child.OutputFile = folder.GetPath() / "stdout.log";
    child.OutputLimit = 4096;
    child.TimeLimit = 10.0;
    const ChildProcessResult result = RunChildProcess(child);
    if (result.How == ChildProcessResult::Ending::Exited && result.ExitStatus == 0)
    {
      std::string version = ReadTextFile(child.OutputFile);
      version.resize(std::min(version.find_first_of("\r\n"), version.size()));
      return version;
    }
  }
  catch (const std::runtime_error&)
  {
    // A version that cannot be asked for is not known.
  }
  return {};
}

} // namespace pemesh

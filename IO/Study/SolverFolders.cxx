// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverDescriptionFile.h"

#include "NumberText.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <dlfcn.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

/** Folders of an environment variable that is made like PATH. */
std::vector<fs::path> FoldersOfVariable(const char* name)
{
  std::vector<fs::path> folders;
  const char* value = std::getenv(name);
  std::string_view rest = value ? value : "";
  while (!rest.empty())
  {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0)
    {
      folders.emplace_back(rest.substr(0, end));
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return folders;
}

/** The running program, and the library that holds this function: Python runs only the latter. */
std::vector<fs::path> OwnFiles()
{
  std::vector<fs::path> files;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error)
  {
    files.push_back(program);
  }
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&SolverFolders), &info) != 0 && info.dli_fname)
  {
    const fs::path library = fs::weakly_canonical(info.dli_fname, error);
    if (!error)
    {
      files.push_back(library);
    }
  }
  return files;
}

/** share/pemesh/solvers of the prefix that a program or a library was installed into. */
fs::path InstalledFolder(const fs::path& file)
{
  constexpr int deepest = 4; // lib/python3/dist-packages/pemesh
  fs::path prefix = file.parent_path();
  for (int i = 0; i < deepest && prefix != prefix.root_path(); ++i)
  {
    prefix = prefix.parent_path();
    std::error_code error;
    if (fs::is_directory(prefix / PEMESH_SOLVERS_INSTALL_FOLDER, error))
    {
      return prefix / PEMESH_SOLVERS_INSTALL_FOLDER;
    }
  }
  return {};
}

bool IsInside(const fs::path& file, const fs::path& folder)
{
  std::error_code error;
  const fs::path full = fs::weakly_canonical(folder, error);
  return !error &&
    std::mismatch(full.begin(), full.end(), file.begin(), file.end()).first == full.end();
}

std::string ShowFolders(const std::vector<fs::path>& folders)
{
  std::string text;
  for (const fs::path& folder : folders)
  {
    text += (text.empty() ? "\"" : ", \"") + folder.string() + "\"";
  }
  return text.empty() ? "no folder" : text;
}

} // namespace

std::vector<fs::path> SolverFolders()
{
  std::vector<fs::path> folders = FoldersOfVariable("PEMESH_SOLVERS");
  for (const fs::path& file : OwnFiles())
  {
    const fs::path folder = IsInside(file, PEMESH_BUILD_FOLDER)
      ? fs::path(PEMESH_SOLVERS_SOURCE_FOLDER)
      : InstalledFolder(file);
    if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end())
    {
      folders.push_back(folder);
    }
  }
  return folders;
}

std::vector<FoundSolver> ListSolvers(const std::vector<fs::path>& folders)
{
  std::vector<FoundSolver> all;
  std::set<std::string> seen;
  for (const fs::path& folder : folders)
  {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
    {
      if (entry->path().extension() == ".json")
      {
        files.push_back(entry->path());
      }
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
    {
      FoundSolver found;
      found.File = file;
      try
      {
        found.Description = ReadSolverDescription(file);
      }
      catch (const std::runtime_error& problem)
      {
        found.Description.Name = file.stem().string();
        found.Error = problem.what();
      }
      if (seen.insert(found.Description.Name).second)
      {
        all.push_back(std::move(found));
      }
    }
  }
  std::sort(all.begin(), all.end(),
    [](const FoundSolver& a, const FoundSolver& b)
    {
      const std::string& first = a.Description.Name;
      const std::string& second = b.Description.Name;
      return std::pair(first != BundledSolver, first) < std::pair(second != BundledSolver, second);
    });
  return all;
}

SolverDescription FindSolver(
  const std::string& nameOrFile, const fs::path& base, const std::vector<fs::path>& folders)
{
  if (fs::path(nameOrFile).extension() == ".json")
  {
    return ReadSolverDescription((base / nameOrFile).lexically_normal());
  }
  std::vector<std::string> names;
  for (const FoundSolver& found : ListSolvers(folders))
  {
    names.push_back(found.Description.Name);
    if (found.Description.Name == nameOrFile)
    {
      if (!found.Error.empty())
      {
        throw std::runtime_error(found.Error);
      }
      return found.Description;
    }
  }
  const std::string nearest = NearestWord(nameOrFile, names);
  throw std::runtime_error("No solver is called \"" + nameOrFile + "\"" +
    (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") + " (looked in " +
    ShowFolders(folders) + "; PEMESH_SOLVERS adds folders.)");
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFolder.h"

#include "HalfWrittenFiles.h"
#include "MeshFormats.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFile.h"

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace pemesh
{

namespace
{

/** The files of a mesh in one format: some have two. */
std::vector<std::string> MeshFileNames(const Study& study, const std::string& mesh)
{
  std::vector<std::string> names;
  for (const std::string& name : study.Output.Formats)
  {
    if (const MeshFormat* format = FindMeshFormat(name))
    {
      for (const auto& extension : format->Extensions)
      {
        names.push_back(mesh + extension);
      }
    }
  }
  return names;
}

/** Only of the folder itself, whatever a document has for a name. */
void RemoveInside(const fs::path& folder, const std::string& name)
{
  const fs::path path = (folder / name).lexically_normal();
  std::error_code ignored;
  if (!name.empty() && path.parent_path() == folder.lexically_normal())
  {
    fs::remove_all(path, ignored);
  }
}

std::set<std::string> NamesOf(const std::vector<StudyCase>& cases)
{
  std::set<std::string> names;
  for (const StudyCase& studyCase : cases)
  {
    names.insert(studyCase.Name);
  }
  return names;
}

void RemoveMeshesAndSolutions(
  const fs::path& folder, const Study& old, const std::set<std::string>& current)
{
  for (const StudyCase& studyCase : MakeStudyCases(old))
  {
    if (current.count(studyCase.Name) > 0)
    {
      continue;
    }
    RemoveMeshFiles(folder / "meshes", old, studyCase);
    for (const StudySolver& run : old.Solvers)
    {
      RemoveInside(folder / "solvers" / run.Name, studyCase.Name);
    }
  }
}

} // namespace

void CheckStudyFolder(const fs::path& folder)
{
  if (fs::exists(folder) && !fs::is_directory(folder))
  {
    throw std::runtime_error(
      "The output \"" + folder.string() + "\" is a file; name a folder with -o.");
  }
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / "study.json") &&
    !fs::exists(folder / "journal.tsv"))
  {
    throw std::runtime_error("The output folder \"" + folder.string() +
      "\" holds something else than the results of a study; name another one with -o.");
  }
}

void RemoveMeshFiles(const fs::path& folder, const Study& study, const StudyCase& studyCase)
{
  for (const std::string& name : MeshFileNames(study, studyCase.Name))
  {
    RemoveInside(folder, name);
  }
}

bool HasMeshFilesOf(const fs::path& folder, const Study& study, const StudyCase& studyCase)
{
  for (const std::string& name : MeshFileNames(study, studyCase.Name))
  {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(folder / name, error);
    if (error || size == 0)
    {
      return false;
    }
  }
  return true;
}

void RemoveStaleFiles(
  const fs::path& folder, const Study& study, const std::vector<StudyCase>& cases, bool goesOn)
{
  for (const char* part : { "", "meshes", "plots" })
  {
    RemoveHalfWrittenFiles(*part ? folder / part : folder);
  }
  if (!goesOn)
  {
    for (const char* table : { "results.csv", "timings.csv", "correlation.csv", "failures.csv",
           "index.csv", "series.pvd" })
    {
      RemoveInside(folder, table);
    }
  }
  try
  {
    const Study old = ReadStudy(folder / "study.json");
    std::set<std::string> plots;
    for (const StudyPlot& plot : study.Plots)
    {
      plots.insert(plot.File);
    }
    for (const StudyPlot& plot : old.Plots)
    {
      RemoveInside(folder / "plots", plots.count(plot.File) > 0 ? "" : plot.File);
    }
    RemoveMeshesAndSolutions(folder, old, NamesOf(cases));
  }
  catch (const std::exception&)
  {
    return; // no study was run here, or its files are gone: nothing is known of it
  }
}

} // namespace pemesh

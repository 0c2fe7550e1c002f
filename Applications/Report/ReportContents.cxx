// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportContents.h"

#include "ChartStyleFile.h"
#include "ColumnRoles.h"
#include "CsvTable.h"
#include "MeshFormats.h"
#include "SolverDescriptionFile.h"
#include "StudyFile.h"
#include "TextFile.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace fs = std::filesystem;

namespace
{

vtkSmartPointer<vtkTable> ReadOptional(
  const fs::path& file, const std::string& what, ReportContents& contents)
{
  if (fs::exists(file))
  {
    try
    {
      return ReadCsvFile(file);
    }
    catch (const std::exception& error)
    {
      contents.Remarks.push_back(what + " cannot be shown: " + error.what());
    }
  }
  return nullptr;
}

/** The last line of the sentences. */
std::string ReadNote(const fs::path& file)
{
  if (!fs::exists(file))
  {
    return {};
  }
  const std::string text = ReadTextFile(file);
  const std::size_t start = text.rfind("Note: ");
  return start == std::string::npos ? std::string()
                                    : text.substr(start, text.find('\n', start) - start);
}

/** Without the descriptions of its solvers a page has plainer titles, nothing worse. */
void FindLabels(ReportContents& contents)
{
  try
  {
    Study study = contents.TheStudy;
    contents.Solvers = FindStudySolvers(study);
    contents.Labels = ColumnLabels(study, contents.Solvers);
  }
  catch (const std::exception& error)
  {
    contents.Solvers.clear();
    contents.Remarks.push_back(
      std::string("Performances have no titles, as a solver is not known here: ") + error.what());
  }
}

/** The copy of the study in the folder names files of styles relative to itself. */
void ReadStyle(ReportContents& contents)
{
  try
  {
    contents.Style = MakeChartStyle(contents.Folder, { contents.TheStudy.Style });
  }
  catch (const std::exception& error)
  {
    contents.Remarks.push_back(std::string("Figures have the default style: ") + error.what());
  }
}

/** The file of a mesh in whatever format the study wrote, best with its arrays, or "". */
fs::path FileOfMesh(const ReportContents& contents, const std::string& name)
{
  const fs::path stem = contents.Folder / "meshes" / name;
  fs::path found;
  for (const MeshFormat& format : MeshFormats())
  {
    const fs::path file = stem.string() + format.Extensions.front();
    if ((found.empty() || format.KeepsArrays) && fs::exists(file))
    {
      found = file;
    }
  }
  return found;
}

void ReadShownMeshes(ReportContents& contents)
{
  std::vector<std::pair<std::string, fs::path>> written;
  if (contents.Results->GetColumnByName("Mesh"))
  {
    for (const std::string& name : ColumnTexts(contents.Results, "Mesh"))
    {
      if (fs::path file = FileOfMesh(contents, name); !file.empty())
      {
        written.emplace_back(name, std::move(file));
      }
    }
  }
  if (written.empty())
  {
    contents.Remarks.emplace_back("No mesh is shown: the folder meshes holds none.");
    return;
  }
  const std::size_t last = written.size() - 1;
  std::vector<std::pair<std::size_t, const char*>> wanted{ { 0, "First" } };
  if (last > 1)
  {
    wanted.emplace_back(last / 2, "Middle");
  }
  if (last > 0)
  {
    wanted.emplace_back(last, "Last");
  }
  for (const auto& [index, place] : wanted)
  {
    try
    {
      contents.Meshes.push_back({ written[index].first, place, ReadMesh(written[index].second) });
    }
    catch (const std::exception& error)
    {
      contents.Remarks.push_back(
        "The mesh " + written[index].first + " cannot be shown: " + error.what());
    }
  }
}

} // namespace

std::string ReportContents::Abscissa() const
{
  for (const StudySweep& sweep : this->TheStudy.Sweep)
  {
    if (vtkDataArray::SafeDownCast(this->Results->GetColumnByName(sweep.Name.c_str())))
    {
      return this->TheStudy.Sweep.size() == 1 ? sweep.Name : "Index";
    }
  }
  return "Index";
}

std::string ReportContents::ColorColumn() const
{
  const std::string& family = this->TheStudy.Statistics.Family;
  return this->Results->GetColumnByName(family.c_str()) ? family : this->Abscissa();
}

std::vector<std::string> ReportContents::Performances() const
{
  return PerformanceColumns(this->Results);
}

std::vector<ReportMeasure> ReportContents::Measures() const
{
  std::vector<ReportMeasure> measures;
  std::map<std::string, std::size_t> known; // by the name of the performance
  for (const std::string& column : this->Performances())
  {
    std::string run;
    for (const StudySolver& solver : this->TheStudy.Solvers)
    {
      const bool longer = solver.Name.size() > run.size();
      run = longer && column.starts_with(solver.Name + "_") ? solver.Name : run;
    }
    const std::string name = run.empty() ? column : column.substr(run.size() + 1);
    const auto [place, isNew] = known.emplace(name, measures.size());
    if (isNew)
    {
      // The title of a column of one of several runs ends in the name of the run.
      std::string title = this->Labels.Title(column);
      const std::string ending = ", " + run;
      title.resize(title.size() - (!run.empty() && title.ends_with(ending) ? ending.size() : 0));
      measures.push_back({ title, {}, {} });
    }
    measures[place->second].Columns.push_back(column);
    measures[place->second].Runs.push_back(run);
  }
  return measures;
}

bool ReportContents::IsLogarithmic(const std::string& performance) const
{
  for (std::size_t i = 0; i < this->Solvers.size(); ++i)
  {
    for (const SolverPerformance& known : this->Solvers[i].Performances)
    {
      if (performance == this->TheStudy.Solvers[i].Name + "_" + known.Name)
      {
        return known.Scale == "log";
      }
    }
  }
  return false;
}

ReportContents ReadReportContents(const fs::path& folder)
{
  if (!fs::exists(folder / "results.csv") || !fs::exists(folder / "study.json"))
  {
    throw std::runtime_error("The folder \"" + folder.string() +
      "\" does not hold the results of a study (study.json and results.csv): make them with "
      "\"pemesh run\".");
  }
  ReportContents contents;
  contents.Folder = folder;
  contents.Document = ReadTextFile(folder / "study.json");
  contents.TheStudy = ReadStudy(folder / "study.json");
  contents.Results = ReadCsvFile(folder / "results.csv");
  contents.Findings = ReadOptional(folder / "findings.csv", "The findings", contents);
  contents.Failures = ReadOptional(folder / "failures.csv", "The failures", contents);
  contents.Note = ReadNote(folder / "findings.txt");
  ReadStyle(contents);
  FindLabels(contents);
  ReadShownMeshes(contents);
  return contents;
}

} // namespace pemesh

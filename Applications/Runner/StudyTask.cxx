// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyTask.h"

#include "NumberText.h"
#include "SolverDescriptionFile.h"
#include "StudyFile.h"

#include <stdexcept>

namespace pemesh
{

namespace
{

/** Reads the fields of a message one after the other. */
class FieldReader
{
public:
  explicit FieldReader(const std::vector<std::string>& fields)
    : Fields(fields)
  {
  }

  const std::string& Text() { return this->Fields.at(this->Next++); }
  int Integer() { return static_cast<int>(ParseInteger(this->Text()).value_or(0)); }
  double Number() { return ParseNumber(this->Text()).value_or(0.0); }
  std::vector<std::string> List()
  {
    std::vector<std::string> list(static_cast<std::size_t>(this->Integer()));
    for (std::string& text : list)
    {
      text = this->Text();
    }
    return list;
  }

private:
  const std::vector<std::string>& Fields;
  std::size_t Next = 0;
};

void AppendList(std::vector<std::string>& fields, const std::vector<std::string>& list)
{
  fields.push_back(std::to_string(list.size()));
  fields.insert(fields.end(), list.begin(), list.end());
}

} // namespace

LoadedStudy LoadStudy(const StudyTask& task)
{
  LoadedStudy loaded;
  Study& study = loaded.TheStudy;
  study = ParseStudy(task.Text, task.Source);
  study.WrittenBy = "PEMesh " PEMESH_VERSION;
  if (task.MeshesOnly)
  {
    study.Metrics.Names.clear();
    study.Solvers.clear();
    study.Plots.clear();
  }
  if (!task.Formats.empty())
  {
    study.Output.Formats = task.Formats;
  }
  loaded.Solvers = FindStudySolvers(study);
  for (std::size_t i = 0; i < task.Versions.size(); ++i)
  {
    study.Solvers.at(i).Version = task.Versions[i];
  }
  loaded.Cases = MakeStudyCases(study);
  return loaded;
}

std::vector<std::string> FieldsOfTask(const StudyTask& task)
{
  const CaseWorkers::Options& options = task.Options;
  std::vector<std::string> fields{ task.Text, task.Source.string(),
    std::to_string(task.MeshesOnly ? 1 : 0), options.Folder.string(), options.MeshFolder.string(),
    std::to_string(options.Workers), std::to_string(options.Resume ? 1 : 0),
    std::to_string(options.Retries), FormatNumber(options.SolverMemory) };
  AppendList(fields, task.Formats);
  AppendList(fields, task.Versions);
  return fields;
}

StudyTask TaskOfFields(const std::vector<std::string>& fields)
{
  FieldReader reader(fields);
  StudyTask task;
  task.Text = reader.Text();
  task.Source = reader.Text();
  task.MeshesOnly = reader.Integer() != 0;
  task.Options.Folder = reader.Text();
  task.Options.MeshFolder = reader.Text();
  task.Options.Workers = reader.Integer();
  task.Options.Resume = reader.Integer() != 0;
  task.Options.Retries = reader.Integer();
  task.Options.SolverMemory = reader.Number();
  task.Formats = reader.List();
  task.Versions = reader.List();
  return task;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyResults.h"

#include "CaseStatus.h"
#include "CsvTable.h"
#include "NumberText.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyJournal.h"
#include "TableRows.h"
#include "TextFile.h"
#include "XmlText.h"

#include <algorithm>
#include <iterator>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

std::string TextOf(vtkTable* row, const std::string& column)
{
  auto* array = vtkStringArray::SafeDownCast(row->GetColumnByName(column.c_str()));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

bool IsText(const StudyScalar& value)
{
  return !std::holds_alternative<double>(value) && !std::holds_alternative<std::int64_t>(value);
}

void AddValueColumn(vtkTable* table, const SweptValue& swept)
{
  IsText(swept.Value) ? void(AddColumn<vtkStringArray>(table, swept.Name.c_str()))
                      : void(AddColumn<vtkDoubleArray>(table, swept.Name.c_str()));
}

vtkVariant VariantOf(const StudyScalar& value)
{
  return IsText(value) ? vtkVariant(FormatScalar(value)) : vtkVariant(ScalarToNumber(value));
}

/** Sentences name files of this machine: they go to failures.csv, never into the results. */
void RemoveMessages(vtkTable* results, const std::vector<std::string>& runs)
{
  results->RemoveColumnByName("StatusMessage");
  for (const std::string& run : runs)
  {
    results->RemoveColumnByName((run + "_StatusMessage").c_str());
  }
}

} // namespace

std::string SentenceOf(const StudyFailure& failure)
{
  return failure.Mesh + ": " + (failure.Stage == "mesh" ? std::string() : failure.Stage + ": ") +
    failure.Message;
}

vtkSmartPointer<vtkPolyData> WithoutMeasured(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  vtkFieldData* fields = copy->GetFieldData();
  if (auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray(MeasuredList)))
  {
    const vtkSmartPointer<vtkStringArray> kept = names; // outlives its removal
    for (vtkIdType i = 0; i < kept->GetNumberOfValues(); ++i)
    {
      fields->RemoveArray(kept->GetValue(i).c_str());
    }
    fields->RemoveArray(MeasuredList);
  }
  return copy;
}

StudyResults::StudyResults(
  const Study& study, const std::vector<StudyCase>& cases, StudyJournal& journal)
  : Cases(cases)
  , Journal(journal)
{
  for (const StudySolver& solver : study.Solvers)
  {
    this->Runs.push_back(solver.Name);
  }
}

StudyResults::~StudyResults() = default;

std::string StudyResults::AddRow(const StudyCase& studyCase, const std::string& key, vtkTable* row)
{
  bool mayGoWell = false;
  std::string sentences;
  for (const StudyFailure& failure : this->FailuresOf(studyCase, row))
  {
    mayGoWell = mayGoWell || failure.Stage != "mesh";
    sentences += (sentences.empty() ? "" : "\n") + SentenceOf(failure);
  }
  this->Journal.Append(studyCase.Index, mayGoWell ? "" : key, row);
  return sentences.empty()
    ? studyCase.Name + ": " + row->GetValueByName(0, "Elements").ToString() + " elements"
    : sentences;
}

void StudyResults::AddFailure(const StudyFailure& failure)
{
  const std::scoped_lock lock(this->Mutex);
  this->NotWritten.push_back(failure);
}

std::vector<StudyFailure> StudyResults::FailuresOf(const StudyCase& studyCase, vtkTable* row) const
{
  std::vector<StudyFailure> failures;
  {
    const std::scoped_lock lock(this->Mutex);
    std::copy_if(this->NotWritten.begin(), this->NotWritten.end(), std::back_inserter(failures),
      [&](const StudyFailure& failure) { return failure.Index == studyCase.Index; });
  }
  const std::string status = TextOf(row, "Status");
  if (!status.empty() && status != "ok")
  {
    failures.push_back(
      { studyCase.Index, studyCase.Name, "mesh", status, TextOf(row, "StatusMessage") });
    return failures; // what follows from it is no failure of its own
  }
  for (const std::string& run : this->Runs)
  {
    const std::string runStatus = TextOf(row, run + "_Status");
    if (!runStatus.empty() && runStatus != "ok")
    {
      failures.push_back(
        { studyCase.Index, studyCase.Name, run, runStatus, TextOf(row, run + "_StatusMessage") });
    }
  }
  return failures;
}

void StudyResults::Finish()
{
  this->Failures.clear();
  this->Results = vtkSmartPointer<vtkTable>::New();
  this->Index = vtkSmartPointer<vtkTable>::New();
  auto* meshIndex = AddColumn<vtkIdTypeArray>(this->Index, "Index");
  auto* meshName = AddColumn<vtkStringArray>(this->Index, "Mesh");
  for (const SweptValue& swept : this->Cases.front().Values)
  {
    AddValueColumn(this->Index, swept);
  }
  vtkNew<vtkTable> all;
  for (const StudyCase& studyCase : this->Cases)
  {
    if (!this->Journal.Has(studyCase.Index))
    {
      continue;
    }
    const vtkSmartPointer<vtkTable> row = this->Journal.Read(studyCase.Index);
    const std::vector<StudyFailure> failures = this->FailuresOf(studyCase, row);
    this->Failures.insert(this->Failures.end(), failures.begin(), failures.end());
    AppendTableRows(all, row);
    meshIndex->InsertNextValue(studyCase.Index);
    meshName->InsertNextValue(studyCase.Name);
    for (const SweptValue& swept : studyCase.Values)
    {
      this->Index->GetColumnByName(swept.Name.c_str())
        ->InsertVariantValue(meshIndex->GetNumberOfValues() - 1, VariantOf(swept.Value));
    }
  }
  this->Timings = vtkSmartPointer<vtkTable>::New();
  this->Timings->AddColumn(meshIndex);
  this->Timings->AddColumn(meshName);
  this->Results->AddColumn(meshIndex);
  for (vtkIdType column = 0; column < all->GetNumberOfColumns(); ++column)
  {
    const bool measured = IsInFieldList(all, MeasuredList, all->GetColumnName(column));
    (measured ? this->Timings : this->Results)->AddColumn(all->GetColumn(column));
  }
  RemoveMessages(this->Results, this->Runs);
}

vtkSmartPointer<vtkTable> StudyResults::FailureTable() const
{
  auto table = vtkSmartPointer<vtkTable>::New();
  auto* index = AddColumn<vtkIdTypeArray>(table, "Index");
  auto* mesh = AddColumn<vtkStringArray>(table, "Mesh");
  auto* stage = AddColumn<vtkStringArray>(table, "Stage");
  auto* status = AddColumn<vtkStringArray>(table, "Status");
  auto* message = AddColumn<vtkStringArray>(table, "Message");
  for (const StudyFailure& failure : this->Failures)
  {
    index->InsertNextValue(failure.Index);
    mesh->InsertNextValue(failure.Mesh);
    stage->InsertNextValue(failure.Stage);
    status->InsertNextValue(failure.Status);
    message->InsertNextValue(failure.Message);
  }
  return table;
}

void StudyResults::Write(const std::filesystem::path& folder, bool indexOnly) const
{
  if (!indexOnly)
  {
    WriteCsvFile(folder / "results.csv", this->Results);
    WriteCsvFile(folder / "timings.csv", this->Timings);
  }
  WriteCsvFile(folder / "index.csv", this->Index);
  if (!this->Failures.empty())
  {
    WriteCsvFile(folder / "failures.csv", this->FailureTable());
  }
  else
  {
    std::filesystem::remove(folder / "failures.csv");
  }
}

void StudyResults::WriteSeries(
  const std::filesystem::path& folder, const std::filesystem::path& meshes) const
{
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                     "  <Collection>\n";
  for (const StudyCase& studyCase : this->Cases)
  {
    const std::filesystem::path file = meshes / (studyCase.Name + ".vtp");
    if (this->Journal.Has(studyCase.Index) && std::filesystem::exists(folder / file))
    {
      const bool isFamily =
        studyCase.Values.size() == 1 && studyCase.Values[0].Parameter == DeformationParameter;
      text += "    <DataSet timestep=\"" +
        FormatNumber(isFamily ? studyCase.Time : static_cast<double>(studyCase.Index)) +
        "\" part=\"0\" file=\"" + EscapeXml(file.generic_string()) + "\"/>\n";
    }
  }
  text += "  </Collection>\n</VTKFile>\n";
  WriteTextFile(folder / "series.pvd", text);
}

} // namespace pemesh

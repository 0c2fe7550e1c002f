// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PooledTable.h"

#include "CaseStatus.h"
#include "ColumnRoles.h"
#include "NumberText.h"
#include "TableRows.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace pemesh
{

namespace
{

/** The same rows with the study of each in the first column. */
vtkSmartPointer<vtkTable> WithStudyColumn(vtkTable* table, const std::string& study)
{
  vtkNew<vtkStringArray> column;
  column->SetName(StudyColumn);
  column->SetNumberOfValues(table->GetNumberOfRows());
  std::fill_n(column->GetPointer(0), table->GetNumberOfRows(), study);
  auto rows = vtkSmartPointer<vtkTable>::New();
  rows->AddColumn(column);
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    rows->AddColumn(table->GetColumn(i));
  }
  rows->GetFieldData()->ShallowCopy(table->GetFieldData());
  return rows;
}

/** Where the rows of a table find their partners. */
class RowsByMesh
{
public:
  RowsByMesh(vtkTable* table, vtkTable* performances, const std::string& source)
    : Source("\"" + source + "\"")
    , UsesStudy(table->GetColumnByName(StudyColumn) && performances->GetColumnByName(StudyColumn))
  {
    for (const auto& [which, name] : { std::pair(table, std::string("The table of results")),
           std::pair(performances, this->Source) })
    {
      if (!which->GetColumnByName(MeshNameField))
      {
        throw std::runtime_error(
          name + " has no column \"Mesh\" with the names of the meshes to join by.");
      }
    }
    const std::vector<std::string> keys = this->Keys(table);
    for (std::size_t row = 0; row < keys.size(); ++row)
    {
      this->Rows[keys[row]].push_back(static_cast<vtkIdType>(row));
    }
  }

  /** The row of the table for every row of the performances. */
  std::vector<vtkIdType> Partners(vtkTable* performances) const
  {
    std::vector<vtkIdType> partners;
    std::set<std::string> seen;
    for (const std::string& key : this->Keys(performances))
    {
      const auto found = this->Rows.find(key);
      if (found == this->Rows.end())
      {
        this->FailUnknown(key);
      }
      if (found->second.size() > 1)
      {
        throw std::runtime_error(this->Source + " names the mesh \"" + key + "\", which " +
          std::to_string(found->second.size()) +
          " rows of the results have: add a column \"Study\" that tells them apart.");
      }
      if (!seen.insert(key).second)
      {
        throw std::runtime_error(
          this->Source + " names the mesh \"" + key + "\" twice: leave one row.");
      }
      partners.push_back(found->second.front());
    }
    return partners;
  }

private:
  std::vector<std::string> Keys(vtkTable* table) const
  {
    std::vector<std::string> keys = ColumnTexts(table, MeshNameField);
    if (this->UsesStudy)
    {
      const std::vector<std::string> studies = ColumnTexts(table, StudyColumn);
      for (std::size_t row = 0; row < keys.size(); ++row)
      {
        keys[row] = studies[row] + ": " + keys[row];
      }
    }
    return keys;
  }

  [[noreturn]] void FailUnknown(const std::string& key) const
  {
    std::vector<std::string> known;
    for (const auto& [name, rows] : this->Rows)
    {
      known.push_back(name);
    }
    const std::string nearest = NearestWord(key, known);
    throw std::runtime_error(this->Source + " names the mesh \"" + key +
      "\", which the results have not" +
      (nearest.empty() ? std::string(".") : "; the nearest is \"" + nearest + "\"."));
  }

  std::string Source;
  bool UsesStudy;
  std::map<std::string, std::vector<vtkIdType>> Rows;
};

vtkSmartPointer<vtkAbstractArray> SpreadColumn(
  vtkAbstractArray* column, const std::vector<vtkIdType>& partners, vtkIdType rows)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(column))
  {
    auto spread = vtkSmartPointer<vtkDoubleArray>::New();
    spread->SetNumberOfValues(rows);
    spread->FillValue(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < partners.size(); ++i)
    {
      spread->SetValue(partners[i], numbers->GetComponent(static_cast<vtkIdType>(i), 0));
    }
    return spread;
  }
  auto spread = vtkSmartPointer<vtkStringArray>::New();
  spread->SetNumberOfValues(rows);
  for (std::size_t i = 0; i < partners.size(); ++i)
  {
    spread->SetValue(partners[i], column->GetVariantValue(static_cast<vtkIdType>(i)).ToString());
  }
  return spread;
}

} // namespace

vtkSmartPointer<vtkTable> PoolStudies(const std::vector<NamedTable>& studies)
{
  if (studies.size() == 1)
  {
    return studies.front().second;
  }
  auto pooled = vtkSmartPointer<vtkTable>::New();
  std::set<std::string> taken;
  for (const auto& [name, table] : studies)
  {
    std::string study = name;
    for (int number = 2; !taken.insert(study).second; ++number)
    {
      study = name + "-" + std::to_string(number);
    }
    const bool hasStudies = table->GetColumnByName(StudyColumn) != nullptr;
    AppendTableRows(pooled, hasStudies ? table : WithStudyColumn(table, study));
  }
  return pooled;
}

void JoinPerformances(vtkTable* table, vtkTable* performances, const std::string& source)
{
  const std::vector<vtkIdType> partners =
    RowsByMesh(table, performances, source).Partners(performances);
  std::vector<vtkSmartPointer<vtkAbstractArray>> added;
  for (vtkIdType i = 0; i < performances->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = performances->GetColumn(i);
    const std::string name = column->GetName();
    if (name == MeshNameField || name == StudyColumn)
    {
      continue;
    }
    if (table->GetColumnByName(name.c_str()))
    {
      throw std::runtime_error("\"" + source + "\" has the column \"" + name +
        "\", which the results have already: give it another name.");
    }
    added.push_back(SpreadColumn(column, partners, table->GetNumberOfRows()));
    added.back()->SetName(name.c_str());
  }
  if (added.empty())
  {
    throw std::runtime_error(
      "\"" + source + "\" has no column besides the names of the meshes: nothing to join.");
  }
  for (const auto& column : added)
  {
    table->AddColumn(column);
    if (vtkDataArray::SafeDownCast(column))
    {
      AddToFieldList(table, PerformancesList, column->GetName());
    }
  }
}

} // namespace pemesh

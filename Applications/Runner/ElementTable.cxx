// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTable.h"

#include <algorithm>
#include <limits>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

using NamedTables = std::vector<std::pair<std::string, vtkSmartPointer<vtkTable>>>;

/** Names of columns in the order in which they first come. */
std::vector<std::string> ColumnsOf(const NamedTables& tables)
{
  std::vector<std::string> names;
  for (const auto& [name, table] : tables)
  {
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      const std::string column = table->GetColumnName(i);
      if (std::find(names.begin(), names.end(), column) == names.end())
      {
        names.push_back(column);
      }
    }
  }
  return names;
}

bool HoldsText(const NamedTables& tables, const std::string& column)
{
  return std::any_of(tables.begin(), tables.end(),
    [&column](const auto& entry)
    { return vtkStringArray::SafeDownCast(entry.second->GetColumnByName(column.c_str())); });
}

vtkSmartPointer<vtkAbstractArray> StackTexts(const NamedTables& tables, const std::string& column)
{
  auto texts = vtkSmartPointer<vtkStringArray>::New();
  for (const auto& [name, table] : tables)
  {
    vtkAbstractArray* array = table->GetColumnByName(column.c_str());
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      texts->InsertNextValue(array ? array->GetVariantValue(row).ToString() : vtkStdString());
    }
  }
  return texts;
}

vtkSmartPointer<vtkAbstractArray> StackNumbers(const NamedTables& tables, const std::string& column)
{
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  for (const auto& [name, table] : tables)
  {
    auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column.c_str()));
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      numbers->InsertNextValue(
        array ? array->GetComponent(row, 0) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return numbers;
}

vtkSmartPointer<vtkStringArray> NamesOfRows(const NamedTables& tables)
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName("Mesh");
  for (const auto& [name, table] : tables)
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      names->InsertNextValue(name);
    }
  }
  return names;
}

} // namespace

vtkSmartPointer<vtkTable> StackTables(const NamedTables& tables)
{
  if (tables.size() == 1)
  {
    return tables.front().second;
  }
  auto stacked = vtkSmartPointer<vtkTable>::New();
  const std::vector<std::string> columns = ColumnsOf(tables);
  if (std::find(columns.begin(), columns.end(), "Mesh") == columns.end())
  {
    stacked->AddColumn(NamesOfRows(tables));
  }
  for (const std::string& column : columns)
  {
    auto array =
      HoldsText(tables, column) ? StackTexts(tables, column) : StackNumbers(tables, column);
    array->SetName(column.c_str());
    stacked->AddColumn(array);
  }
  return stacked;
}

vtkSmartPointer<vtkTable> MakeElementTable(
  const std::vector<std::pair<std::string, vtkPolyData*>>& meshes)
{
  NamedTables tables;
  for (const auto& [name, mesh] : meshes)
  {
    auto table = vtkSmartPointer<vtkTable>::New();
    vtkNew<vtkStringArray> names;
    vtkNew<vtkIdTypeArray> elements;
    names->SetName("Mesh");
    elements->SetName("Element");
    for (vtkIdType element = 0; element < mesh->GetNumberOfCells(); ++element)
    {
      names->InsertNextValue(name);
      elements->InsertNextValue(element);
    }
    table->AddColumn(names);
    table->AddColumn(elements);
    for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = mesh->GetCellData()->GetArray(i);
      if (array && array->GetName())
      {
        table->AddColumn(array);
      }
    }
    tables.emplace_back(name, table);
  }
  return StackTables(tables);
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTable.h"

#include "TableRows.h"

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

/** The table behind a column `Mesh` that says whose rows they are, if it has none. */
vtkSmartPointer<vtkTable> WithMesh(const std::string& name, vtkTable* table)
{
  auto named = vtkSmartPointer<vtkTable>::New();
  if (!table->GetColumnByName("Mesh"))
  {
    vtkNew<vtkStringArray> names;
    names->SetName("Mesh");
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      names->InsertNextValue(name);
    }
    named->AddColumn(names);
  }
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    named->AddColumn(table->GetColumn(i));
  }
  return named;
}

} // namespace

vtkSmartPointer<vtkTable> StackTables(const NamedTables& tables)
{
  if (tables.size() == 1)
  {
    return tables.front().second;
  }
  auto stacked = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, table] : tables)
  {
    AppendTableRows(stacked, WithMesh(name, table));
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

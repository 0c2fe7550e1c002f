// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Small tables for tests.
 */
#ifndef pemesh_TestTables_h
#define pemesh_TestTables_h

#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <string>
#include <vector>

template <typename Array>
struct ValueOf
{
  using Type = typename Array::ValueType;
};

template <>
struct ValueOf<vtkStringArray>
{
  using Type = std::string;
};

template <typename Array>
void AddColumn(vtkTable* table, const std::string& name,
  const std::vector<typename ValueOf<Array>::Type>& values)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  for (const auto& value : values)
  {
    column->InsertNextValue(value);
  }
  table->AddColumn(column);
}

inline std::vector<std::string> ColumnNames(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    names.emplace_back(table->GetColumnName(i));
  }
  return names;
}

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TableRows.h"

#include "CaseStatus.h"
#include "ColumnRoles.h"
#include "NumberText.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pemesh
{

namespace
{

using Kind = ColumnKind;
using Column = vtkSmartPointer<vtkAbstractArray>;

std::string TextOf(vtkAbstractArray* source, vtkIdType row)
{
  if (KindOfColumn(source) != Kind::Number)
  {
    return source->GetVariantValue(row).ToString();
  }
  const double value = vtkDataArray::SafeDownCast(source)->GetComponent(row, 0);
  return std::isnan(value) ? std::string() : FormatNumber(value);
}

/** `target` is of the kind of the source or a larger one. */
void AppendValue(vtkAbstractArray* target, vtkAbstractArray* source, vtkIdType row)
{
  if (auto* text = vtkStringArray::SafeDownCast(target))
  {
    text->InsertNextValue(TextOf(source, row));
  }
  else if (auto* integers = vtkIdTypeArray::SafeDownCast(target))
  {
    integers->InsertNextValue(static_cast<vtkIdType>(source->GetVariantValue(row).ToLongLong()));
  }
  else
  {
    vtkDoubleArray::SafeDownCast(target)->InsertNextValue(
      vtkDataArray::SafeDownCast(source)->GetComponent(row, 0));
  }
}

void AppendMissing(vtkAbstractArray* target)
{
  if (auto* text = vtkStringArray::SafeDownCast(target))
  {
    text->InsertNextValue("");
  }
  else
  {
    vtkDoubleArray::SafeDownCast(target)->InsertNextValue(std::numeric_limits<double>::quiet_NaN());
  }
}

Column Promote(vtkAbstractArray* array, Kind kind)
{
  Column promoted = NewColumn(kind, array->GetName());
  for (vtkIdType row = 0; row < array->GetNumberOfTuples(); ++row)
  {
    AppendValue(promoted, array, row);
  }
  return promoted;
}

std::vector<Column> ColumnsOf(vtkTable* table)
{
  std::vector<Column> columns;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    columns.emplace_back(table->GetColumn(i));
  }
  return columns;
}

void SetColumns(vtkTable* table, const std::vector<Column>& columns)
{
  table->GetRowData()->Initialize();
  for (const Column& column : columns)
  {
    table->AddColumn(column);
  }
}

/** Looks where the column was expected first, because rows mostly agree. */
std::size_t FindColumn(
  const std::vector<Column>& columns, const std::string& name, std::size_t expected)
{
  if (expected < columns.size() && name == columns[expected]->GetName())
  {
    return expected;
  }
  const auto found = std::find_if(columns.begin(), columns.end(),
    [&](const Column& column) { return name == column->GetName(); });
  return static_cast<std::size_t>(found - columns.begin());
}

/** The columns that hold the old rows and can take the new ones. */
std::vector<Column> UnitedColumns(const std::vector<Column>& old, vtkIdType oldRows, vtkTable* rows)
{
  std::vector<Column> united = old;
  std::vector<bool> isFilled(old.size(), false);
  std::size_t next = 0;
  for (vtkIdType i = 0; i < rows->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* source = rows->GetColumn(i);
    const std::string name = source->GetName() ? source->GetName() : "";
    const std::size_t position = FindColumn(united, name, next);
    if (position < united.size())
    {
      const Kind kind = std::max(KindOfColumn(united[position]), KindOfColumn(source));
      if (kind != KindOfColumn(united[position]))
      {
        united[position] = Promote(united[position], kind);
      }
      isFilled[position] = true;
      next = position + 1;
      continue;
    }
    Kind kind = KindOfColumn(source);
    kind = kind == Kind::Integer && oldRows > 0 ? Kind::Number : kind;
    Column column = NewColumn(kind, name);
    for (vtkIdType row = 0; row < oldRows; ++row)
    {
      AppendMissing(column);
    }
    united.insert(united.begin() + static_cast<std::ptrdiff_t>(next), column);
    isFilled.insert(isFilled.begin() + static_cast<std::ptrdiff_t>(next), true);
    ++next;
  }
  for (std::size_t i = 0; i < united.size(); ++i)
  {
    if (!isFilled[i] && rows->GetNumberOfRows() > 0 && KindOfColumn(united[i]) == Kind::Integer)
    {
      united[i] = Promote(united[i], Kind::Number);
    }
  }
  return united;
}

void UniteLists(vtkTable* table, vtkTable* rows)
{
  for (const char* list : { ParametersList, MeasuredList, PerformancesList })
  {
    auto* names = vtkStringArray::SafeDownCast(rows->GetFieldData()->GetAbstractArray(list));
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    {
      AddToFieldList(table, list, names->GetValue(i));
    }
  }
}

} // namespace

ColumnKind KindOfColumn(vtkAbstractArray* column)
{
  auto* numbers = vtkDataArray::SafeDownCast(column);
  if (!numbers)
  {
    return Kind::Text;
  }
  const int type = numbers->GetDataType();
  return type == VTK_DOUBLE || type == VTK_FLOAT ? Kind::Number : Kind::Integer;
}

Column NewColumn(ColumnKind kind, const std::string& name)
{
  Column column;
  switch (kind)
  {
    case Kind::Integer:
      column = vtkSmartPointer<vtkIdTypeArray>::New();
      break;
    case Kind::Number:
      column = vtkSmartPointer<vtkDoubleArray>::New();
      break;
    case Kind::Text:
      column = vtkSmartPointer<vtkStringArray>::New();
      break;
  }
  column->SetName(name.c_str());
  return column;
}

void AppendTableRows(vtkTable* table, vtkTable* rows)
{
  const std::vector<Column> old = ColumnsOf(table);
  const std::vector<Column> united = UnitedColumns(old, table->GetNumberOfRows(), rows);
  const vtkIdType count = rows->GetNumberOfRows();
  vtkIdType expected = 0;
  for (const Column& column : united)
  {
    vtkAbstractArray* source = nullptr;
    if (expected < rows->GetNumberOfColumns() &&
      std::string(column->GetName()) == rows->GetColumnName(expected))
    {
      source = rows->GetColumn(expected++);
    }
    else
    {
      source = rows->GetColumnByName(column->GetName());
    }
    for (vtkIdType row = 0; row < count; ++row)
    {
      if (source)
      {
        AppendValue(column, source, row);
      }
      else
      {
        AppendMissing(column);
      }
    }
  }
  if (united != old)
  {
    SetColumns(table, united);
  }
  UniteLists(table, rows);
  table->Modified();
}

void NumberTableRows(vtkTable* table)
{
  constexpr const char* name = "Index";
  auto index = vtkSmartPointer<vtkIdTypeArray>::New();
  index->SetName(name);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    index->InsertNextValue(row);
  }
  table->RemoveColumnByName(name);
  std::vector<Column> columns = ColumnsOf(table);
  columns.insert(columns.begin(), index);
  SetColumns(table, columns);
}

} // namespace pemesh

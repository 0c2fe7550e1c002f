// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RowText.h"

#include "CaseStatus.h"
#include "NumberText.h"
#include "TableRows.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

/** The letter of a kind of columns. */
struct KindLetter
{
  char Letter;
  ColumnKind Kind;
};
constexpr std::array<KindLetter, 3> KindLetters{ { { 't', ColumnKind::Text },
  { 'i', ColumnKind::Integer }, { 'n', ColumnKind::Number } } };

/** The letter of a list that a column may be in, behind that of its kind. */
struct ListLetter
{
  char Letter;
  const char* List;
};
constexpr std::array<ListLetter, 2> ListLetters{ { { 'm', MeasuredList },
  { 'p', ParametersList } } };

std::string LettersOf(vtkTable* row, vtkIdType column)
{
  vtkAbstractArray* array = row->GetColumn(column);
  std::string letters;
  for (const KindLetter& entry : KindLetters)
  {
    letters += entry.Kind == KindOfColumn(array) ? std::string(1, entry.Letter) : "";
  }
  for (const ListLetter& entry : ListLetters)
  {
    letters += IsInFieldList(row, entry.List, array->GetName()) ? std::string(1, entry.Letter) : "";
  }
  return letters;
}

std::string ValueOf(vtkAbstractArray* array)
{
  if (array->GetNumberOfTuples() == 0)
  {
    return {};
  }
  return KindOfColumn(array) == ColumnKind::Number
    ? FormatNumber(vtkDataArray::SafeDownCast(array)->GetComponent(0, 0))
    : array->GetVariantValue(0).ToString();
}

/** A column of one value. */
vtkSmartPointer<vtkAbstractArray> MakeColumn(
  char letter, const std::string& name, const std::string& value)
{
  const auto* entry = std::find_if(KindLetters.begin(), KindLetters.end(),
    [letter](const KindLetter& candidate) { return candidate.Letter == letter; });
  auto column = NewColumn(entry == KindLetters.end() ? ColumnKind::Number : entry->Kind, name);
  const double number = ParseNumber(value).value_or(std::numeric_limits<double>::quiet_NaN());
  if (auto* texts = vtkStringArray::SafeDownCast(column))
  {
    texts->InsertNextValue(value);
  }
  else if (auto* integers = vtkIdTypeArray::SafeDownCast(column))
  {
    integers->InsertNextValue(static_cast<vtkIdType>(ParseInteger(value).value_or(0)));
  }
  else
  {
    vtkDoubleArray::SafeDownCast(column)->InsertNextValue(number);
  }
  return column;
}

} // namespace

void AppendField(std::string& line, std::string_view field)
{
  line += line.empty() ? "" : "\t";
  for (const char c : field)
  {
    switch (c)
    {
      case '\\':
        line += "\\\\";
        break;
      case '\t':
        line += "\\t";
        break;
      case '\n':
        line += "\\n";
        break;
      default:
        line += c;
    }
  }
}

std::vector<std::string> SplitFields(std::string_view line)
{
  std::vector<std::string> fields(1);
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '\t')
    {
      fields.emplace_back();
    }
    else if (line[i] == '\\' && i + 1 < line.size())
    {
      ++i;
      fields.back() += line[i] == 't' ? '\t' : line[i] == 'n' ? '\n' : line[i];
    }
    else
    {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::string JoinFields(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& field : fields)
  {
    AppendField(line, field);
  }
  return line;
}

std::vector<std::string> ColumnsOfRow(vtkTable* row)
{
  std::vector<std::string> columns;
  for (vtkIdType i = 0; i < row->GetNumberOfColumns(); ++i)
  {
    columns.push_back(LettersOf(row, i) + ':' + row->GetColumnName(i));
  }
  return columns;
}

std::vector<std::string> ValuesOfRow(vtkTable* row)
{
  std::vector<std::string> values;
  for (vtkIdType i = 0; i < row->GetNumberOfColumns(); ++i)
  {
    values.push_back(ValueOf(row->GetColumn(i)));
  }
  return values;
}

vtkSmartPointer<vtkTable> MakeRow(
  const std::vector<std::string>& columns, const std::vector<std::string>& values)
{
  if (columns.size() != values.size())
  {
    throw std::runtime_error("A row has " + std::to_string(values.size()) + " values for " +
      std::to_string(columns.size()) + " columns.");
  }
  auto row = vtkSmartPointer<vtkTable>::New();
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const std::size_t colon = columns[i].find(':');
    const std::string letters = columns[i].substr(0, colon);
    const std::string name = columns[i].substr(colon + 1);
    row->AddColumn(MakeColumn(letters[0], name, values[i]));
    for (const ListLetter& entry : ListLetters)
    {
      if (letters.find(entry.Letter) != std::string::npos)
      {
        AddToFieldList(row, entry.List, name);
      }
    }
  }
  return row;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CsvTable.h"

#include "CsvRecords.h"
#include "NumberText.h"
#include "TextFile.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace pemesh
{

namespace
{

void AppendValue(std::string& text, vtkAbstractArray* column, vtkIdType row)
{
  if (auto* strings = vtkStringArray::SafeDownCast(column))
  {
    AppendCsvField(text, strings->GetValue(row));
    return;
  }
  auto* numbers = vtkDataArray::SafeDownCast(column);
  if (!numbers)
  {
    AppendCsvField(text, column->GetVariantValue(row).ToString());
  }
  else if (numbers->GetDataType() == VTK_DOUBLE || numbers->GetDataType() == VTK_FLOAT)
  {
    AppendNumber(text, numbers->GetComponent(row, 0));
  }
  else
  {
    AppendNumber(text, static_cast<long long>(numbers->GetVariantValue(row).ToLongLong()));
  }
}

/** Whether digits are a name and no number: "007" would come back as 7. */
bool IsCode(std::string_view text)
{
  return text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
}

vtkSmartPointer<vtkAbstractArray> MakeColumn(const std::vector<std::string>& values)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  auto integers = vtkSmartPointer<vtkIdTypeArray>::New();
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  bool allIntegers = !values.empty();
  bool allNumbers = true;
  bool anyNumber = false; // a column of nothing is text
  for (const std::string& value : values)
  {
    const auto integer = ParseInteger(value);
    const auto number = IsCode(value) ? std::nullopt : ParseNumber(value);
    allIntegers = allIntegers && integer && value != "-0"; // minus zero is a double only
    allNumbers = allNumbers && (number || value.empty());
    anyNumber = anyNumber || number;
    integers->InsertNextValue(static_cast<vtkIdType>(integer.value_or(0)));
    numbers->InsertNextValue(number.value_or(missing));
  }
  if (allIntegers && allNumbers)
  {
    return integers;
  }
  if (allNumbers && anyNumber)
  {
    return numbers;
  }
  auto strings = vtkSmartPointer<vtkStringArray>::New();
  for (const std::string& value : values)
  {
    strings->InsertNextValue(value);
  }
  return strings;
}

} // namespace

namespace
{

/** The text piece by piece: `take` is called where there is much of it, and at the end. */
void FormatPieces(vtkTable* table, const std::function<void(std::string_view)>& take)
{
  constexpr std::size_t much = 1 << 20;
  std::string text;
  const vtkIdType columns = table->GetNumberOfColumns();
  const auto endRecord = [&]
  {
    if (columns == 1 && (text.empty() || text.back() == '\n')) // a blank line is no record
    {
      text += "\"\"";
    }
    text += '\n';
    if (text.size() > much)
    {
      take(text);
      text.clear();
    }
  };
  for (vtkIdType column = 0; column < columns; ++column)
  {
    text += column > 0 ? "," : "";
    const char* name = table->GetColumnName(column);
    AppendCsvField(text, name ? name : "");
  }
  endRecord();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      text += column > 0 ? "," : "";
      AppendValue(text, table->GetColumn(column), row);
    }
    endRecord();
  }
  take(text);
}

} // namespace

std::string FormatCsv(vtkTable* table)
{
  std::string text;
  FormatPieces(table, [&text](std::string_view piece) { text += piece; });
  return text;
}

vtkSmartPointer<vtkTable> ParseCsv(std::string_view text, const std::string& source)
{
  CsvRecordReader reader(text, source);
  std::vector<std::string> names;
  if (!reader.Next(names))
  {
    throw std::runtime_error("\"" + source + "\" is empty: a header line with names is expected.");
  }
  std::set<std::string> seen;
  for (const std::string& name : names)
  {
    if (!seen.insert(name).second)
    {
      reader.Fail("names the column \"" + name + "\" twice");
    }
  }
  std::vector<std::vector<std::string>> columns(names.size());
  std::vector<std::string> fields;
  while (reader.Next(fields))
  {
    if (fields.size() != names.size())
    {
      reader.Fail("has " + std::to_string(fields.size()) + " fields where the header has " +
        std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      columns[i].push_back(std::move(fields[i]));
    }
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    auto column = MakeColumn(columns[i]);
    column->SetName(names[i].c_str());
    table->AddColumn(column);
  }
  return table;
}

void WriteCsvFile(const std::filesystem::path& path, vtkTable* table)
{
  WriteFileSafely(path,
    [&](const std::filesystem::path& temporary)
    {
      errno = 0;
      std::ofstream stream(temporary, std::ios::binary);
      FormatPieces(table,
        [&stream](std::string_view piece)
        { stream.write(piece.data(), static_cast<std::streamsize>(piece.size())); });
      stream.close();
      if (!stream)
      {
        throw std::runtime_error(
          "Cannot write \"" + path.string() + "\": " + std::strerror(errno) + ".");
      }
    });
}

vtkSmartPointer<vtkTable> ReadCsvFile(const std::filesystem::path& path)
{
  return ParseCsv(ReadTextFile(path), path.string());
}

} // namespace pemesh

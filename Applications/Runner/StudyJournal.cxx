// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyJournal.h"

#include "CaseStatus.h"
#include "NumberText.h"
#include "TableRows.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
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

/** The fields of a line without its sum; none if the sum is not theirs. */
std::vector<std::string> SplitLine(std::string_view line);

/** FNV-1a, which is for slips of the disk, not for enemies. */
std::string SumOf(std::string_view text)
{
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const char c : text)
  {
    sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  std::array<char, 16> digits;
  constexpr int base = 16;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), sum, base);
  return { digits.data(), end.ptr };
}

std::vector<std::string> SplitLine(std::string_view line)
{
  const std::size_t last = line.rfind('\t');
  if (last == std::string_view::npos || SumOf(line.substr(0, last)) != line.substr(last + 1))
  {
    return {};
  }
  std::vector<std::string> fields(1);
  for (std::size_t i = 0; i < last; ++i)
  {
    if (line[i] == '\t')
    {
      fields.emplace_back();
    }
    else if (line[i] == '\\' && i + 1 < last)
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

StudyJournal::StudyJournal(const std::filesystem::path& path, bool keepsRows, std::size_t cases)
  : Path(path)
  , Rows(cases)
{
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  constexpr int flags = O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW;
  this->File.Reset(open(path.c_str(), flags, 0666));
  if (!this->File.IsOpen())
  {
    throw std::runtime_error(
      "Cannot write \"" + path.string() + "\": " + std::strerror(errno) + ".");
  }
  if (flock(this->File.Get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    throw std::runtime_error("Another run is writing into \"" + path.parent_path().string() +
      "\"; wait for its end, or name another folder with -o.");
  }
  if (keepsRows)
  {
    this->Load();
  }
  if (ftruncate(this->File.Get(), static_cast<off_t>(this->End)) != 0)
  {
    throw std::runtime_error(
      "Cannot write \"" + path.string() + "\": " + std::strerror(errno) + ".");
  }
}

StudyJournal::~StudyJournal()
{
  this->Flush();
}

void StudyJournal::Flush()
{
  fdatasync(this->File.Get()); // where it fails, WriteLine has said so, or will
}

void StudyJournal::Load()
{
  std::string text; // from End on
  constexpr std::size_t piece = 1 << 20;
  for (;;)
  {
    const std::size_t before = text.size();
    text.resize(before + piece);
    const ssize_t got =
      pread(this->File.Get(), text.data() + before, piece, static_cast<off_t>(this->End + before));
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    {
      const std::string_view line = std::string_view(text).substr(begin, end - begin);
      const std::vector<std::string> fields = SplitLine(line);
      if (fields.empty())
      {
        return; // what follows a line that is not whole is not trusted
      }
      this->TakeLine(fields, { this->End, line.size() });
      this->End += line.size() + 1;
    }
    text.erase(0, begin);
    if (got <= 0)
    {
      return;
    }
  }
}

void StudyJournal::TakeLine(const std::vector<std::string>& fields, const Place& place)
{
  if (fields[0] == "columns" && fields.size() > 1)
  {
    std::string columns;
    for (std::size_t i = 2; i < fields.size(); ++i)
    {
      AppendField(columns, fields[i]);
    }
    this->ColumnNumbers[columns] = fields[1];
    this->Columns[fields[1]] = { fields.begin() + 2, fields.end() };
  }
  else if (fields[0] == "row" && fields.size() > 2 && !fields[1].empty())
  {
    this->Old[fields[1]] = place;
  }
}

StudyJournal::Place StudyJournal::WriteLine(std::string line)
{
  AppendField(line, SumOf(line));
  const Place place{ this->End, line.size() };
  line += '\n';
  for (std::size_t done = 0; done < line.size();)
  {
    const ssize_t written = pwrite(this->File.Get(), line.data() + done, line.size() - done,
      static_cast<off_t>(this->End + done));
    if (written < 0 && errno != EINTR)
    {
      const std::string why = std::strerror(errno);
      const int ignored = ftruncate(this->File.Get(), static_cast<off_t>(this->End));
      throw std::runtime_error("Cannot write \"" + this->Path.string() + "\": " + why +
        (ignored == 0 ? "." : ", and it ends with half a line."));
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(0, written));
  }
  this->End += line.size();
  return place;
}

std::string StudyJournal::ColumnsOf(vtkTable* row)
{
  std::vector<std::string> columns;
  std::string text;
  for (vtkIdType i = 0; i < row->GetNumberOfColumns(); ++i)
  {
    columns.push_back(LettersOf(row, i) + ':' + row->GetColumnName(i));
    AppendField(text, columns.back());
  }
  std::string& number = this->ColumnNumbers[text];
  if (number.empty())
  {
    number = std::to_string(this->Columns.size());
    std::string line;
    AppendField(line, "columns");
    AppendField(line, number);
    this->WriteLine(line + (text.empty() ? "" : "\t") + text);
    this->Columns[number] = columns;
  }
  return number;
}

void StudyJournal::Append(int index, const std::string& key, vtkTable* row)
{
  const std::scoped_lock lock(this->Mutex);
  const std::string number = this->ColumnsOf(row);
  std::string line;
  for (const std::string& field : { std::string("row"), key, number })
  {
    AppendField(line, field);
  }
  for (vtkIdType i = 0; i < row->GetNumberOfColumns(); ++i)
  {
    AppendField(line, ValueOf(row->GetColumn(i)));
  }
  this->Rows.at(static_cast<std::size_t>(index)) = this->WriteLine(line);
}

bool StudyJournal::Adopt(int index, const std::string& key)
{
  const std::scoped_lock lock(this->Mutex);
  const auto old = this->Old.find(key);
  if (old == this->Old.end())
  {
    return false;
  }
  this->Rows.at(static_cast<std::size_t>(index)) = old->second;
  return true;
}

bool StudyJournal::Has(int index) const
{
  const std::scoped_lock lock(this->Mutex);
  return this->Rows.at(static_cast<std::size_t>(index)).Length > 0;
}

std::string StudyJournal::ReadLine(const Place& place) const
{
  std::string line(place.Length, '\0');
  const ssize_t got =
    pread(this->File.Get(), line.data(), line.size(), static_cast<off_t>(place.Offset));
  if (got != static_cast<ssize_t>(line.size()))
  {
    throw std::runtime_error("Cannot read \"" + this->Path.string() + "\" where its rows were.");
  }
  return line;
}

vtkSmartPointer<vtkTable> StudyJournal::Read(int index) const
{
  const std::scoped_lock lock(this->Mutex);
  const std::vector<std::string> fields =
    SplitLine(this->ReadLine(this->Rows.at(static_cast<std::size_t>(index))));
  constexpr std::size_t firstValue = 3;
  const auto columns =
    fields.size() < firstValue ? this->Columns.end() : this->Columns.find(fields[2]);
  if (columns == this->Columns.end() || columns->second.size() != fields.size() - firstValue)
  {
    throw std::runtime_error("\"" + this->Path.string() + "\" has changed while it was in use.");
  }
  auto row = vtkSmartPointer<vtkTable>::New();
  for (std::size_t i = 0; i < columns->second.size(); ++i)
  {
    const std::string& column = columns->second[i];
    const std::size_t colon = column.find(':');
    const std::string letters = column.substr(0, colon);
    const std::string name = column.substr(colon + 1);
    row->AddColumn(MakeColumn(letters[0], name, fields[firstValue + i]));
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

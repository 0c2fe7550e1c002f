// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyJournal.h"

#include "RowText.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <vtkTable.h>

namespace pemesh
{

namespace
{

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

/** The fields of a line without its sum; none if the sum is not theirs. */
std::vector<std::string> SplitLine(std::string_view line)
{
  const std::size_t last = line.rfind('\t');
  if (last == std::string_view::npos || SumOf(line.substr(0, last)) != line.substr(last + 1))
  {
    return {};
  }
  return SplitFields(line.substr(0, last));
}

} // namespace

StudyJournal::StudyJournal(const std::filesystem::path& path, bool keepsRows, std::size_t cases)
  : Path(path)
  , Rows(cases)
{
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error)
  {
    throw std::runtime_error(
      "Cannot make the folder \"" + path.parent_path().string() + "\": " + error.message() + ".");
  }
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

void StudyJournal::CheckPlace() const
{
  struct stat open = {};
  struct stat named = {};
  if (fstat(this->File.Get(), &open) != 0 || stat(this->Path.c_str(), &named) != 0 ||
    open.st_dev != named.st_dev || open.st_ino != named.st_ino)
  {
    throw std::runtime_error("The output folder \"" + this->Path.parent_path().string() +
      "\" has vanished: it was removed, or its disk is gone.");
  }
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
    std::vector<std::string>& columns = this->Columns[fields[1]];
    columns.assign(fields.begin() + 2, fields.end());
    this->ColumnNumbers[JoinFields(columns)] = fields[1];
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
  const std::vector<std::string> columns = ColumnsOfRow(row);
  const std::string text = JoinFields(columns);
  std::string& number = this->ColumnNumbers[text];
  if (number.empty())
  {
    number = std::to_string(this->Columns.size());
    this->WriteLine(JoinFields({ "columns", number }) + (text.empty() ? "" : "\t") + text);
    this->Columns[number] = columns;
  }
  return number;
}

void StudyJournal::Append(int index, const std::string& key, vtkTable* row)
{
  const std::scoped_lock lock(this->Mutex);
  this->CheckPlace();
  const std::string number = this->ColumnsOf(row);
  std::string line = JoinFields({ "row", key, number });
  for (const std::string& value : ValuesOfRow(row))
  {
    AppendField(line, value);
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
  return MakeRow(columns->second, { fields.begin() + firstValue, fields.end() });
}

} // namespace pemesh

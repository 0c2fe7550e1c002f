// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CsvRecords.h"

#include <algorithm>
#include <stdexcept>

namespace pemesh
{

void AppendCsvField(std::string& text, const std::string& field)
{
  if (field.find_first_of(",\"\r\n") == std::string::npos)
  {
    text += field;
    return;
  }
  text += '"';
  for (const char c : field)
  {
    text += c;
    if (c == '"')
    {
      text += '"';
    }
  }
  text += '"';
}

CsvRecordReader::CsvRecordReader(std::string_view text, const std::string& source)
  : Text(text)
  , Source(source)
{
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (this->Text.substr(0, 3) == byteOrderMark)
  {
    this->Position = 3;
  }
}

bool CsvRecordReader::Next(std::vector<std::string>& fields)
{
  while (this->Position < this->Text.size() &&
    (this->Text[this->Position] == '\n' || this->Text[this->Position] == '\r'))
  {
    this->Line += this->Text[this->Position] == '\n' ? 1 : 0;
    ++this->Position;
  }
  fields.clear();
  if (this->Position >= this->Text.size())
  {
    return false;
  }
  this->RecordLine = this->Line;
  do
  {
    fields.push_back(this->Field());
  } while (this->TakeIf(','));
  const bool carriageReturn = this->TakeIf('\r');
  const bool lineFeed = this->TakeIf('\n');
  if (!carriageReturn && !lineFeed && this->Position < this->Text.size())
  {
    this->Fail("has text after a closing quote");
  }
  ++this->Line;
  return true;
}

void CsvRecordReader::Fail(const std::string& what) const
{
  throw std::runtime_error(
    "\"" + this->Source + "\", line " + std::to_string(this->RecordLine) + ", " + what + ".");
}

bool CsvRecordReader::TakeIf(char c)
{
  if (this->Position < this->Text.size() && this->Text[this->Position] == c)
  {
    ++this->Position;
    return true;
  }
  return false;
}

std::string CsvRecordReader::Field()
{
  std::string field;
  if (!this->TakeIf('"'))
  {
    const std::size_t end =
      std::min(this->Text.find_first_of(",\r\n", this->Position), this->Text.size());
    field = this->Text.substr(this->Position, end - this->Position);
    this->Position = end;
    return field;
  }
  while (this->Position < this->Text.size())
  {
    const char c = this->Text[this->Position++];
    if (c == '"' && !this->TakeIf('"'))
    {
      return field;
    }
    this->Line += c == '\n' ? 1 : 0;
    field += c;
  }
  this->Fail("opens a quote that is never closed");
}

} // namespace pemesh

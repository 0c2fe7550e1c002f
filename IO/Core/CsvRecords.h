// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The records of CSV text (RFC 4180), one at a time: what CsvTable and other readers of CSV stand
 * on.
 */
#ifndef pemesh_CsvRecords_h
#define pemesh_CsvRecords_h

#include "pemeshIOCoreModule.h" // For export macro

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/** Appends a field to a record, quoted where it must be. */
PEMESHIOCORE_EXPORT void AppendCsvField(std::string& text, const std::string& field);

class PEMESHIOCORE_EXPORT CsvRecordReader
{
public:
  /** Messages call the text `source`. Both must outlive the reader. */
  CsvRecordReader(std::string_view text, const std::string& source);

  /** False at the end. Empty lines are skipped. */
  bool Next(std::vector<std::string>& fields);

  /** Where the last record begins, counted from 1. */
  std::size_t GetLine() const { return this->RecordLine; }

  /** "\"source\", line 3, " + what + ".", of the last record. */
  [[noreturn]] void Fail(const std::string& what) const;

private:
  bool TakeIf(char c);
  std::string Field();

  std::string_view Text;
  const std::string& Source;
  std::size_t Position = 0;
  std::size_t Line = 1;
  std::size_t RecordLine = 1;
};

} // namespace pemesh

#endif

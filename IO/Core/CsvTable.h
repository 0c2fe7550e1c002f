// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * vtkTable to and from CSV (RFC 4180): a header line, comma-separated, quoted where needed, LF
 * line ends, numbers that round-trip, NaN as "nan". Independent of the locale.
 */
#ifndef pemesh_CsvTable_h
#define pemesh_CsvTable_h

#include "pemeshIOCoreModule.h" // For export macro

#include <filesystem>
#include <string>
#include <string_view>

#include <vtkSmartPointer.h> // For return type

class vtkTable;

namespace pemesh
{

PEMESHIOCORE_EXPORT std::string FormatCsv(vtkTable* table);

/**
 * Columns whose values are all integers become vtkIdTypeArray, all numbers (an empty field is
 * NaN) vtkDoubleArray, others vtkStringArray; digits with a leading zero, and columns that are
 * empty from top to bottom, are texts. Throws std::runtime_error naming `source` and the
 * line of the first malformed record: wrong number of fields, a quote not closed, a repeated
 * column name.
 */
PEMESHIOCORE_EXPORT vtkSmartPointer<vtkTable> ParseCsv(
  std::string_view text, const std::string& source);

PEMESHIOCORE_EXPORT void WriteCsvFile(const std::filesystem::path& path, vtkTable* table);
PEMESHIOCORE_EXPORT vtkSmartPointer<vtkTable> ReadCsvFile(const std::filesystem::path& path);

} // namespace pemesh

#endif

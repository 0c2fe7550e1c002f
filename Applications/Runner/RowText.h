// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Rows of results as text, for the journal on disk and between processes: the same to the bit when
 * read again.
 */
#ifndef pemesh_RowText_h
#define pemesh_RowText_h

#include <string>
#include <string_view>
#include <vector>

#include <vtkSmartPointer.h> // For return types

class vtkTable;

namespace pemesh
{

///@{
/**
 * Fields separated by tabs on one line; tabs, line ends and backslashes in a field are escaped. The
 * first field must not be empty.
 */
void AppendField(std::string& line, std::string_view field);
std::string JoinFields(const std::vector<std::string>& fields);
std::vector<std::string> SplitFields(std::string_view line);
///@}

///@{
/**
 * The columns of a table, each as KIND:NAME with the letters of RowText.cxx for its kind and for
 * the lists that it is in; the values of its first row; and the table of both, one row. MakeRow
 * throws std::runtime_error where they do not go together.
 */
std::vector<std::string> ColumnsOfRow(vtkTable* row);
std::vector<std::string> ValuesOfRow(vtkTable* row);
vtkSmartPointer<vtkTable> MakeRow(
  const std::vector<std::string>& columns, const std::vector<std::string>& values);
///@}

} // namespace pemesh

#endif

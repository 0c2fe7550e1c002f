// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What commands ask about the columns of a table.
 */
#ifndef pemesh_TableColumns_h
#define pemesh_TableColumns_h

#include <string>
#include <vector>

class vtkTable;

namespace pemesh
{

/** Throws std::runtime_error with a sentence unless all are columns of numbers. */
void CheckNumericColumns(vtkTable* table, const std::vector<std::string>& names);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tables that grow by rows whose columns need not agree.
 */
#ifndef pemesh_TableRows_h
#define pemesh_TableRows_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <vtkSmartPointer.h> // For the columns

#include <string>

class vtkAbstractArray;
class vtkTable;

namespace pemesh
{

/** What the columns of a table hold. Each kind can hold all values of those before it. */
enum class ColumnKind
{
  Integer,
  Number,
  Text
};

PEMESHFILTERSSTATISTICS_EXPORT ColumnKind KindOfColumn(vtkAbstractArray* column);

/** Empty; vtkIdTypeArray, vtkDoubleArray or vtkStringArray. */
PEMESHFILTERSSTATISTICS_EXPORT vtkSmartPointer<vtkAbstractArray> NewColumn(
  ColumnKind kind, const std::string& name);

/**
 * Appends the rows of `rows` to `table` (which may be empty, without columns). The columns are the
 * union of both: one that is new goes behind the one it follows in `rows`. What a row does not have
 * is NaN or the empty text; integers become numbers where one is missing or meets a number, and
 * numbers become text where they meet text. The lists `Parameters` and `Measured` of the field data
 * are united as well.
 */
PEMESHFILTERSSTATISTICS_EXPORT void AppendTableRows(vtkTable* table, vtkTable* rows);

/** Puts the column `Index` = 0, 1, … first, in place of one of that name. */
PEMESHFILTERSSTATISTICS_EXPORT void NumberTableRows(vtkTable* table);

} // namespace pemesh

#endif

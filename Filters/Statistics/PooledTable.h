// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tables put together: the results of several studies, and a user's own performances.
 */
#ifndef pemesh_PooledTable_h
#define pemesh_PooledTable_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <string>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h> // For tables

class vtkTable;

namespace pemesh
{

/** A name and the table of a study. */
using NamedTable = std::pair<std::string, vtkSmartPointer<vtkTable>>;

/**
 * The rows of all studies under the union of their columns (see AppendTableRows), with a column
 * `Study` first; one study alone is given back as it is. A table that has that column already
 * keeps it. Two studies of one name become "name" and "name-2".
 */
PEMESHFILTERSSTATISTICS_EXPORT vtkSmartPointer<vtkTable> PoolStudies(
  const std::vector<NamedTable>& studies);

/**
 * Adds the columns of `performances` to the rows of `table` with the same mesh: the column `Mesh`,
 * and the column `Study` too if both have it. Meshes without performances get NaN. The numeric
 * columns added are performances (list Performances of the field data). Throws std::runtime_error
 * with one sentence that names `source`: no column Mesh, a mesh that the table has not, twice the
 * same mesh, a mesh that several studies have, a column that is there already, nothing to add.
 */
PEMESHFILTERSSTATISTICS_EXPORT void JoinPerformances(
  vtkTable* table, vtkTable* performances, const std::string& source);

} // namespace pemesh

#endif

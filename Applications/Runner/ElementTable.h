// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The elements of meshes as the rows of a table, for charts.
 */
#ifndef pemesh_ElementTable_h
#define pemesh_ElementTable_h

#include "pemeshRunnerModule.h" // For export macro

#include <string>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h> // For return types

class vtkPolyData;
class vtkTable;

namespace pemesh
{

/**
 * One row an element, mesh after mesh: the columns Mesh (its name) and Element (its number), and
 * one for every cell array of numbers, NaN for meshes without it. Of arrays with several components
 * the first counts.
 */
PEMESHRUNNER_EXPORT vtkSmartPointer<vtkTable> MakeElementTable(
  const std::vector<std::pair<std::string, vtkPolyData*>>& meshes);

/**
 * Tables one below the other, with the columns of all of them: NaN and "" where a table lacks one.
 * Where there are several, the name of a table without the column Mesh becomes one. A column that
 * holds text in one of them holds text.
 */
PEMESHRUNNER_EXPORT vtkSmartPointer<vtkTable> StackTables(
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkTable>>>& tables);

} // namespace pemesh

#endif

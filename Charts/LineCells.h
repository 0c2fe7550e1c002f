// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The cells of a grid that a line goes through, for lines that cross so often that stroking them
 * takes too long.
 */
#ifndef pemesh_LineCells_h
#define pemesh_LineCells_h

#include "pemeshChartsModule.h" // For export macro

#include <vector>

namespace pemesh
{

/**
 * 1 for every cell (row after row, from 0, 0 on) that the line through the points (x0 y0 x1 y1 …, a
 * cell being of size 1) goes through or touches with a corner within half a cell, else 0. All
 * segments count, however many: about `marks` of their cells are marked one by one, and of the
 * other segments only the parts where something is left to mark, which a table of sums tells.
 *
 * Reference for the table: F. C. Crow, Summed-area tables for texture mapping, SIGGRAPH 1984.
 */
PEMESHCHARTS_EXPORT std::vector<unsigned char> CellsOfLine(
  const std::vector<float>& points, int columns, int rows, double marks = 1e7);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What is at a place of a panel.
 */
#ifndef pemesh_ChartPick_h
#define pemesh_ChartPick_h

#include <vtkType.h> // For vtkIdType

#include <limits>
#include <string>

namespace pemesh
{

struct ChartPick
{
  enum class Kind
  {
    Nothing,
    Point, // a marker, or a vertex of a line
    Line,  // between two points of a line, or a curve
    Area   // a bar, a box, a cell of a heat map, an element of a mesh
  };

  Kind What = Kind::Nothing;
  int Plot = -1;      // which pair of axes, row by row
  std::string Series; // its label
  vtkIdType Row = -1; // of the table; of a line that of the nearer end; -1 if it is no row's
  // In the units of the axes, exactly as in the table where a point was met; NaN if undefined.
  double X = std::numeric_limits<double>::quiet_NaN();
  double Y = std::numeric_limits<double>::quiet_NaN();
  std::string Mesh;       // of the row, where the table has a column "Mesh"
  vtkIdType Element = -1; // of the row, where it has a column "Element"; of a mesh view the cell
  double DeviceX = 0.0;   // where it is drawn
  double DeviceY = 0.0;
  std::string Text; // all of it in one line, for a tool tip or a status bar

  explicit operator bool() const { return this->What != Kind::Nothing; }
};

} // namespace pemesh

#endif

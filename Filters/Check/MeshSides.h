// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How the elements of a mesh in normal form hang together: by which sides, and where not.
 */
#ifndef pemesh_MeshSides_h
#define pemesh_MeshSides_h

#include "NormalForm.h"

namespace pemesh
{

/** A side, or a piece of one between vertices in its interior, with no element on its right. */
struct BorderPiece
{
  int From;
  int To;
  int Element;
};

/** A side of more than two elements, or with two on one side of it. */
struct SideConflict
{
  int From;
  int To;
  std::vector<int> Elements; ///< simple ones, ascending
};

/** A vertex in the interior of a side of another element. */
struct Junction
{
  int Element; ///< whose side it is
  int From;
  int To;
  int Vertex;
  bool IsExact; ///< else within rounding
};

struct MeshSides
{
  std::vector<SideConflict> Conflicts;
  std::vector<Junction> Junctions;
  std::vector<BorderPiece> Border; ///< sorted by From, then To
  /** Loops of the border, the elements on the left: outer ones counter-clockwise. */
  std::vector<std::vector<int>> Loops;
  /** For each vertex whether a faulty element has it, or a conflict of sides: what looks wrong with
   * the border there has that cause. */
  std::vector<unsigned char> IsExplained;
  /** The component of each element, numbered by their first elements; -1 for those without sides.
   */
  std::vector<int> Component;
  int NumberOfComponents = 0;
};

MeshSides FindSides(const NormalForm& form, double tolerance);

} // namespace pemesh

#endif

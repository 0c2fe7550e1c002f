// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh put together of scaled, moved and reflected copies of itself in columns and rows, welded
 * along the seams: the kernel behind mirroring and tiling.
 *
 * Every copy is mapped axis by axis, and the sides of the bounding box go exactly to the ends of
 * the interval that the copy fills; neighbouring intervals share an end. So vertices of a seam lie
 * exactly on one line, and those of both sides are the same exactly if their final coordinates are
 * equal: no tolerance decides. Where the sides of a seam have different vertices, their elements
 * gain those of the other side as straight vertices, which then are straight exactly.
 *
 * Rounding is the only thing that may spoil an element, one as thin as the last digits of its
 * coordinates: every element is therefore checked exactly. Cost: linear in the result, but for
 * sorting the vertices of the seams.
 */
#ifndef pemesh_MeshRepetition_h
#define pemesh_MeshRepetition_h

#include "Point2.h"
#include "PolygonMesh.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

/** The interval that a copy fills along an axis. */
struct AxisCopy
{
  double Low;
  double High;
  bool IsReflected;
};

struct MeshRepetition
{
  std::vector<AxisCopy> Columns; ///< from west to east; each begins where the one before ends
  std::vector<AxisCopy> Rows;    ///< from south to north
  double Divisor = 1.0;          ///< of lengths
};

struct RepeatedMesh
{
  PolygonMesh Mesh;
  std::vector<int> Sources; ///< the element that each is a copy of; all copies in a row
  std::string Message;      ///< empty if all went well, else one sentence; the mesh is empty then
};

/**
 * Repeats a mesh of simple counter-clockwise elements; points without an element are left out.
 * Refused are meshes that do not have a segment of each seam on both of its sides.
 */
PEMESHFILTERSGENERATION_EXPORT RepeatedMesh RepeatMesh(
  PolygonMesh mesh, const MeshRepetition& repetition);

/** The corners of the bounding box of a mesh that has points. */
struct MeshBox
{
  Point2 Low;
  Point2 High;
};
PEMESHFILTERSGENERATION_EXPORT MeshBox BoxOfMesh(const PolygonMesh& mesh);

/** Reflected in x, in y and in both about the east and the north side, scaled back to the box. */
PEMESHFILTERSGENERATION_EXPORT MeshRepetition MirrorOnce(const MeshBox& box);

/** Columns times rows translated copies, scaled so that the larger number fills the box. */
PEMESHFILTERSGENERATION_EXPORT MeshRepetition TileBox(const MeshBox& box, int columns, int rows);

} // namespace pemesh

#endif

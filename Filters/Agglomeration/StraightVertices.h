// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Vertices that bend nothing: on a straight line between two elements, or along the border.
 */
#ifndef pemesh_StraightVertices_h
#define pemesh_StraightVertices_h

#include "PolygonMesh.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

namespace pemesh
{

enum class StraightVertices
{
  Keep,
  RemoveExact,  ///< those exactly on the line through their neighbours: no area changes
  RemoveRounded ///< those that rounding alone keeps off a line, too
};

/** What studies call them, in this order. */
inline constexpr const char* StraightVerticesNames[] = { "keep", "remove-exact", "remove-rounded" };

/**
 * Removes straight vertices of valence two: those where the same two elements, or one element and
 * the outside, meet along both sides. Elements stay simple and counter-clockwise, the mesh stays
 * conforming; points that are no longer used stay in it. Returns the area that changed sides.
 *
 * RemoveExact asks Orientation, which is exact. RemoveRounded removes a run of vertices between two
 * that stay, a and b, if each lies within 4 units in the last place of the largest coordinate of
 * the mesh from the segment a b: as vertices do that came from splitting one segment, rounded to
 * doubles. The area between the run and the segment passes from one element to its neighbour, or to
 * the outside: an area returned of 0 means that none did. An element that would not be simple any
 * more keeps all of its vertices that are not exactly straight.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT double RemoveStraightVertices(
  PolygonMesh& mesh, StraightVertices which);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Sides that have no counterpart because a vertex of another element lies in their interior.
 */
#ifndef pemesh_SideJunctions_h
#define pemesh_SideJunctions_h

#include "MeshSides.h"

namespace pemesh
{

/**
 * The vertices of the pieces in the interiors of other pieces: exactly, or nearer than `distance`.
 * By piece, and along each piece from its start to its end.
 */
std::vector<Junction> FindJunctions(
  const NormalForm& form, const std::vector<BorderPiece>& pieces, double distance);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Cuts a mesh off at the boundary of a domain.
 */
#ifndef pemesh_ClipMesh_h
#define pemesh_ClipMesh_h

#include "Domain.h"
#include "PolygonMesh.h"
#include "pemeshFiltersTessellationModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

struct ClippedMesh
{
  PolygonMesh Mesh;
  std::vector<int> Cells; ///< an element each: the cell that it is a part of; -1 if not known
};

/**
 * The parts of the cells that are in the domain, ordered by cell. The cells are simple, conforming
 * and cover the domain; empty cells are allowed.
 *
 * A cell that the boundary cuts into several parts becomes several elements; a part around a hole
 * is split by horizontal lines from the leftmost and the rightmost vertex of the hole, so that no
 * element has a hole. All vertices of the domain become vertices of the mesh, the other vertices on
 * its boundary are on axis-parallel edges exactly, on others up to rounding. Neighbours share their
 * vertices.
 *
 * What is nearer to the boundary than `tolerance` is put on it, so that where cells and boundary
 * coincide up to rounding no slivers arise: a vertex of a cell goes to the nearest vertex of the
 * domain or else the nearest point of its boundary, and a vertex of the domain becomes a vertex of
 * the cells on whose edges it lies. All other crossings are decided exactly and rounded once.
 *
 * Empty if all went well, else one sentence: after rounding, the mesh would not be conforming. That
 * elements are simple is not checked here. Cost: about linear in the number of cells and of edges
 * of the domain.
 */
PEMESHFILTERSTESSELLATION_EXPORT std::string ClipMesh(
  const PolygonMesh& cells, const Domain& domain, double tolerance, ClippedMesh& clipped);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh renumbered so that what lies together in the plane lies together in memory.
 *
 * Merging goes from elements to their neighbours all the time; on a large mesh in arbitrary order
 * each step waits for memory. Renumbering along a Hilbert curve saves a fifth to a third of the
 * time at 7 10^5 triangles, its own cost included.
 */
#ifndef pemesh_MeshOrder_h
#define pemesh_MeshOrder_h

#include "PolygonMesh.h"

#include <vector>

namespace pemesh
{

struct OrderedMesh
{
  PolygonMesh Mesh; ///< elements along the curve, points as they come first; unused ones left out
  MeshAdjacency Adjacency;
  std::vector<int> OldElement; ///< an element each: its number in the old mesh
  std::vector<int> OldPoint;   ///< a point each: its number in the old mesh
};

/** Elements in the order in which a Hilbert curve meets their centroids. */
OrderedMesh OrderAlongCurve(const PolygonMesh& mesh, const MeshAdjacency& adjacency);

} // namespace pemesh

#endif

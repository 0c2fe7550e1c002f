// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Well-spaced points for the inside of a domain: what refinement would make there one by one.
 *
 * A hexagonal lattice, whose Delaunay triangles are equilateral, shaken a little so that no
 * predicate has to decide a tie. Points nearer to the boundary than about an edge of the lattice
 * are left out: the refinement knows better what to do there. Points come in the order of a
 * Hilbert curve, so that each is near the one before (see N. Amenta, S. Choi, G. Rote,
 * Incremental constructions con BRIO, SoCG 2003, 211-219,
 * doi:10.1145/777792.777824).
 */
#ifndef pemesh_LatticePoints_h
#define pemesh_LatticePoints_h

#include "DomainTriangulation.h"
#include "Point2.h"

#include <vector>

namespace pemesh
{

/**
 * Points whose Delaunay triangles are nearly equilateral and smaller than `maximumArea`, at least
 * 90 % of that where they are not near the boundary. None if the domain is too narrow for any.
 */
std::vector<Point2> MakeLatticePoints(const DomainBoundary& boundary, double maximumArea);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What every mesh of a domain must be, decided in exact arithmetic.
 */
#ifndef pemesh_TessellationInvariants_h
#define pemesh_TessellationInvariants_h

#include "Domain.h"
#include "PolygonMesh.h"

#include <string>

/**
 * Empty if all elements are simple and counter-clockwise, all points are used and different, every
 * side has exactly one neighbour or is on the boundary of the domain, all vertices of the domain
 * are vertices of the mesh, and the areas add up to that of the domain: exactly if its edges are
 * axis-parallel.
 */
std::string WhyNotAMeshOf(const pemesh::Domain& domain, const pemesh::PolygonMesh& mesh);

#endif

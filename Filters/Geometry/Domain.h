// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The region that a mesh covers: a simple polygon, less holes.
 */
#ifndef pemesh_Domain_h
#define pemesh_Domain_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

/** All loops are simple and counter-clockwise and do not meet; the holes lie in the outer one. */
struct Domain
{
  std::vector<Point2> Outer;
  std::vector<std::vector<Point2>> Holes;
};

/** [0,1]^2 */
PEMESHFILTERSGEOMETRY_EXPORT Domain UnitSquare();

/**
 * Makes a domain of closed loops in any order and orientation: the one that holds all others is
 * the outer one. Empty if they make one, else one sentence on why not. Exact.
 */
PEMESHFILTERSGEOMETRY_EXPORT std::string MakeDomain(
  std::vector<std::vector<Point2>> loops, Domain& domain);

/** Area of the outer loop less that of the holes. */
PEMESHFILTERSGEOMETRY_EXPORT double DomainArea(const Domain& domain);

/** Whether the domain is exactly an axis-parallel rectangle of four vertices, without holes. */
PEMESHFILTERSGEOMETRY_EXPORT bool IsRectangle(const Domain& domain);

} // namespace pemesh

#endif

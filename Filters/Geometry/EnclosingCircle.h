// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The smallest circle around a set of points.
 *
 * Grows the support set by the farthest point outside until there is none, the pivoting of
 * B. Gaertner, Fast and robust smallest enclosing balls, ESA 1999, LNCS 1643, 325-338. The radius
 * grows strictly, so it ends on any input. Accuracy: the radius is within 1e-14 of itself, for
 * points are taken relative to one of them. Repeated, nearly repeated and collinear points change
 * nothing. Cost: one pass over the points for each time the support grows, seldom more than five,
 * after that of the farthest pair.
 */
#ifndef pemesh_EnclosingCircle_h
#define pemesh_EnclosingCircle_h

#include "Circle.h"
#include "PointDistances.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

namespace pemesh
{

PEMESHFILTERSGEOMETRY_EXPORT Circle SmallestEnclosingCircle(PolygonView points);

/** The same, from the farthest pair where that is known already. */
PEMESHFILTERSGEOMETRY_EXPORT Circle SmallestEnclosingCircle(
  PolygonView points, const PointPair& farthest);

} // namespace pemesh

#endif

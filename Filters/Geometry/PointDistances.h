// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The largest and the least distance of two points of a set.
 */
#ifndef pemesh_PointDistances_h
#define pemesh_PointDistances_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <cstddef>

namespace pemesh
{

/** Two points of a set, by index, and their distance. */
struct PointPair
{
  std::size_t First = 0;
  std::size_t Second = 0;
  double Distance = 0.0;
};

/**
 * The pair that is farthest apart. All pairs are compared for small sets; for large ones those of
 * the convex hull, by rotating calipers (M. I. Shamos, Computational geometry, thesis, Yale 1978).
 */
PEMESHFILTERSGEOMETRY_EXPORT PointPair FarthestPair(PolygonView points);

/** Largest distance of two vertices. */
PEMESHFILTERSGEOMETRY_EXPORT double Diameter(PolygonView points);

/**
 * The pair that is closest together; points sorted by x are swept for large sets (K. Hinrichs,
 * J. Nievergelt, P. Schorn, Inf. Process. Lett. 26 (1988) 255-261). Needs at least two points.
 */
PEMESHFILTERSGEOMETRY_EXPORT PointPair ClosestPair(PolygonView points);

} // namespace pemesh

#endif

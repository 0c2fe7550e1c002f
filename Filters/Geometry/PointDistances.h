// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The largest and the least distance of two points of a set.
 *
 * Accuracy: a rounding or two of the distance. Collinear points are like others; a repeated point
 * makes the least distance 0. Cost: all pairs up to 48 points, which is faster there, then that
 * of sorting (and, for the closest pair, of the pairs near each other along x).
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

/** Both at once, which for small sets costs little more than one. Needs at least two points. */
struct DistanceRange
{
  PointPair Farthest;
  double Least = 0.0;
};
PEMESHFILTERSGEOMETRY_EXPORT DistanceRange MeasureDistances(PolygonView points);

} // namespace pemesh

#endif

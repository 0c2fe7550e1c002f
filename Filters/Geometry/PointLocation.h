// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where a point is with respect to a polygon, decided exactly on the coordinates as given.
 *
 * Crossings of a ray to the right are counted, even and odd, with the half-open rule at vertices
 * (K. Hormann, A. Agathos, The point in polygon problem for arbitrary polygons, Comput. Geom. 20
 * (2001) 131-144). Either orientation, convex or not; straight and repeated vertices change
 * nothing. Cost: O(n), one orientation for each edge at the height of the point.
 */
#ifndef pemesh_PointLocation_h
#define pemesh_PointLocation_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

namespace pemesh
{

enum class PointLocation
{
  Outside,
  OnBoundary,
  Inside
};

/** Outside for fewer than three vertices, and for a point that is not finite. */
PEMESHFILTERSGEOMETRY_EXPORT PointLocation LocatePoint(PolygonView polygon, const Point2& point);

/** Inside or on the boundary. */
inline bool ContainsPoint(PolygonView polygon, const Point2& point)
{
  return LocatePoint(polygon, point) != PointLocation::Outside;
}

} // namespace pemesh

#endif

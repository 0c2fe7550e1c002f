// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Area, perimeter, edges, angles and convexity of a polygon.
 *
 * All are accurate at any scale and any distance from the origin: only differences of coordinates
 * enter, and where a sign decides it is exact. The area sums twice the digits where the plain sum
 * would cancel (T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput.
 * 26 (2005) 1955-1988). Polygons may have straight and repeated vertices; a repeated one is an
 * edge of length 0 and has no angle. Cost: O(n).
 */
#ifndef pemesh_PolygonMeasures_h
#define pemesh_PolygonMeasures_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <vector>

namespace pemesh
{

/** The shoelace sum about the first vertex; positive for a counter-clockwise polygon. */
PEMESHFILTERSGEOMETRY_EXPORT double SignedArea(PolygonView polygon);

/**
 * 1 for a counter-clockwise simple polygon, -1 for a clockwise one, 0 if all vertices are on one
 * line. Exact: it is the turn at a lexicographically smallest vertex.
 */
PEMESHFILTERSGEOMETRY_EXPORT int PolygonOrientation(PolygonView polygon);

PEMESHFILTERSGEOMETRY_EXPORT double Perimeter(PolygonView polygon);

/** The centre of mass of the area; the mean of the vertices where the area is zero. */
PEMESHFILTERSGEOMETRY_EXPORT Point2 Centroid(PolygonView polygon);

/** Length of the shortest and of the longest edge, and the perimeter. */
struct EdgeLengths
{
  double Shortest = 0.0;
  double Longest = 0.0;
  double Perimeter = 0.0;
};
PEMESHFILTERSGEOMETRY_EXPORT EdgeLengths MeasureEdges(PolygonView polygon);

///@{
/**
 * Interior angles of a counter-clockwise polygon in radians, in [0, 2 pi); pi where straight. Each
 * is within a few roundings of that of the vertices as given. A repeated vertex has no angle: its
 * entry in the list is 0 and MeasureAngles leaves it out. MeasureAngles compares the corners by
 * slopes and takes the arc tangent of two only.
 */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<double> InteriorAngles(PolygonView polygon);
struct AngleRange
{
  double Smallest = 0.0;
  double Largest = 0.0;
};
PEMESHFILTERSGEOMETRY_EXPORT AngleRange MeasureAngles(PolygonView polygon);
///@}

/**
 * Whether a counter-clockwise polygon is convex: no vertex turns right, decided exactly, and the
 * boundary goes round once. Straight vertices are allowed.
 */
PEMESHFILTERSGEOMETRY_EXPORT bool IsConvex(PolygonView polygon);

} // namespace pemesh

#endif

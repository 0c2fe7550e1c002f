// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Slow answers that share nothing with the kernels: exact rational arithmetic where that is
 * possible, else enumeration of all candidates in extended precision.
 */
#ifndef BruteForce_h
#define BruteForce_h

#include "Point2.h"

namespace pemesh::test
{

/** Shoelace formula in rational numbers. */
double ExactArea(PolygonView polygon);

/** Area of the intersection of all left half planes, clipped in rational numbers. */
double ExactKernelArea(PolygonView polygon);

/**
 * The largest smallest circle around three of the points, in extended precision: by E. Helly's
 * theorem that of all.
 */
double BruteEnclosingRadius(PolygonView points);

/** All circles that touch three lines of edges or vertices, in extended precision. */
double BruteInscribedRadius(PolygonView polygon);

/** The distance of a point to the boundary, negative outside, in extended precision. */
double BruteDistanceInside(PolygonView polygon, const Point2& point);

/** All pairs in extended precision, the angles with exact signs. */
struct BruteMeasures
{
  double Diameter = 0.0;
  double ClosestPair = 0.0;
  double Perimeter = 0.0;
  double SmallestAngle = 0.0;
  double LargestAngle = 0.0;
  bool Convex = true; ///< no vertex turns right
};
BruteMeasures BruteMeasure(PolygonView polygon);

/** The greatest r with a point r to the left of all edges, by all triples; 0 if there is none. */
double BruteKernelRadius(PolygonView polygon);

} // namespace pemesh::test

#endif

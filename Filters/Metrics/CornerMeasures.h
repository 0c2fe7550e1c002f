// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The corners and the straight sides of an element.
 */
#ifndef pemesh_CornerMeasures_h
#define pemesh_CornerMeasures_h

#include "Point2.h"
#include "pemeshFiltersMetricsModule.h" // For export macro

namespace pemesh
{

/** How far from a line a vertex still counts as straight, as a part of the diameter. */
inline constexpr double StraightTolerance = 1e-10;

/** Whether b is between a and c and at most `distance` from the line through them. */
PEMESHFILTERSMETRICS_EXPORT bool IsStraight(
  const Point2& a, const Point2& b, const Point2& c, double distance);

struct CornerShapes
{
  double SmallestSine = 1.0;           ///< of an interior angle; negative for a reflex one
  double SmallestFrobeniusRatio = 1.0; ///< least 2 / condition number of two edges at a vertex
};

/**
 * Of a counter-clockwise polygon without repeated vertices. With u and v the edges at a vertex, the
 * condition number of the matrix (u v) in the Frobenius norm is (u^2 + v^2) / |u x v| (P. M. Knupp,
 * SIAM J. Sci. Comput. 23 (2001) 193-218).
 */
PEMESHFILTERSMETRICS_EXPORT CornerShapes MeasureCorners(PolygonView polygon);

/**
 * The least ratio of the shortest to the longest of the edges that make one straight side; 1 if
 * no side has more than one edge. `distance` as in IsStraight.
 */
PEMESHFILTERSMETRICS_EXPORT double SmallestSideRatio(PolygonView polygon, double distance);

} // namespace pemesh

#endif

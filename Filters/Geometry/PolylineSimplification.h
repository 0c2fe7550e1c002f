// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Fewer points for a line drawn by hand, and the polygon that it goes round.
 *
 * Reference: D. H. Douglas, T. K. Peucker, Algorithms for the reduction of the number of points
 * required to represent a digitized line or its caricature, Cartographica 10 (1973) 112-122,
 * doi:10.3138/FM57-6770-U75U-7727. Cost O(n^2) at worst, O(n log n) as a rule.
 */
#ifndef pemesh_PolylineSimplification_h
#define pemesh_PolylineSimplification_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

/**
 * The least of its points that the recursion of Douglas and Peucker keeps: the first, the last, and
 * so many between them that every other one is within `tolerance` of the segment that replaces it.
 */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<Point2> SimplifyPolyline(
  const std::vector<Point2>& points, double tolerance);

/** Every coordinate at the nearest multiple of `step`; repeated points are one. */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<Point2> SnapToGrid(
  const std::vector<Point2>& points, double step);

/** What a stroke became. */
struct DrawnPolygon
{
  std::vector<Point2> Points; ///< simple and counter-clockwise, or empty
  std::string Fault;          ///< then one sentence on why
};

/**
 * The polygon of a closed stroke: simplified to the tolerance, with its corners on a grid if
 * `gridStep` is positive. Where the simplified one crosses itself and the stroke does not, the
 * tolerance is halved until it does not either.
 */
PEMESHFILTERSGEOMETRY_EXPORT DrawnPolygon PolygonOfStroke(
  const std::vector<Point2>& stroke, double tolerance, double gridStep);

} // namespace pemesh

#endif

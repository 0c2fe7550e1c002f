// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Exact answers about polygons: simple or not, apart or not, inside a rectangle or not.
 *
 * Every answer is that of exact arithmetic on the given doubles (CGAL's filtered predicates), so a
 * polygon that touches another by one unit in the last place is found to touch it. Edge i of a
 * polygon joins vertex i to vertex i + 1, the last edge closes it. Polygons may be in either
 * orientation. Coordinates must be finite: AreFinite is the one question to ask before the others.
 * All functions are safe to call from several threads at once.
 */
#ifndef pemesh_PolygonValidity_h
#define pemesh_PolygonValidity_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <cstddef>
#include <optional>
#include <string>

namespace pemesh
{

/** Two edges that meet where they must not. */
struct EdgePair
{
  std::size_t First = 0;
  std::size_t Second = 0;

  friend bool operator==(const EdgePair&, const EdgePair&) = default;
};

/** No coordinate is NaN or infinite. */
PEMESHFILTERSGEOMETRY_EXPORT bool AreFinite(PolygonView polygon);

/**
 * The lexicographically first pair of edges (First < Second) that meet anywhere but in the vertex
 * they share as neighbours: crossings, touchings, overlaps, repeated vertices, spikes of no width.
 * Nothing if the polygon is simple. Cost: O(n log n + pairs whose bounding boxes meet).
 */
PEMESHFILTERSGEOMETRY_EXPORT std::optional<EdgePair> FindSelfCrossing(PolygonView polygon);

/** At least three vertices, finite, and no edges that meet; straight angles are allowed. */
PEMESHFILTERSGEOMETRY_EXPORT bool IsSimple(PolygonView polygon);

/** Empty for a simple polygon, else the end of a sentence: "has edges 3 and 7 that cross or touch".
 */
PEMESHFILTERSGEOMETRY_EXPORT std::string WhyNotSimple(PolygonView polygon);

/** How two simple polygons lie, as closed regions. */
enum class PolygonRelation
{
  Apart,             ///< no point in common
  Touching,          ///< boundaries meet, interiors do not
  Overlapping,       ///< interiors meet, none contains the other
  FirstInsideSecond, ///< the first lies in the second; boundaries may touch
  SecondInsideFirst, ///< the second lies in the first; boundaries may touch
  Equal              ///< the same region
};

/** Cost: linear, and quadratic in the edges that come near the other polygon's bounding box. */
PEMESHFILTERSGEOMETRY_EXPORT PolygonRelation RelatePolygons(PolygonView first, PolygonView second);

/** Whether the boundaries of two simple polygons have a point in common. Cost as RelatePolygons. */
PEMESHFILTERSGEOMETRY_EXPORT bool DoBoundariesMeet(PolygonView first, PolygonView second);

/** How a polygon lies in an axis-parallel rectangle. */
enum class RectangleRelation
{
  Inside,   ///< in the open rectangle
  Touching, ///< in the closed rectangle, with points on its border
  Outside   ///< some vertex is outside
};

PEMESHFILTERSGEOMETRY_EXPORT RectangleRelation RelateToRectangle(
  PolygonView polygon, const Point2& low = { 0.0, 0.0 }, const Point2& high = { 1.0, 1.0 });

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How a polygon of a family, in its own coordinates, comes to its place in the domain.
 */
#ifndef pemesh_PolygonPlacement_h
#define pemesh_PolygonPlacement_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <vector>

namespace pemesh
{

/** Diagonal of the bounding box, before turning, of a polygon of scale 1. */
inline constexpr double UnitPolygonDiagonal = 0.5;

/**
 * Scales `vertices` so that the diagonal of the bounding box is UnitPolygonDiagonal times `scale`,
 * turns them counter-clockwise by `degrees` about the average of the vertices, and moves them so
 * that the centre of the bounding box is then `center`. Multiples of 90 degrees turn without
 * rounding. A polygon that is there already (PlaceOf, no turn) is returned bit by bit.
 */
PEMESHFILTERSGENERATION_EXPORT std::vector<Point2> PlacePolygon(
  std::vector<Point2> vertices, const Point2& center, double scale, double degrees);

/** Where and how large a polygon is as it stands. */
struct PolygonPlace
{
  Point2 Center;      ///< of the bounding box
  double Scale = 1.0; ///< its diagonal is UnitPolygonDiagonal times this

  friend bool operator==(const PolygonPlace&, const PolygonPlace&) = default;
};

/** The place of a polygon of at least one vertex. */
PEMESHFILTERSGENERATION_EXPORT PolygonPlace PlaceOf(const std::vector<Point2>& vertices);

} // namespace pemesh

#endif

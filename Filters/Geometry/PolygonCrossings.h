// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Whether a polygon is the boundary of a region at all, if perhaps of one that touches itself.
 */
#ifndef pemesh_PolygonCrossings_h
#define pemesh_PolygonCrossings_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

namespace pemesh
{

/**
 * Whether the boundary crosses itself, between vertices or in one, or runs along itself, as at a
 * spike or a slit without width. Decided exactly. A polygon that merely touches itself in single
 * points passes: its area, distances and angles are still defined (see IsSimple for more). Repeated
 * vertices in a row are ignored. Cost: O(n^2) up to 48 edges, then a sweep; a polygon that touches
 * itself O(n^2).
 */
PEMESHFILTERSGEOMETRY_EXPORT bool HasCrossingEdges(PolygonView polygon);

} // namespace pemesh

#endif

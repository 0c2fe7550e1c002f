// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The Voronoi cells of points, as a mesh.
 */
#ifndef pemesh_VoronoiCells_h
#define pemesh_VoronoiCells_h

#include "DomainLocator.h"
#include "PolygonMesh.h"

#include <functional>
#include <vector>

namespace pemesh
{

/**
 * Removes vertices that follow themselves; elements of fewer than three vertices become empty.
 */
void RemoveRepeatedVertices(PolygonMesh& mesh);

/**
 * Element i is the Voronoi cell of site i, cut off far outside `bounds`, in which all sites lie. In
 * `bounds` the cells are those of the sites alone. Edges shorter than `tolerance` are contracted,
 * as they come of sites on one circle; of sites at the same place, all but one have an element
 * without vertices. Corners are rounded, so that cells are convex up to rounding.
 * Stops, with whatever there is, when `progress` says no. Cost: about linear.
 */
PolygonMesh VoronoiCells(const std::vector<Point2>& sites, const Box& bounds, double tolerance,
  const std::function<bool(double)>& progress);

} // namespace pemesh

#endif

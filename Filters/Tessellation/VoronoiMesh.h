// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Voronoi meshes of a domain.
 */
#ifndef pemesh_VoronoiMesh_h
#define pemesh_VoronoiMesh_h

#include "ClipMesh.h"
#include "Tessellations.h"

namespace pemesh
{

/**
 * The Voronoi cells of the sites, which are in the domain, clipped to it. Empty, or one sentence on
 * why it failed; "Stopped." if `progress` said no.
 */
PEMESHFILTERSTESSELLATION_EXPORT std::string VoronoiMesh(const std::vector<Point2>& sites,
  const Domain& domain, const std::function<bool(double)>& progress, ClippedMesh& mesh);

/**
 * Moves every site to the centroid of its clipped cell, `iterations` times (Lloyd's method); a
 * site whose centroid is not in the domain stays for this time. No step increases the energy, the
 * sum over the cells of the integral of the squared distance to the site. Result as VoronoiMesh.
 */
PEMESHFILTERSTESSELLATION_EXPORT std::string RelaxSites(const Domain& domain, int iterations,
  const std::function<bool(double)>& progress, std::vector<Point2>& sites);

///@{
/** Entries of the table of tessellations. */
TessellationResult MakeVoronoi(const TessellationInput& input);
TessellationResult MakeCentroidalVoronoi(const TessellationInput& input);
TessellationResult MakeRandomAgglomerates(const TessellationInput& input);
///@}

} // namespace pemesh

#endif

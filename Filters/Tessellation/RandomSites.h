// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random points in a domain: the sites of Voronoi meshes.
 */
#ifndef pemesh_RandomSites_h
#define pemesh_RandomSites_h

#include "Domain.h"
#include "pemeshFiltersTessellationModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

/**
 * `count` points, uniform in the open domain, in the order of a Hilbert curve so that points with
 * near numbers are near. No two are nearer than `spacing` times the distance that the densest
 * arrangement of as many points in the plane has, sqrt(2 area / (sqrt(3) count)): points that would
 * be are drawn again (random sequential adsorption, which is full at a spacing of about 0.77).
 * Empty if they were found, else one sentence. The same points on every platform.
 */
PEMESHFILTERSTESSELLATION_EXPORT std::string RandomSites(
  const Domain& domain, int count, double spacing, double seed, std::vector<Point2>& sites);

} // namespace pemesh

#endif

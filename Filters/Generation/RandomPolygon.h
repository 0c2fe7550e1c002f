// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random simple polygons, from harmless to wild.
 *
 * A random polygon is the end of a deformation that begins with the regular polygon of as many
 * vertices in the unit circle, and every polygon on the way is simple. First the vertices move
 * along circles and rays to random angles (irregularity) and distances from the middle (spikiness):
 * the polygon stays star-shaped, because consecutive vertices keep a positive angle below half a
 * turn. Then (tangle) its vertices wander one by one, 8 tries for each at tangle 1: a try is a
 * straight way to a random place in the unit disc, near or far, and is taken only if the two edges
 * that follow the vertex sweep over no other edge. So the polygon loses the point that sees all of
 * it, and edges keep a distance of a twentieth of the regular polygon's edge.
 *
 * Of the deformation's range [0, 1] the first part takes 1 / (1 + tangle). All decisions are exact
 * or have a margin far above rounding; only arithmetic that IEEE 754 defines is used, so that a
 * seed gives the same polygon everywhere.
 *
 * Compare T. Auer, M. Held, Heuristics for the generation of random polygons, Proc. 8th Canadian
 * Conference on Computational Geometry (1996) 38-43, whose polygons have no deformation, and whose
 * 2-opt moves cost more.
 */
#ifndef pemesh_RandomPolygon_h
#define pemesh_RandomPolygon_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <cstdint>
#include <vector>

namespace pemesh
{

struct RandomPolygonOptions
{
  int Vertices = 16;         ///< at least 3
  double Irregularity = 0.5; ///< 0: equal angles seen from the middle; 1: 0.1 to 1.9 of the mean
  double Spikiness = 0.5;    ///< 0: all on the circle; 1: distances from 0.1 to 1
  double Tangle = 0.5;       ///< 0: star-shaped; 1: the longest walk; without effect on triangles
  std::uint64_t Seed = 0;
};

/** The polygon at deformation t (taken to [0, 1]), counter-clockwise, in the unit disc. */
PEMESHFILTERSGENERATION_EXPORT std::vector<Point2> MakeRandomPolygon(
  const RandomPolygonOptions& options, double t);

} // namespace pemesh

#endif

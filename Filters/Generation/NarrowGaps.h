// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Gaps between edges of the boundary that are so long and narrow that they fill with triangles.
 *
 * Where two segments face each other at the distance w(s), a triangle with angles that are not
 * small is about as long as the gap is wide, so a gap takes about the integral of ds / w(s)
 * triangles. (Measured for two parallel edges with a minimum angle of 20 degrees: 1.1 times that.)
 * Smaller angles allow longer triangles, in the ratio of the tangents.
 * Only gaps that an edge of the triangulation bridges from one segment to the other are seen; the
 * sum over them is therefore an estimate from below.
 */
#ifndef pemesh_NarrowGaps_h
#define pemesh_NarrowGaps_h

#include "RefinableTriangulation.h"

#include <vector>

namespace pemesh
{

struct NarrowGaps
{
  double Triangles = 0.0;       ///< estimate for all gaps together
  double MostTriangles = 0.0;   ///< for the worst one
  double Width = 0.0;           ///< of the worst one, where it is narrowest
  int Segments[2] = { -1, -1 }; ///< on its two sides, -1 if there is no gap
};

/** Segments of an unrefined triangulation; the preserved ones are not split and make no gaps. */
NarrowGaps FindNarrowGaps(const RefinableTriangulation& triangulation,
  const std::vector<bool>& preserved, double minimumAngle);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Adds points to a triangulated domain until its triangles are small and round enough.
 *
 * The algorithm is Ruppert's: a segment with a vertex inside its diametral circle is split; a
 * triangle that is too large or too flat is destroyed by a point at its circumcentre, or nearer at
 * its off-centre (Uengoer), unless that point would be inside the diametral circle of a segment,
 * which is then split instead. Three things make it end on every input:
 *  - segments that leave an input vertex at an angle below 90 degrees are split at powers of two
 *    from it (Ruppert's concentric shells; Shewchuk 2002, section 3.6), and a flat triangle whose
 *    shortest edge joins two such segments at equal distance from a vertex with an angle below 60
 *    degrees stays (Miller, Pav, Walkington 2005);
 *  - a triangle is not refined for its angles where its shortest edge is far below the smallest
 *    feature of the input: bounds beyond 20.7 degrees may otherwise shrink edges without end;
 *  - the number of triangles is bounded.
 *
 * Segments that must not be split (preserved ones) get no diametral circle. A point for a flat
 * triangle is refused where it is hidden behind one, where it sees one at an angle of more than
 * 180 degrees minus twice the bound (the triangle of the two would be flat as well), or where it
 * would shorten the shortest edge around; nearer points are tried then, and if none will do the
 * triangle stays. A triangle that is too large is always split: at its centroid if need be.
 */
#ifndef pemesh_DelaunayRefinement_h
#define pemesh_DelaunayRefinement_h

#include "DomainTriangulation.h"
#include "RefinableTriangulation.h"

#include <functional>
#include <limits>
#include <vector>

namespace pemesh
{

struct RefinementOptions
{
  double MinimumAngle = 20.0; ///< degrees
  double MaximumArea = std::numeric_limits<double>::infinity();
  std::vector<bool> Preserved; ///< an input segment each
  int MaximumTriangles = 20000000;
  std::function<bool(double)> Progress; ///< takes the fraction done; false means stop
};

enum class RefinementOutcome
{
  Done,
  TooManyTriangles,
  Stopped
};

RefinementOutcome RefineTriangulation(RefinableTriangulation& triangulation,
  const DomainBoundary& boundary, const RefinementOptions& options);

} // namespace pemesh

#endif

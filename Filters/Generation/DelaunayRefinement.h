// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Adds points to a triangulated domain until its triangles are small and round enough.
 *
 * The algorithm is Ruppert's: a segment with a vertex inside its diametral circle is split; a
 * triangle that is too large or too flat is destroyed by a point at its circumcentre, or nearer at
 * its off-centre (Uengoer), unless that point would be inside the diametral circle of a segment,
 * which is then split instead. How segments are split, above all at small angles of the domain, is
 * told in BoundarySplitter.h. Where only the area bound counts, away from the boundary, points of a
 * lattice are put beforehand (LatticePoints.h): that is faster than finding them one by one, and
 * gives rounder triangles and fewer. The result has no angle below the bound but where an angle of
 * the domain itself is below it, or the bound is beyond what Ruppert's proof covers (20.7 degrees)
 * and the limits below come first. It ends on every input:
 *  - up to 20.7 degrees by that proof, which small angles of the domain do not disturb, because
 *    they are never split where that would shorten the shortest edge around;
 *  - beyond, because no triangle is refined for its angles, and no segment split, where an edge is
 *    a thousand times shorter than the smallest feature of the input;
 *  - in any case because the number of triangles is bounded.
 *
 * Segments that must not be split (preserved ones) get no diametral circle. A point for a flat
 * triangle is refused where it is hidden behind one, or where it sees one at an angle of more than
 * 180 degrees minus twice the bound, for the triangle of the two would be flat as well; nearer
 * points are tried then, which must not shorten the shortest edge of the triangle. The second
 * reason counts only for triangles that touch a preserved segment anyway. If no point will do, the
 * triangle stays. A triangle that is too large is split, at a point inside it if need be; near
 * preserved segments longer than the side of an equilateral triangle of that area the bound is
 * graded up to their length, because it would force flat triangles there (SizeField.h).
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
  double Gradation = 0.0;      ///< see SizeField.h
  double SizeAtPolygons = 0.0; ///< see SizeField.h
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

/** Refines the inside of a triangulation fresh from TriangulateDomain. */
RefinementOutcome RefineTriangulation(DomainTriangulation& triangulation,
  const DomainBoundary& boundary, const RefinementOptions& options);

} // namespace pemesh

#endif

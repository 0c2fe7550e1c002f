// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Finds the triangle of a point by walking there from another one, straight through holes.
 *
 * From each triangle the walk goes on over an edge that has the point beyond it; which edge is
 * looked at first changes from step to step, because with a fixed order a walk in a triangulation
 * that is not Delaunay may run in circles. O. Devillers, S. Pion, M. Teillaud, Walking in a
 * triangulation, Int. J. Found. Comput. Sci. 13 (2002) 181-199, doi:10.1142/S0129054102001047.
 * Segments must not have been split since the domain was triangulated.
 */
#ifndef pemesh_TriangulationWalk_h
#define pemesh_TriangulationWalk_h

#include "DomainTriangulation.h"
#include "RefinableTriangulation.h"

#include <cstdint>

namespace pemesh
{

class TriangulationWalk
{
public:
  TriangulationWalk(const RefinableTriangulation& inside, const OutsideTriangles& outside)
    : Inside(inside)
    , Outside(outside)
  {
  }

  /** The triangle that holds the point, or -1 if it is not in the domain. */
  int Find(const Point2& point, int start);

private:
  /** The edge over which to leave the triangle, or -1 if it holds the point. */
  int EdgeTowards(const Point2& point, const RefinableTriangulation::Triangle& triangle);

  const RefinableTriangulation& Inside;
  const OutsideTriangles& Outside;
  std::uint32_t Random = 1;
};

} // namespace pemesh

#endif

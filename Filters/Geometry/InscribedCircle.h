// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The largest circle inside a simple polygon, convex or not.
 *
 * A triangle has a closed form, and for a convex polygon, as for the kernel of any, the circle is
 * the solution of a linear program in three unknowns (see e.g. S. Boyd, L. Vandenberghe, Convex
 * Optimization, 2004, section 8.5.1). Otherwise the distance to the boundary has several local
 * maxima, vertices of the medial axis (F. P. Preparata, The medial axis of a simple polygon, MFCS
 * 1977, LNCS 53, 443-450). One is climbed to by Newton's method: the distance to each edge is a
 * convex function of the point, so the highest point below all tangent planes, a linear program
 * again, is inside the polygon and at least that high. Then BoundaryCover either proves that no
 * point is farther from the boundary, or finds one, from where the climb goes on.
 *
 * Accuracy: the radius is within 1e-11 of itself plus 5e-16 of the perimeter, and the center is
 * at that distance of the boundary; where several circles are as large, any of them is returned.
 * Coordinates enter by differences only. Straight vertices change nothing, and repeated ones are
 * ignored. A clockwise polygon has to be reversed first (see PolygonOrientation): nothing is
 * promised for it but an end.
 * Cost: measured as a few times n for the elements of meshes, for a climb takes some four steps of
 * O(n), there is seldom more than one, and few edges are asked for each curve of the cover. O(n^2)
 * at worst for each local maximum passed.
 */
#ifndef pemesh_InscribedCircle_h
#define pemesh_InscribedCircle_h

#include "BoundaryCover.h"
#include "Circle.h"
#include "PolygonKernel.h"
#include "SmallLinearProgram.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <vector>

namespace pemesh
{

/** Searches with buffers of its own, so that a loop over elements allocates nothing. */
class PEMESHFILTERSGEOMETRY_EXPORT InscribedCircleFinder
{
public:
  /** The largest circle inside a counter-clockwise simple polygon; NaN below three vertices. */
  Circle Find(PolygonView polygon);

  /** The same, where the caller knows whether the polygon is convex. */
  Circle Find(PolygonView polygon, bool convex);

  /** The largest circle in the kernel of the polygon. The radius is 0 if there is none. */
  Circle FindInKernel(PolygonView polygon);

  /** The same, where its sides are known; relative to what they are relative to. */
  Circle FindInKernel(const std::vector<PolygonKernelFinder::Side>& sides);

private:
  struct Site // an edge as seen from a point
  {
    double Distance;
    Point2 Away; // unit vector from the nearest point of the edge
  };

  void SetPolygon(PolygonView polygon);
  Circle FindByClimbing(PolygonView polygon);
  void AddBox(const Point2& middle, double reach);
  double Tolerance() const;
  double SeeAll(const Point2& point, std::vector<Site>& sites) const;
  void Climb(Point2 point);
  bool ClimbStep(Point2& point, double& distance);
  bool IsAtTop(double distance) const;

  Circle Best; // relative to the first vertex
  Point2 Low;  // of the bounding box
  Point2 High;
  BoundaryCover Boundary;
  std::vector<Site> Sites;
  std::vector<Site> NextSites;
  SmallLinearProgram Program;
  PolygonKernelFinder KernelFinder;
};

/** The largest circle inside a counter-clockwise simple polygon. */
PEMESHFILTERSGEOMETRY_EXPORT Circle LargestInscribedCircle(PolygonView polygon);

/** The largest circle inside the kernel of a polygon; the radius is 0 if there is none. */
PEMESHFILTERSGEOMETRY_EXPORT Circle LargestCircleInKernel(PolygonView polygon);

} // namespace pemesh

#endif

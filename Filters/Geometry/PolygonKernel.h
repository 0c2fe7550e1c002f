// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The kernel of a polygon: the points that see all of it.
 *
 * The kernel is the intersection of the half planes to the left of the edges (D. T. Lee,
 * F. P. Preparata, An optimal algorithm for finding the kernel of a polygon, J. ACM 26 (1979)
 * 415-421). Here the half planes clip the bounding box one by one: O(n k) for a kernel of k
 * vertices, faster than the linear algorithm up to some hundreds of vertices, and without its
 * special cases. A convex polygon is its own kernel, exactly.
 *
 * Accuracy: every line has the direction of its edge as given, however short that is, so the area
 * is within 1e-14 of the square of the diameter. Straight and repeated vertices clip nothing. A
 * kernel without an area may be returned as fewer than three points, or as some on one line.
 */
#ifndef pemesh_PolygonKernel_h
#define pemesh_PolygonKernel_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <vector>

namespace pemesh
{

/** Clips with buffers of its own, so that a loop over elements allocates nothing. */
class PEMESHFILTERSGEOMETRY_EXPORT PolygonKernelClipper
{
public:
  /**
   * The kernel of a counter-clockwise simple polygon, counter-clockwise, relative to the first
   * vertex of the polygon (add it to place the kernel). Empty, or fewer than three vertices, or
   * an area of zero, if the polygon is not star-shaped. Valid until the next call.
   */
  const std::vector<Point2>& Clip(PolygonView polygon);

private:
  bool ClipHalfPlane(const Point2& anchor, const Point2& direction);

  std::vector<Point2> Kernel;
  std::vector<Point2> Clipped;
  std::vector<double> Heights;
};

/** The kernel of a counter-clockwise simple polygon; empty if there is none. */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<Point2> PolygonKernel(PolygonView polygon);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The kernel of a polygon, the points that see all of it, in linear time.
 *
 * D. T. Lee, F. P. Preparata, An optimal algorithm for finding the kernel of a polygon, J. ACM 26
 * (1979) 415-421. The half planes to the left of the edges are cut off one after the other, in the
 * order of the boundary. As every vertex is on the line of the edge before, it is never inside of
 * what is left, and only what it sees of that at its right (after a left turn) or at its left
 * (after a right turn) can be cut first. What it sees goes round counter-clockwise as the boundary
 * does, at most twice if there is a kernel. Two changes to the paper: the cutting begins with a
 * box, at a leftmost vertex, so that nothing is ever unbounded; and the chain consists of
 * lines, its vertices being their intersections, so that every decision is the sign of a polynomial
 * in the coordinates as given, and is exact (see Predicates.h).
 *
 * So a kernel is found if and only if it has an area, exactly. Polygons of up to FewVertices
 * vertices are first clipped by one half plane after the other, which takes half the time there;
 * only where what is left is so thin that rounding may have decided, or where three of the lines do
 * not prove that nothing can be left, the answer is that of the exact way. A convex polygon is its
 * own kernel, to the bit. A point, or a part of a line, that
 * sees the whole polygon has no area and may be left out. Accuracy: the area is within 1e-14 of the
 * square of the diameter. Straight and repeated vertices change nothing. Cost: O(n); up to
 * FewVertices O(n k) for a kernel of k sides.
 */
#ifndef pemesh_PolygonKernel_h
#define pemesh_PolygonKernel_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace pemesh
{

/** Has buffers of its own, so that a loop over elements allocates nothing. */
class PEMESHFILTERSGEOMETRY_EXPORT PolygonKernelFinder
{
public:
  /** A line that bounds the kernel: that of an edge, or of a straight chain of them. */
  struct Side
  {
    Point2 Start;     // of the side; relative to the first vertex of the polygon
    Point2 Direction; // of the edge, of any length but zero
  };

  ///@{
  /**
   * The sides of the kernel of a counter-clockwise simple polygon, counter-clockwise; none if it is
   * not star-shaped. Valid until the next call.
   */
  const std::vector<Side>& Find(PolygonView polygon);
  const std::vector<Side>& Find(PolygonView polygon, bool convex);
  ///@}

  /** Area of the kernel found last. */
  double GetArea() const;

  /**
   * Up to here a box is clipped first, O(n k) for k sides: it has fewer branches, and was measured
   * to take half the time for random stars of 24 to 200 vertices, whose kernels have few sides.
   */
  static constexpr std::size_t FewVertices = 48;

private:
  bool Clip(PolygonView polygon, const Point2& low, const Point2& high);
  bool ClipHalfPlane(const Point2& anchor, const Point2& direction, std::size_t edge);

  struct Line
  {
    Point2 From;
    Point2 To;
    std::size_t Next; // the lines around what is left
    std::size_t Previous;
    Point2 End; // where Next is met, if that is known without rounding
    bool IsEndExact;
  };

  void Start(const Point2& leftmost, std::size_t size, const Point2& low, const Point2& high);
  bool CutAll(PolygonView polygon, std::size_t first);
  bool Cut(const Point2& from, const Point2& to, bool left);
  bool Move(const Point2& vertex);
  void Join(std::size_t before, std::size_t after);
  int SideOfEnd(std::size_t line, const Line& cut) const;
  void Collect(const Point2& origin);

  std::vector<Line> Lines; // first those of a box
  std::size_t First = 0;   // of the lines that have the vertex at their right or on them
  std::size_t Last = 0;
  std::size_t Steps = 0; // along the lines, that may still be needed
  std::vector<Side> Sides;
  std::vector<Point2> Corners; // what clipping leaves, and the edge that each side is part of
  std::vector<std::size_t> SideOf;
  std::vector<Point2> Clipped;
  std::vector<std::size_t> ClippedSideOf;
  std::vector<double> Heights;
};

/** The kernel of a counter-clockwise simple polygon; empty if there is none. */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<Point2> PolygonKernel(PolygonView polygon);

} // namespace pemesh

#endif

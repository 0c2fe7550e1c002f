// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The largest circle inside a simple polygon, convex or not.
 *
 * A triangle has a closed form, and for a convex polygon the circle is the solution of a linear
 * program in three unknowns. Otherwise the distance to the boundary is maximised by branch and
 * bound over triangles that fill the polygon: each carries the edges that can be nearest to one
 * of its points, and is bounded by the linear program of the planes through their distances at
 * its corners (a distance is convex, so it is below that plane; the plane is exact beside an
 * edge). A promising centre is climbed from by Newton's method (the program of the tangent planes,
 * which are below the distances), which ends, to rounding, at a circle that touches three edges
 * or reflex vertices. With k the distance of the origin to the hull of their directions no
 * better point is within 2 k r of it, which ends the search around it. The result is the greatest
 * of all local maxima, to one part in 10^11.
 */
#ifndef pemesh_InscribedCircle_h
#define pemesh_InscribedCircle_h

#include "Circle.h"
#include "SmallLinearProgram.h"
#include "TriangulatePolygon.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <array>
#include <vector>

namespace pemesh
{

/** Searches with buffers of its own, so that a loop over elements allocates nothing. */
class PEMESHFILTERSGEOMETRY_EXPORT InscribedCircleFinder
{
public:
  /** The largest circle inside a counter-clockwise simple polygon. */
  Circle Find(PolygonView polygon);

  /** The same, where the caller knows whether the polygon is convex. */
  Circle Find(PolygonView polygon, bool convex);

  /**
   * The largest circle to the left of the lines of all edges, which is the largest in the kernel
   * of the polygon. The radius is 0 if there is none.
   */
  Circle FindInKernel(PolygonView polygon);

private:
  struct Edge // all points are relative to the first vertex
  {
    Point2 Start;
    Point2 Direction; // of length one
    double Length;
    int Chain; // of edges on almost one line, or -1
  };
  struct Chain
  {
    Point2 Start;
    Point2 Direction;
    double Length;
    double Deviation; // largest distance of its vertices to the line
  };
  struct Site // an edge as seen from a point
  {
    double Distance;
    Point2 Away; // unit vector from the nearest point of the edge
    int Edge;
  };
  struct Cell
  {
    Point2 Corners[3];
    double Bound;               // of the distance to the boundary in the cell
    std::size_t FirstCandidate; // in Candidates: the edges that can be nearest to its points
    std::size_t CandidateCount;
    bool Examined; // false for the triangles to start with
    bool Halved;   // whether a thin cell is to be cut in the middle next
  };
  struct Disc // no point of it is better than what is known
  {
    Point2 Center;
    double Radius;
  };

  static bool HasLowerBound(const Cell& a, const Cell& b) { return a.Bound < b.Bound; }
  Circle FindByBranchAndBound(PolygonView polygon);
  void SetEdges(PolygonView polygon);
  void SetChains();
  void AddChain(std::size_t first, std::size_t count);
  double Tolerance(double distance) const; // what may be left unproved
  double Threshold() const;
  Site See(const Point2& point, int edge) const;
  double SeeAll(const Point2& point, std::vector<Site>& sites) const;
  void AddTriangles(PolygonView polygon);
  void Push(const Cell& cell);
  void Examine(Cell cell);
  void ClimbIfPromising(const Point2& center, double radius, double distance);
  double BoundCell(const Cell& cell, double unit);
  std::array<double, 3> CornerHeights(const Cell& cell, const Site& site) const;
  bool IsInDisc(const Cell& cell) const;
  void Split(const Cell& cell);
  double EndOfNearestEdge(const Cell& cell, const Point2& a, const Point2& b) const;
  void Climb(Point2 point);
  bool ClimbStep(Point2& point, double& distance);
  void AddDisc(const Point2& point, double distance);

  double Scale = 0.0; // half the perimeter: at least the diameter
  Circle Best;
  std::vector<Edge> Edges;
  std::vector<Chain> Chains;
  std::vector<Site> Sites;
  std::vector<Site> ClimbSites;
  std::vector<Site> NextSites;
  std::vector<Cell> Cells; // a heap, the greatest bound first
  std::vector<int> Candidates;
  std::vector<Disc> Discs;
  std::vector<double> Angles;
  SmallLinearProgram Program;
  PolygonTriangulator Triangulator;
};

/** The largest circle inside a counter-clockwise simple polygon. */
PEMESHFILTERSGEOMETRY_EXPORT Circle LargestInscribedCircle(PolygonView polygon);

/** The largest circle inside the kernel of a polygon; the radius is 0 if there is none. */
PEMESHFILTERSGEOMETRY_EXPORT Circle LargestCircleInKernel(PolygonView polygon);

} // namespace pemesh

#endif

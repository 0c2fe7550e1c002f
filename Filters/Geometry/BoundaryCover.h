// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Whether all points of a polygon are within a distance of its boundary, and if not, one that is
 * farther: the certificate of the largest inscribed circle.
 *
 * The points inside that are farther than R from the boundary form an open region, the erosion of
 * the polygon by a disc (G. Matheron, Random sets and integral geometry, 1975). Its boundary is at
 * distance R of the nearest edge: it lies on the inner parallels of the edges and on the arcs
 * around reflex vertices. Each of these curves is cut by the stadium of an edge, the points within
 * R of it, in one piece at most. So the region is empty if and only if the stadiums of the other
 * edges cover the part inside of every curve: one-dimensional questions, O(n) each. An error e of
 * rounding can hide only a region in which no point is farther than R + O(e n).
 *
 * Not all curves need be asked. Stadiums that have a point in common have a star-shaped union,
 * which has no hole. So on the boundary of every piece of the region there is a point that is
 * farther than R from all edges whose stadiums contain a given point, the center of the circle
 * found so far, say: the curves of these edges are left out.
 */
#ifndef pemesh_BoundaryCover_h
#define pemesh_BoundaryCover_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace pemesh
{

class PEMESHFILTERSGEOMETRY_EXPORT BoundaryCover
{
public:
  struct Edge // relative to the first vertex of the polygon
  {
    Point2 Start;
    Point2 Direction; // of length one
    double Length;
    double Turn;     // sine of the turn from the edge before, negative at a reflex vertex
    double HalfTurn; // tangent of half of it
  };

  /** A counter-clockwise simple polygon; edges without length are left out. */
  void SetPolygon(PolygonView polygon);

  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /** Half the perimeter: at least the diameter. */
  double GetScale() const { return this->Scale; }

  /** Whether a point, relative to the first vertex and not at the boundary, is inside. */
  bool Contains(const Point2& point) const;

  double DistanceFrom(const Point2& point) const;

  /**
   * A point inside that is farther than `radius` from the boundary, at any rate farther than
   * `radius` less `tolerance`, which has to exceed rounding; false if there is none. The answer is
   * the same for any `common` point, and soonest for one within `radius` of many edges. The search
   * goes on where the last one ended. O(n^2) at worst, mostly far less, for a curve is covered by
   * the edges next to it.
   */
  bool FindFarther(double radius, double tolerance, const Point2& common, Point2& point);

private:
  struct Interval
  {
    double Low;
    double High;
  };

  void FindEdgesAround(const Point2& common, double radius);
  bool FindOnParallel(std::size_t edge, double radius, Point2& point);
  bool FindOnArc(std::size_t vertex, double radius, Point2& point);
  template <typename Cut>
  bool IsCovered(std::size_t previous, std::size_t next, std::size_t count, const Cut& cut);
  template <typename Place>
  bool FindInGaps(const Place& place, Point2& point);
  void Shrink(const Interval& interval);

  double Scale = 0.0;
  double Least = 0.0; // what a point has to be farther than
  std::vector<Edge> Edges;
  std::vector<char> IsAround;      // of each edge, whether the common point is in its stadium
  std::vector<std::size_t> Around; // those edges
  Interval Rest{};                 // what is not covered of the curve, by a parameter along it
  std::vector<Interval> Intervals; // that cover an inner part of that
  std::size_t NextCurve = 0;
};

} // namespace pemesh

#endif

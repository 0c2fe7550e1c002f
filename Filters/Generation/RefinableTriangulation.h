// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A constrained Delaunay triangulation of a domain with holes, that points can be added to.
 *
 * Only the triangles of the domain are kept: every edge has a triangle of the domain on its left
 * side, or lies on the boundary, whose pieces are the segments. Triangles and segments are numbers
 * into flat arrays, never pointers, so that the same calls give the same triangulation on every
 * run, and memory is read in order. All decisions are exact; a call that cannot keep all
 * triangles counter-clockwise changes nothing and says so.
 *
 * Points are added by the algorithm of Bowyer and Watson: the triangles whose circumcircle holds
 * the new point and that are reached without crossing a segment (the zone) are replaced by the
 * star of the point. A. Bowyer, Computer Journal 24 (1981) 162-166; D. F. Watson, Computer Journal
 * 24 (1981) 167-172.
 */
#ifndef pemesh_RefinableTriangulation_h
#define pemesh_RefinableTriangulation_h

#include "Point2.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pemesh
{

class RefinableTriangulation
{
public:
  struct Triangle
  {
    int Vertex[3]; ///< counter-clockwise
    /** Across the edge opposite to the vertex: a triangle, or a segment s stored as ~s. */
    int Neighbor[3];
  };

  /** A piece of the boundary; its triangle is on its left. */
  struct Segment
  {
    int Triangle;
    int Input; ///< the input segment that it is a piece of
  };

  /** An edge of the zone's boundary, zone on the left. */
  struct ZoneEdge
  {
    int From;
    int To;
    int Outside; ///< a triangle, or ~segment
  };

  RefinableTriangulation() = default;
  RefinableTriangulation(
    std::vector<Point2> points, std::vector<Triangle> triangles, std::vector<Segment> segments);

  ///@{
  const std::vector<Point2>& GetPoints() const { return this->Points; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  const std::vector<Segment>& GetSegments() const { return this->Segments; }
  const Point2& GetPoint(int vertex) const { return this->Points[vertex]; }
  const Triangle& GetTriangle(int triangle) const { return this->Triangles[triangle]; }
  const Segment& GetSegment(int segment) const { return this->Segments[segment]; }
  /** Changes whenever the triangle of that number becomes another one. */
  std::uint32_t GetStamp(int triangle) const { return this->Stamps[triangle]; }
  int NumberOfTriangles() const { return static_cast<int>(this->Triangles.size()); }
  int NumberOfSegments() const { return static_cast<int>(this->Segments.size()); }
  ///@}

  /** Makes room for that many more points in the interior, and their triangles. */
  void Reserve(std::size_t points);

  /** The edge of a segment in its triangle: 0, 1 or 2. */
  int EdgeOfSegment(int segment) const;

  /** Flips edges until the triangulation is constrained Delaunay. */
  void MakeDelaunay();

  /** Whether the point lies strictly in the circumcircle of the triangle. */
  bool IsInCircle(int triangle, const Point2& point) const;

  ///@{
  /**
   * Finds the zone of a point, starting at a triangle whose circumcircle holds it: empty if it
   * does not. For a segment, the start is its triangle, and the point is meant to be on it.
   */
  void FindZone(int triangle, const Point2& point);
  void FindZoneOfSegment(int segment, const Point2& point);
  const std::vector<int>& GetZone() const { return this->Zone; }
  const std::vector<ZoneEdge>& GetZoneEdges() const { return this->ZoneEdges; }
  /** Whether the point is in a triangle of the zone, its edges included. */
  bool ZoneContains(const Point2& point) const;
  ///@}

  ///@{
  /**
   * Replaces the zone just found by the star of its point: the new vertex, or -1 if the point does
   * not see the whole zone. With a segment, that one is split in two; it keeps its number for the
   * piece before the new vertex.
   */
  int InsertInZone(const Point2& point);
  int SplitSegment(int segment, const Point2& point);
  /** The triangles that the last insertion made: all triangles of the new vertex. */
  const std::vector<int>& GetStar() const { return this->Star; }
  ///@}

private:
  void GrowZone(int start, const Point2& point, int skippedSegment);
  bool IsZoneVisible(const Point2& point) const;
  int MakeStar(const Point2& point, int newNeighborFrom, int newNeighborTo, int from, int to);
  void SetNeighbor(int neighbor, int from, int to, int triangle);
  bool FlipIfNeeded(int triangle, int edge);

  std::vector<Point2> Points;
  std::vector<Triangle> Triangles;
  std::vector<Segment> Segments;
  std::vector<std::uint32_t> Stamps; ///< a triangle each
  std::vector<std::uint32_t> Marks;  ///< a triangle each: the last zone that looked at it
  std::uint32_t Mark = 0;
  std::vector<int> Zone;
  std::vector<ZoneEdge> ZoneEdges;
  std::vector<int> Star;
  std::vector<int> StartingAt; ///< a vertex each: the star triangle whose zone edge starts there
};

} // namespace pemesh

#endif

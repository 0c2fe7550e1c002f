// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The constrained Delaunay triangulation of a domain with holes, before any refinement.
 */
#ifndef pemesh_DomainTriangulation_h
#define pemesh_DomainTriangulation_h

#include "Domain.h"
#include "Point2.h"
#include "RefinableTriangulation.h"

#include <limits>
#include <vector>

namespace pemesh
{

/** A piece of the domain's boundary as given, domain on the left. */
struct InputSegment
{
  int From;
  int To;
};

/**
 * The boundary of a domain: closed loops of vertices that do not meet. Vertices are numbered loop
 * after loop. Segment i starts at vertex i, so the segments around vertex i are i and Before(i).
 */
struct DomainBoundary
{
  std::vector<Point2> Points;
  std::vector<InputSegment> Segments;
  std::vector<int> Before;     ///< a vertex each: the segment that ends there
  int NumberOfPolygonSegments; ///< the first ones; the others are those of the domain's own loops
};

/**
 * The boundary of a domain less polygons, all counter-clockwise, that lie in it and do not meet
 * each other or its loops. Vertices of the polygons come first, in their order, then those of the
 * domain's holes, then those of its outer loop.
 */
DomainBoundary MakeDomainBoundary(
  const Domain& domain, const std::vector<std::vector<Point2>>& polygons);

/**
 * What is left of the convex hull of the domain: triangles in holes, polygons and bays, so that a
 * walk from one point of the domain to another can pass there.
 */
struct OutsideTriangles
{
  /** Neighbours are other triangles outside, segments s as ~s, or nothing: OutsideHull. */
  std::vector<RefinableTriangulation::Triangle> Triangles;
  std::vector<int> Beyond; ///< a segment each: the triangle on its right, or OutsideHull

  static constexpr int OutsideHull = std::numeric_limits<int>::max();
};

struct DomainTriangulation
{
  RefinableTriangulation Inside;
  OutsideTriangles Outside;
};

/**
 * The constrained Delaunay triangulation of what the boundary encloses. Segment i of the
 * triangulation is segment i of the boundary. Throws std::runtime_error if loops meet.
 */
DomainTriangulation TriangulateDomain(const DomainBoundary& boundary);

} // namespace pemesh

#endif

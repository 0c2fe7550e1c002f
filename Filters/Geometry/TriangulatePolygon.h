// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Triangles that fill a simple polygon, for display and quadrature.
 *
 * Ears are cut with exact predicates, so that the areas of the triangles add up to the area of
 * the polygon however close to degenerate it is, and straight (hanging) vertices are corners of
 * triangles like all others. Reference: G. H. Meisters, Polygons have ears, Amer. Math. Monthly
 * 82 (1975) 648-651. Cost O(n (1 + r)) for r reflex vertices.
 */
#ifndef pemesh_TriangulatePolygon_h
#define pemesh_TriangulatePolygon_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <array>
#include <vector>

namespace pemesh
{

/** Indices into the vertices of the polygon, counter-clockwise in the plane. */
using PolygonTriangle = std::array<int, 3>;

/** Cuts ears with buffers of its own, so that a loop over elements allocates nothing. */
class PEMESHFILTERSGEOMETRY_EXPORT PolygonTriangulator
{
public:
  /**
   * n - 2 triangles of a simple polygon of n distinct vertices, counter-clockwise or clockwise; a
   * repeated vertex gives one triangle less. No triangles where all vertices are on one line.
   * Polygons that cross themselves give some set of triangles. Valid until the next call.
   */
  const std::vector<PolygonTriangle>& Triangulate(PolygonView polygon);

private:
  void LinkVertices(bool reversed);
  int TurnAt(int vertex) const;
  bool IsEar(int vertex, bool strictly) const;
  int FindEar(int start, bool strictly) const;
  void CutEar(int vertex);
  int Remove(int vertex);

  PolygonView Polygon;
  std::vector<int> Next;
  std::vector<int> Previous;
  std::vector<int> Turn;   // the sign of the turn at each vertex of the ring
  std::vector<int> Reflex; // the vertices that did not turn left at first: only these can block
  int Remaining = 0;
  std::vector<PolygonTriangle> Triangles;
};

/** The triangles of one polygon; see PolygonTriangulator. */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<PolygonTriangle> TriangulatePolygon(PolygonView polygon);

} // namespace pemesh

#endif

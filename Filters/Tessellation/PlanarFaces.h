// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The faces of a plane graph with straight edges.
 */
#ifndef pemesh_PlanarFaces_h
#define pemesh_PlanarFaces_h

#include "Point2.h"

#include <vector>

namespace pemesh
{

/** What lies to the left of an edge, as far as the edge knows. */
struct LeftSide
{
  int Cell = -1;          ///< a cell of the mesh; -1 if it is not known
  bool InDomain = false;  ///< the edge is on the boundary of the domain, which is to its left
  bool OffDomain = false; ///< ... which is to its right

  void Merge(const LeftSide& other);
};

/** One direction of an edge. */
struct HalfEdge
{
  int From;
  int To;
  LeftSide Left;
};

struct PlanarFace
{
  std::vector<int> Vertices; ///< counter-clockwise; clockwise for the outer border of a component
  LeftSide Left;             ///< what any of its edges knew
};

/** Sorts edges and makes one of those with the same ends. */
void MergeRepetitions(std::vector<HalfEdge>& edges);

/**
 * Each edge is given at least once in both directions; repetitions are merged. Edges meet in common
 * ends only. The order of edges around a vertex is decided exactly; the order of the faces follows
 * the numbers of their vertices.
 */
std::vector<PlanarFace> FindPlanarFaces(
  const std::vector<Point2>& points, std::vector<HalfEdge> edges);

} // namespace pemesh

#endif

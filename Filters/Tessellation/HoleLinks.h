// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lines that join holes in the middle of a cell to what is around them, so that no element has a
 * hole.
 */
#ifndef pemesh_HoleLinks_h
#define pemesh_HoleLinks_h

#include "BoundaryContacts.h"
#include "PlanarFaces.h"

namespace pemesh
{

/**
 * Of each hole that meets edges of cells in fewer than two points: a horizontal line from its
 * leftmost vertex to the left and one from its rightmost vertex to the right, each up to the first
 * edge. Following the lines to either side one comes to the edges of a cell in different points, so
 * that no face touches itself.
 */
class HoleLinks
{
public:
  explicit HoleLinks(const BoundaryContacts& contacts);

  /** Marks the cells that the holes lie in, and those that get a vertex of a line. */
  void MarkCells(const BoundaryContacts& contacts, std::vector<bool>& isCut);

  /** Adds the lines to merged edges; splits the edges at which they end. */
  void AddTo(double tolerance, std::vector<Point2>& points, std::vector<HalfEdge>& edges);

private:
  struct Ray
  {
    Point2 Origin;
    int Vertex = -1;
    double Direction = 1.0; ///< 1 to the right, -1 to the left
    double Length = 0.0;
    Point2 Landing;
    int Edge = -1;
  };
  void Reset();
  void Meet(const std::vector<Point2>& points, int from, int to, int edge);

  std::vector<Ray> Rays; ///< from south to north
};

} // namespace pemesh

#endif

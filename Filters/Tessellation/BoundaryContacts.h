// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where the edges of a mesh and the boundary of a domain meet.
 */
#ifndef pemesh_BoundaryContacts_h
#define pemesh_BoundaryContacts_h

#include "Domain.h"
#include "PolygonMesh.h"

#include <map>
#include <utility>
#include <vector>

namespace pemesh
{

struct PointOnEdge
{
  double Position; ///< from 0 to 1
  int Point;
};

/** The points inside some edges. */
using PointsOnEdges = std::map<int, std::vector<PointOnEdge>>;

/** The domain is to its left. */
struct DomainEdge
{
  int From;
  int To;
  int Loop; ///< 0 is the outer one
};

struct BoundaryContacts
{
  /** The cells; its points are those of the cells, then those of the domain, then crossings. */
  PolygonMesh Cells;
  MeshAdjacency Adjacency;
  std::vector<DomainEdge> DomainEdges;
  std::vector<bool> HasContact; ///< a domain edge each: cells have a vertex where it starts
  std::vector<bool> IsTouched;  ///< a point each: the cells of which it is a vertex are cut
  PointsOnEdges OnCellEdges;    ///< by the side, of two that face each other the first one
  PointsOnEdges OnDomainEdges;

  /** The side that OnCellEdges knows the edge by. */
  int EdgeOf(int side) const
  {
    const int twin = this->Adjacency.Twin[side];
    return twin >= 0 && twin < side ? twin : side;
  }
  int EndOf(int side) const
  {
    return this->Cells.Vertices[NextSide(this->Cells, this->Adjacency.Element[side], side)];
  }
};

/** See ClipMesh. The points of an edge are sorted. */
BoundaryContacts FindBoundaryContacts(
  const PolygonMesh& cells, const Domain& domain, double tolerance);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Vertices of a simple polygon that wander one by one, so that the polygon is simple at every
 * moment: the second half of a random polygon (see RandomPolygon.h).
 */
#ifndef pemesh_VertexWalk_h
#define pemesh_VertexWalk_h

#include "Point2.h"
#include "RandomNumbers.h"

#include <array>
#include <vector>

namespace pemesh
{

class VertexWalk
{
public:
  /** A simple polygon of four vertices or more in the unit disc. Draws go on with `random`. */
  VertexWalk(std::vector<Point2> vertices, RandomNumbers& random);

  /** So many tries; of a fraction, the last vertex goes that part of its way. */
  void Go(double tries);

  const std::vector<Point2>& GetVertices() const { return this->Vertices; }

private:
  /** The way of one vertex: from Start to End, between its neighbours. */
  struct Step
  {
    int Vertex;
    int Previous;
    int Next;
    Point2 Start;
    Point2 End;
  };
  struct CellRange
  {
    int Low;
    int High;
  };

  Step DrawStep();
  bool IsFree(const Step& step);
  bool AnyBlocks(const std::vector<int>& cell, const Step& step);
  bool FoldsNeighbours(const Step& step) const;
  bool Blocks(int edge, const Step& step) const;
  bool BlocksAsNeighbour(
    const Point2& joint, const Point2& other, const Point2& opposite, const Step& step) const;
  void Take(const Step& step);

  const Point2& EndOf(int edge) const;
  double LowOf(int cell) const { return 2.0 * cell / this->Columns - 1.0; }
  CellRange CellsOf(double low, double high) const;
  CellRange RowsOf(const std::array<Point2, 4>& hull, int column) const;
  std::vector<int>& CellAt(int column, int row);
  template <typename Function>
  void ForCellsAlong(Point2 from, Point2 to, const Function& function);
  void InsertEdge(int edge);
  void RemoveEdge(int edge);

  std::vector<Point2> Vertices;
  RandomNumbers& Random;
  double Clearance;                    ///< that edges keep from each other
  int Levels = 1;                      ///< steps are up to 2^-level long, for level 0 to Levels - 1
  int Columns;                         ///< of the grid over [-1, 1]^2, and its rows
  std::vector<std::vector<int>> Cells; ///< the edges that come near each cell of the grid
  std::vector<int> Visited;            ///< the last query that met an edge
  int Query = 0;
};

} // namespace pemesh

#endif

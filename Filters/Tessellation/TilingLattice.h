// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A lattice over the bounding rectangle of a domain, and what tilings on it share.
 */
#ifndef pemesh_TilingLattice_h
#define pemesh_TilingLattice_h

#include "DomainLocator.h"
#include "Tessellations.h"

#include <functional>
#include <string>

namespace pemesh
{

/** Columns times rows of rectangles that are as square as they can be. */
struct TilingLattice
{
  Box Bounds;
  int Columns = 1;
  int Rows = 1;

  /** Column and row may be fractions; at the ends the point is on the border exactly. */
  Point2 At(double column, double row) const
  {
    return { Place(this->Bounds.Low.x, this->Bounds.High.x, column / this->Columns),
      Place(this->Bounds.Low.y, this->Bounds.High.y, row / this->Rows) };
  }

  /** The corners of the rectangles are numbered row by row. */
  int Corner(int column, int row) const { return row * (this->Columns + 1) + column; }

  /** Adds all corners, moved by what `displacement` says in units of a rectangle. */
  void AddCorners(
    const std::function<Point2(int column, int row)>& displacement, PolygonMesh& mesh) const;

private:
  static double Place(double low, double high, double share)
  {
    return share == 1.0 ? high : low + share * (high - low);
  }
};

/** How large a tiling is, for each rectangle of the lattice. */
struct TilingSize
{
  double Elements = 1.0;
  double Sides = 4.0;
};

/**
 * Tiles the bounding rectangle, on a lattice with the parameter "squares" columns, and cuts the
 * tiling off at the boundary of the domain. `tile` adds points and elements; border sides of the
 * tiling are on the border of the rectangle exactly.
 */
TessellationResult TileDomain(const TessellationInput& input, const TilingSize& size,
  const std::function<void(const TilingLattice&, PolygonMesh&)>& tile);

/** Clips unless the domain is a rectangle, which `cells` fill; `count` is how many would be. */
TessellationResult ClipToDomain(
  PolygonMesh cells, const Domain& domain, double count, bool fillsRectangle);

/**
 * What is nearer than the tolerance counts as the same place: 1e-9 of the side of a square of the
 * mean area of `count` elements. Empty, or one sentence if doubles are too coarse for that.
 */
std::string FindTolerance(const Domain& domain, double count, double& tolerance);

TessellationResult TooManyElements(double count, double most);

} // namespace pemesh

#endif

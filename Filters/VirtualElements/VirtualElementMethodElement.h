// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One element of the lowest-order virtual element method: the projection and the stiffness matrix.
 *
 * The basis functions phi_i are one at vertex i, zero at the others, linear on every edge and
 * harmonic inside. Their projection on the linear functions,
 *   Pi phi_i = Constant[i] + GradientX[i] (x - xc) / h + GradientY[i] (y - yc) / h,
 * has the mean gradient of phi_i (known from the boundary) and, for its constant, the same mean
 * over the boundary, or over the vertices. (xc, yc) is the centroid, h the diameter, so that
 * Constant[i] is also the mean of Pi phi_i over the element.
 *
 * K = (grad Pi phi_i, grad Pi phi_j) + sum over the vertices of (phi_i - Pi phi_i)(phi_j - Pi
 * phi_j): consistency, and the "dofi-dofi" stabilisation, not scaled (in two dimensions K does not
 * change with the size of the element).
 *
 * References: L. Beirao da Veiga, F. Brezzi, A. Cangiani, G. Manzini, L. D. Marini, A. Russo, Basic
 * principles of virtual element methods, Math. Models Methods Appl. Sci. 23 (2013) 199-214; L.
 * Beirao da Veiga, F. Brezzi, L. D. Marini, A. Russo, The hitchhiker's guide to the virtual element
 * method, Math. Models Methods Appl. Sci. 24 (2014) 1541-1573.
 */
#ifndef pemesh_VirtualElementMethodElement_h
#define pemesh_VirtualElementMethodElement_h

#include "Point2.h"
#include "VirtualElementOptions.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

/** The largest distance between two vertices. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double PolygonDiameter(PolygonView vertices);

/**
 * The mean over the boundary of a function that is linear on each edge is a weighted mean of its
 * values at the vertices: half the lengths of the two edges, over the perimeter.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::vector<double> BoundaryMeanWeights(PolygonView vertices);

class PEMESHFILTERSVIRTUALELEMENTS_EXPORT VirtualElement
{
public:
  /** Takes a counter-clockwise simple polygon. The object can be used again: it keeps its memory.
   */
  void Set(PolygonView vertices, ProjectionConstant constant);

  ///@{
  /** Of the polygon last set. */
  std::size_t NumberOfVertices() const { return this->Constants.size(); }
  double Area() const { return this->ElementArea; }
  double Diameter() const { return this->ElementDiameter; }
  Point2 Centroid() const { return this->ElementCentroid; }
  ///@}

  ///@{
  /** The coefficients of the projections of the basis functions. */
  std::span<const double> Constant() const { return this->Constants; }
  std::span<const double> GradientX() const { return this->GradientsX; }
  std::span<const double> GradientY() const { return this->GradientsY; }
  ///@}

  /** The scaled monomials (x - xc) / h and (y - yc) / h at a point. */
  Point2 Scaled(Point2 point) const
  {
    return { (point.x - this->ElementCentroid.x) / this->ElementDiameter,
      (point.y - this->ElementCentroid.y) / this->ElementDiameter };
  }

  /** The lower triangle, row by row: entry (i, j <= i) is at i (i + 1) / 2 + j. */
  void GetStiffness(std::span<double> packed);

private:
  double ElementArea = 0.0;
  double ElementDiameter = 0.0;
  Point2 ElementCentroid;
  std::vector<double> Constants;
  std::vector<double> GradientsX;
  std::vector<double> GradientsY;
  std::vector<Point2> Monomials; // at the vertices
  std::vector<double> Remainder; // column j: the values of phi_j - Pi phi_j at the vertices
};

} // namespace pemesh

#endif

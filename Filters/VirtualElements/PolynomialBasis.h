// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Polynomials on an element: a basis p_1, p_2, … ordered by degree, so that the first d (d + 1) / 2
 * of them span the polynomials of degree d - 1. Private to the module (needs Eigen).
 *
 * With (x_c, y_c) the centroid, the basis starts from the monomials of z = A (x - x_c, y - y_c):
 * A = 1 / diameter, or the map to the axes of inertia, which makes a sliver round. It may then be
 * made orthonormal in the mean, (1/|E|) integral of p_i p_j = delta_ij.
 */
#ifndef pemesh_PolynomialBasis_h
#define pemesh_PolynomialBasis_h

#include "Quadrature.h"
#include "VirtualElementOptions.h"

#include <Eigen/Dense>

namespace pemesh
{

/** Column k holds the values of polynomial k at the points of a block. */
using BlockValues = Eigen::Array<double, PointBlockSize, Eigen::Dynamic>;

/** How many polynomials of degree `degree` or less there are; 0 for a negative degree. */
constexpr Eigen::Index PolynomialCount(int degree)
{
  return degree < 0 ? 0 : Eigen::Index{ degree + 1 } * (degree + 2) / 2;
}

/** The coefficients of a polynomial of an order that there is, without a memory of their own. */
using PolynomialCoefficients =
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, PolynomialCount(LargestOrder), 1>;

/** Calls body(points, weights) for all blocks of points of a rule on all triangles. */
template <typename Body>
void ForEachBlock(std::span<const Triangle2> triangles, int degree, const Body& body)
{
  const std::span<const QuadratureBlock> rule = TriangleRuleOfDegree(degree);
  PointBlock points;
  Eigen::Array<double, PointBlockSize, 1> weights;
  for (const Triangle2& triangle : triangles)
  {
    const double area = TriangleArea(triangle);
    for (const QuadratureBlock& block : rule)
    {
      PlaceBlock(block, triangle, points);
      weights =
        area * Eigen::Map<const Eigen::Array<double, PointBlockSize, 1>>(block.Weight.data());
      body(points, weights);
    }
  }
}

class PolynomialBasis
{
public:
  /** The element is the union of the triangles; keeps its memory from element to element. */
  void Set(const BasisRule& rule, int degree, PolygonView vertices, double diameter, double area,
    Point2 centroid, std::span<const Triangle2> triangles);

  int Degree() const { return this->HighestDegree; }
  Eigen::Index Size() const { return PolynomialCount(this->HighestDegree); }

  /** The polynomials of degree `degree` or less, at most Degree(). */
  void Evaluate(const PointBlock& points, int degree, BlockValues& values) const;

  ///@{
  /**
   * The monomials that the basis is made of, and the change to them: of the coefficients of a
   * polynomial, and of the integrals of monomials times a function to those of the basis. A
   * polynomial at many points costs least through them.
   */
  void EvaluateMonomials(const PointBlock& points, int degree, BlockValues& values) const;
  PolynomialCoefficients ToMonomials(const PolynomialCoefficients& coefficients) const;
  PolynomialCoefficients FromMonomialIntegrals(const PolynomialCoefficients& integrals) const;
  ///@}

  ///@{
  /** The derivatives in the basis: d p_i / dx = sum of DerivativeX(i, j) p_j. */
  const Eigen::MatrixXd& DerivativeX() const { return this->DerivativesX; }
  const Eigen::MatrixXd& DerivativeY() const { return this->DerivativesY; }
  ///@}

private:
  void SetInertiaMap(PolygonView vertices, double area, std::span<const Triangle2> triangles);
  void Orthonormalize(double area, std::span<const Triangle2> triangles);
  void SetMonomialDerivatives();

  int HighestDegree = 0;
  Point2 Center;
  Eigen::Matrix2d Map;
  bool IsTransformed = false;
  Eigen::MatrixXd Transform; // upper triangular: the basis is the monomials times it
  Eigen::MatrixXd DerivativesX;
  Eigen::MatrixXd DerivativesY;
  mutable BlockValues Monomials;
  mutable BlockValues Work;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolynomialBasis.h"

#include <cmath>

namespace pemesh
{

namespace
{

using Points8 = Eigen::Array<double, PointBlockSize, 1>;

Eigen::Map<const Points8> AsArray(const BlockOfNumbers& numbers)
{
  return Eigen::Map<const Points8>(numbers.data());
}

// The place of x^(degree - j) y^j in the basis.
Eigen::Index MonomialIndex(int degree, int j)
{
  return PolynomialCount(degree - 1) + j;
}

} // namespace

void PolynomialBasis::Set(const BasisRule& rule, int degree, PolygonView vertices, double diameter,
  double area, Point2 centroid, std::span<const Triangle2> triangles)
{
  this->HighestDegree = degree;
  this->Center = centroid;
  this->IsTransformed = false;
  this->Map = Eigen::Matrix2d::Identity() / diameter;
  if (rule.AlongAxesOfInertia)
  {
    this->SetInertiaMap(vertices, area, triangles);
  }
  this->SetMonomialDerivatives();
  if (rule.Orthonormal)
  {
    this->Orthonormalize(area, triangles);
  }
}

// The element's image has the unit matrix for its tensor of inertia (over its area), up to the
// scale, which puts the farthest vertex at the distance one. Where the tensor has rank one in
// double precision the element is a line for all purposes, and the isotropic map stays.
void PolynomialBasis::SetInertiaMap(
  PolygonView vertices, double area, std::span<const Triangle2> triangles)
{
  Eigen::Matrix2d tensor = Eigen::Matrix2d::Zero();
  ForEachBlock(triangles, 2,
    [&](const PointBlock& points, const Points8& weights)
    {
      const Points8 x = AsArray(points.X) - this->Center.x;
      const Points8 y = AsArray(points.Y) - this->Center.y;
      tensor(0, 0) += (weights * x * x).sum();
      tensor(1, 0) += (weights * x * y).sum();
      tensor(1, 1) += (weights * y * y).sum();
    });
  tensor /= area;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(tensor);
  if (!(axes.eigenvalues()(0) > 1.0e-30 * axes.eigenvalues()(1)))
  {
    return;
  }
  const Eigen::Matrix2d map =
    axes.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal() * axes.eigenvectors().transpose();
  double radius = 0.0;
  for (const Point2& vertex : vertices)
  {
    const Eigen::Vector2d place(vertex.x - this->Center.x, vertex.y - this->Center.y);
    radius = std::max(radius, (map * place).norm());
  }
  this->Map = map / radius;
}

void PolynomialBasis::SetMonomialDerivatives()
{
  const Eigen::Index size = this->Size();
  this->DerivativesX.setZero(size, size);
  this->DerivativesY.setZero(size, size);
  for (int degree = 1; degree <= this->HighestDegree; ++degree)
  {
    for (int j = 0; j <= degree; ++j)
    {
      const Eigen::Index row = MonomialIndex(degree, j);
      if (j < degree)
      {
        const Eigen::Index column = MonomialIndex(degree - 1, j);
        this->DerivativesX(row, column) += (degree - j) * this->Map(0, 0);
        this->DerivativesY(row, column) += (degree - j) * this->Map(0, 1);
      }
      if (j > 0)
      {
        const Eigen::Index column = MonomialIndex(degree - 1, j - 1);
        this->DerivativesX(row, column) += j * this->Map(1, 0);
        this->DerivativesY(row, column) += j * this->Map(1, 1);
      }
    }
  }
}

// Modified Gram-Schmidt on the values at the points of an exact rule, twice (L. Giraud, J. Langou,
// M. Rozloznik, Comput. Math. Appl. 50 (2005) 1069-1075: twice is enough).
void PolynomialBasis::Orthonormalize(double area, std::span<const Triangle2> triangles)
{
  const Eigen::Index size = this->Size();
  const int degree = 2 * this->HighestDegree;
  const auto rows = static_cast<Eigen::Index>(
    triangles.size() * TriangleRuleOfDegree(degree).size() * PointBlockSize);
  Eigen::MatrixXd values(rows, size);
  Eigen::VectorXd roots(rows);
  Eigen::Index row = 0;
  ForEachBlock(triangles, degree,
    [&](const PointBlock& points, const Points8& weights)
    {
      this->EvaluateMonomials(points, this->HighestDegree, this->Work);
      roots.segment<PointBlockSize>(row) = (weights / area).sqrt();
      values.middleRows<PointBlockSize>(row) = this->Work.matrix();
      row += PointBlockSize;
    });
  values.array().colwise() *= roots.array();
  this->Transform.setIdentity(size, size);
  for (int pass = 0; pass < 2; ++pass)
  {
    for (Eigen::Index j = 0; j < size; ++j)
    {
      for (Eigen::Index i = 0; i < j; ++i)
      {
        const double overlap = values.col(i).dot(values.col(j));
        values.col(j) -= overlap * values.col(i);
        this->Transform.col(j) -= overlap * this->Transform.col(i);
      }
      const double norm = values.col(j).norm();
      values.col(j) /= norm;
      this->Transform.col(j) /= norm;
    }
  }
  this->IsTransformed = true;
  // p = T' m and dm/dx = D m, so that dp/dx = T' D T'^-1 p.
  const auto lower = this->Transform.transpose().triangularView<Eigen::Lower>();
  for (Eigen::MatrixXd* derivative : { &this->DerivativesX, &this->DerivativesY })
  {
    const Eigen::MatrixXd product = lower * *derivative;
    *derivative = this->Transform.triangularView<Eigen::Upper>()
                    .solve(product.transpose())
                    .transpose()
                    .triangularView<Eigen::StrictlyLower>();
  }
}

void PolynomialBasis::EvaluateMonomials(
  const PointBlock& points, int degree, BlockValues& values) const
{
  values.resize(Eigen::NoChange, PolynomialCount(degree));
  const Points8 x = AsArray(points.X) - this->Center.x;
  const Points8 y = AsArray(points.Y) - this->Center.y;
  const Points8 first = this->Map(0, 0) * x + this->Map(0, 1) * y;
  const Points8 second = this->Map(1, 0) * x + this->Map(1, 1) * y;
  values.col(0).setOnes();
  for (int d = 1; d <= degree; ++d)
  {
    for (int j = 0; j < d; ++j)
    {
      values.col(MonomialIndex(d, j)) = first * values.col(MonomialIndex(d - 1, j));
    }
    values.col(MonomialIndex(d, d)) = second * values.col(MonomialIndex(d - 1, d - 1));
  }
}

void PolynomialBasis::Evaluate(const PointBlock& points, int degree, BlockValues& values) const
{
  if (!this->IsTransformed)
  {
    this->EvaluateMonomials(points, degree, values);
    return;
  }
  this->EvaluateMonomials(points, degree, this->Monomials);
  const Eigen::Index size = PolynomialCount(degree);
  values.resize(Eigen::NoChange, size);
  values.matrix().noalias() =
    this->Monomials.matrix().lazyProduct(this->Transform.topLeftCorner(size, size));
}

PolynomialCoefficients PolynomialBasis::ToMonomials(
  const PolynomialCoefficients& coefficients) const
{
  const Eigen::Index size = coefficients.size();
  return this->IsTransformed
    ? PolynomialCoefficients(this->Transform.topLeftCorner(size, size).lazyProduct(coefficients))
    : coefficients;
}

PolynomialCoefficients PolynomialBasis::FromMonomialIntegrals(
  const PolynomialCoefficients& integrals) const
{
  const Eigen::Index size = integrals.size();
  return this->IsTransformed
    ? PolynomialCoefficients(
        this->Transform.topLeftCorner(size, size).transpose().lazyProduct(integrals))
    : integrals;
}

} // namespace pemesh

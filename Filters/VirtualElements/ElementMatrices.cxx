// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementMatrices.h"

#include "EllipticProblem.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

using Weights8 = Eigen::Array<double, PointBlockSize, 1>;
using Eigen::Index;

// Coefficients are no polynomials: so many degrees more than the polynomials need.
constexpr int ExtraDegree = 8;

const BasisRule& MonomialRule()
{
  return *FindByName(BasisRules(), "monomial");
}

Weights8 Times(const Weights8& weights, const BlockOfNumbers& values)
{
  return weights * Eigen::Map<const Weights8>(values.data());
}

} // namespace

ElementMatrices::ElementMatrices(
  const EllipticProblem& problem, const VirtualElementOptions& options)
  : Problem(problem)
  , Options(options)
  , Order(options.Order)
  , ClosedForm(options.Order == 1 && problem.IsPoisson() &&
      options.Stabilisation == &StabilisationRules().front() &&
      options.Load != LoadProjection::SameDegree)
  , EdgeRule(GaussLobatto(options.Order + 1))
{
}

void ElementMatrices::Set(PolygonView vertices, bool withMatrix)
{
  this->Vertices.assign(vertices.begin(), vertices.end());
  this->Parts = this->Cutter.Cut(vertices);
  const Index n = static_cast<Index>(vertices.size());
  this->BoundaryDofs = n * this->Order;
  this->Dofs = this->BoundaryDofs + this->NumberOfMoments();
  if (this->Order == 1)
  {
    this->Lowest.Set(vertices, this->Options.Constant);
    this->ElementArea = this->Lowest.Area();
    this->ElementDiameter = this->Lowest.Diameter();
    this->ElementCentroid = this->Lowest.Centroid();
  }
  else
  {
    this->ElementArea = SignedArea(vertices);
    this->ElementDiameter = PolygonDiameter(vertices);
    this->ElementCentroid = Centroid(vertices);
  }
  this->ClosedForm ? this->SetLowestOrder(withMatrix) : this->SetGeneral();
}

void ElementMatrices::SetLowestOrder(bool withMatrix)
{
  this->Polynomials.Set(MonomialRule(), 1, this->Vertices, this->ElementDiameter, this->ElementArea,
    this->ElementCentroid, this->Parts);
  const Index n = this->Dofs;
  if (withMatrix)
  {
    this->Packed.resize(static_cast<std::size_t>(n * (n + 1) / 2));
    this->Lowest.GetStiffness(this->Packed);
  }
  this->Gradient.resize(3, n);
  for (Index i = 0; i < n; ++i)
  {
    const auto place = static_cast<std::size_t>(i);
    this->Gradient(0, i) = this->Lowest.Constant()[place];
    this->Gradient(1, i) = this->Lowest.GradientX()[place];
    this->Gradient(2, i) = this->Lowest.GradientY()[place];
  }
  this->LoadMatrix = this->Gradient.topRows(this->Options.Load == LoadProjection::Gradient ? 3 : 1);
}

void ElementMatrices::SetGeneral()
{
  this->GradientDegree =
    this->Options.Stabilisation->Weight ? this->Order - 1 : this->EnlargedDegree();
  this->Polynomials.Set(*this->Options.Basis, std::max(this->Order, this->GradientDegree),
    this->Vertices, this->ElementDiameter, this->ElementArea, this->ElementCentroid, this->Parts);
  this->Integrate();
  this->FindNodes();
  this->AddEdgeFluxes();
  this->ProjectGradients();
  this->FindMoments();
  this->ProjectFluxes();
  this->AddDiffusion();
  if (this->Options.Stabilisation->Weight)
  {
    this->AddStabilisation();
  }
  this->AddLowerTerms();
  this->SetLoad();
}

// The smallest l >= k - 1 with (l + 1) (l + 2) >= dofs - 1: as many numbers in the projection of a
// gradient as it takes to tell all functions apart, but for constants.
int ElementMatrices::EnlargedDegree() const
{
  int degree = this->Order - 1;
  while (Index{ degree + 1 } * (degree + 2) < this->Dofs - 1)
  {
    ++degree;
  }
  return degree;
}

void ElementMatrices::Integrate()
{
  const Index size = this->Polynomials.Size();
  const int degree = this->Polynomials.Degree();
  this->H.setZero(size, size);
  ForEachBlock(this->Parts, 2 * degree,
    [&](const PointBlock& points, const Weights8& weights)
    {
      this->Polynomials.Evaluate(points, degree, this->Work);
      this->H.noalias() +=
        this->Work.matrix().transpose().lazyProduct((this->Work.colwise() * weights).matrix());
    });
  if (!this->Problem.IsPoisson())
  {
    this->IntegrateCoefficients();
  }
}

void ElementMatrices::IntegrateCoefficients()
{
  const Index size = this->Polynomials.Size();
  const int degree = this->Polynomials.Degree();
  for (Eigen::MatrixXd* matrix :
    { &this->DiffusionMass, &this->DiffusionMassXY, &this->DiffusionMassYY, &this->ReactionMass,
      &this->AdvectionMassX, &this->AdvectionMassY })
  {
    matrix->setZero(size, size);
  }
  CoefficientBlock values;
  const auto add = [this](Eigen::MatrixXd& matrix, const Weights8& weights)
  {
    matrix.noalias() +=
      this->Work.matrix().transpose().lazyProduct((this->Work.colwise() * weights).matrix());
  };
  this->MeanDiffusion = 0.0;
  ForEachBlock(this->Parts, 2 * degree + ExtraDegree,
    [&](const PointBlock& points, const Weights8& weights)
    {
      this->Problem.EvaluateCoefficients(points, values);
      this->Polynomials.Evaluate(points, degree, this->Work);
      const Weights8 diffusion = Times(weights, values.DiffusionXX);
      add(this->DiffusionMass, diffusion);
      if (this->Problem.HasTensorDiffusion())
      {
        const Weights8 diffusionYY = Times(weights, values.DiffusionYY);
        add(this->DiffusionMassXY, Times(weights, values.DiffusionXY));
        add(this->DiffusionMassYY, diffusionYY);
        this->MeanDiffusion += 0.5 * (diffusion.sum() + diffusionYY.sum()) / this->ElementArea;
      }
      else
      {
        this->MeanDiffusion += diffusion.sum() / this->ElementArea;
      }
      if (this->Problem.HasReaction())
      {
        add(this->ReactionMass, Times(weights, values.Reaction));
      }
      if (this->Problem.HasAdvection())
      {
        add(this->AdvectionMassX, Times(weights, values.AdvectionX));
        add(this->AdvectionMassY, Times(weights, values.AdvectionY));
      }
    });
}

void ElementMatrices::FindNodes()
{
  this->NodeValues.resize(this->BoundaryDofs, this->Polynomials.Size());
  PointBlock points;
  std::array<Index, PointBlockSize> dofs{};
  std::size_t filled = 0;
  const auto flush = [&]
  {
    this->Polynomials.Evaluate(points, this->Polynomials.Degree(), this->Work);
    for (std::size_t i = 0; i < filled; ++i)
    {
      this->NodeValues.row(dofs[i]) = this->Work.row(static_cast<Index>(i)).matrix();
    }
    filled = 0;
  };
  const std::size_t n = this->Vertices.size();
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    const Point2& a = this->Vertices[edge];
    const Point2& b = this->Vertices[(edge + 1) % n];
    for (int node = 0; node < this->Order; ++node)
    {
      const double t = this->EdgeRule.Points[static_cast<std::size_t>(node)];
      points.X[filled] = a.x + t * (b.x - a.x);
      points.Y[filled] = a.y + t * (b.y - a.y);
      dofs[filled++] = this->EdgeDof(static_cast<Index>(edge), node);
      if (filled == PointBlockSize)
      {
        flush();
      }
    }
  }
  flush();
  const Index size = PolynomialCount(this->Order);
  this->D.resize(this->Dofs, size);
  this->D.topRows(this->BoundaryDofs) = this->NodeValues.leftCols(size);
  const Index moments = this->NumberOfMoments();
  this->D.bottomRows(moments) = this->H.topLeftCorner(moments, size) / this->ElementArea;
}

// The boundary's part of the integrals of p_i grad phi_j, for p_i of degree k - 1: Gauss-Lobatto's
// rule is exact, and its points are degrees of freedom.
void ElementMatrices::AddEdgeFluxes()
{
  const Index size = PolynomialCount(this->GradientDegree);
  const Index low = PolynomialCount(this->Order - 1);
  this->FluxX.setZero(size, this->Dofs);
  this->FluxY.setZero(size, this->Dofs);
  const std::size_t n = this->Vertices.size();
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    const Point2& a = this->Vertices[edge];
    const Point2& b = this->Vertices[(edge + 1) % n];
    for (int node = 0; node <= this->Order; ++node)
    {
      const double weight = this->EdgeRule.Weights[static_cast<std::size_t>(node)];
      const Index dof = this->EdgeDof(static_cast<Index>(edge), node);
      const auto values = this->NodeValues.row(dof).head(low).transpose();
      this->FluxX.col(dof).head(low) += weight * (b.y - a.y) * values;
      this->FluxY.col(dof).head(low) += weight * (a.x - b.x) * values;
    }
  }
  const Index moments = this->NumberOfMoments();
  const double area = this->ElementArea;
  this->FluxX.topRightCorner(low, moments) -=
    area * this->Polynomials.DerivativeX().topLeftCorner(low, moments);
  this->FluxY.topRightCorner(low, moments) -=
    area * this->Polynomials.DerivativeY().topLeftCorner(low, moments);
}

// For p_i of higher degree: Gauss' rule, with the basis functions interpolated.
void ElementMatrices::AddHighEdgeFluxes()
{
  const Index low = PolynomialCount(this->Order - 1);
  const Index high = PolynomialCount(this->GradientDegree) - low;
  const GaussRule rule = GaussLegendre((this->GradientDegree + this->Order) / 2 + 1);
  const std::size_t n = this->Vertices.size();
  PointBlock points;
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    const Point2& a = this->Vertices[edge];
    const Point2& b = this->Vertices[(edge + 1) % n];
    for (std::size_t q = 0; q < rule.Points.size(); ++q)
    {
      const double t = rule.Points[q];
      points.X.fill(a.x + t * (b.x - a.x));
      points.Y.fill(a.y + t * (b.y - a.y));
      this->Polynomials.Evaluate(points, this->GradientDegree, this->Work);
      const Eigen::VectorXd values = this->Work.row(0).segment(low, high).matrix().transpose();
      const std::vector<double> shares = LagrangeValues(this->EdgeRule.Points, t);
      for (int node = 0; node <= this->Order; ++node)
      {
        const double weight = rule.Weights[q] * shares[static_cast<std::size_t>(node)];
        const Index dof = this->EdgeDof(static_cast<Index>(edge), node);
        this->FluxX.col(dof).segment(low, high) += weight * (b.y - a.y) * values;
        this->FluxY.col(dof).segment(low, high) += weight * (a.x - b.x) * values;
      }
    }
  }
  const Index known = PolynomialCount(this->GradientDegree - 1);
  this->FluxX.bottomRows(high).noalias() -=
    this->Polynomials.DerivativeX().block(low, 0, high, known) * this->C.topRows(known);
  this->FluxY.bottomRows(high).noalias() -=
    this->Polynomials.DerivativeY().block(low, 0, high, known) * this->C.topRows(known);
}

void ElementMatrices::ProjectGradients()
{
  const Index size = PolynomialCount(this->Order);
  const Index low = PolynomialCount(this->Order - 1);
  const auto dx = this->Polynomials.DerivativeX().topLeftCorner(size, low);
  const auto dy = this->Polynomials.DerivativeY().topLeftCorner(size, low);
  const auto mass = this->H.topLeftCorner(low, low);
  this->GradientProducts.noalias() = dx * mass * dx.transpose();
  this->GradientProducts.noalias() += dy * mass * dy.transpose();
  this->B.noalias() = dx * this->FluxX.topRows(low);
  this->B.noalias() += dy * this->FluxY.topRows(low);
  // The constant.
  this->B.row(0).setZero();
  if (this->Order > 1)
  {
    this->B(0, this->BoundaryDofs) = 1.0;
  }
  else if (this->Options.Constant == ProjectionConstant::VertexMean)
  {
    this->B.row(0).setConstant(1.0 / static_cast<double>(this->Dofs));
  }
  else
  {
    const std::vector<double> weights = BoundaryMeanWeights(this->Vertices);
    this->B.row(0) = Eigen::Map<const Eigen::RowVectorXd>(weights.data(), this->Dofs);
  }
  this->G = this->GradientProducts;
  this->G.row(0).noalias() = this->B.row(0) * this->D;
  this->Gradient = this->G.partialPivLu().solve(this->B);
}

// C, the integrals of p_i phi_j: given up to degree k - 2, then those of the projection.
void ElementMatrices::FindMoments()
{
  const Index size = PolynomialCount(this->Order);
  const Index rows = PolynomialCount(std::max(this->Order, this->GradientDegree - 1));
  const Index moments = this->NumberOfMoments();
  this->C.setZero(rows, this->Dofs);
  this->C.topRightCorner(moments, moments).diagonal().setConstant(this->ElementArea);
  this->C.bottomRows(rows - moments).noalias() =
    this->H.block(moments, 0, rows - moments, size) * this->Gradient;
}

void ElementMatrices::ProjectFluxes()
{
  const Index size = PolynomialCount(this->GradientDegree);
  if (this->GradientDegree > this->Order - 1)
  {
    this->AddHighEdgeFluxes();
  }
  const Eigen::LDLT<Eigen::MatrixXd> mass(this->H.topLeftCorner(size, size));
  this->ProjectedX = mass.solve(this->FluxX);
  this->ProjectedY = mass.solve(this->FluxY);
}

void ElementMatrices::AddDiffusion()
{
  if (this->Problem.IsPoisson())
  {
    this->Stiffness.noalias() = this->FluxX.transpose() * this->ProjectedX;
    this->Stiffness.noalias() += this->FluxY.transpose() * this->ProjectedY;
  }
  else
  {
    const Index size = PolynomialCount(this->GradientDegree);
    const auto mass = this->DiffusionMass.topLeftCorner(size, size);
    this->Stiffness.noalias() = this->ProjectedX.transpose() * mass * this->ProjectedX;
    const bool isTensor = this->Problem.HasTensorDiffusion();
    const auto massYY =
      (isTensor ? this->DiffusionMassYY : this->DiffusionMass).topLeftCorner(size, size);
    this->Stiffness.noalias() += this->ProjectedY.transpose() * massYY * this->ProjectedY;
    if (isTensor) // twice one product of the two, of which the symmetric part is taken below
    {
      this->Stiffness.noalias() += 2.0 * this->ProjectedX.transpose() *
        this->DiffusionMassXY.topLeftCorner(size, size) * this->ProjectedY;
    }
  }
  this->Stiffness = (0.5 * (this->Stiffness + this->Stiffness.transpose())).eval();
}

void ElementMatrices::AddStabilisation()
{
  this->Remainder.setIdentity(this->Dofs, this->Dofs);
  this->Remainder.noalias() -= this->D * this->Gradient;
  StabilisationInput input{};
  input.MeanDiffusion = this->MeanDiffusion;
  input.MeanDiagonal = this->Stiffness.trace() / static_cast<double>(this->Dofs);
  Eigen::VectorXd weights(this->Dofs);
  for (Index i = 0; i < this->Dofs; ++i)
  {
    input.Consistency = this->Stiffness(i, i);
    input.OnBoundary = i < this->BoundaryDofs;
    weights(i) = this->Options.Stabilisation->Weight(input);
  }
  this->Stiffness.noalias() +=
    this->Remainder.transpose() * (weights.asDiagonal() * this->Remainder);
}

void ElementMatrices::AddLowerTerms()
{
  const bool needsValues = this->Problem.HasAdvection() || this->Problem.HasReaction() ||
    this->Options.Load == LoadProjection::SameDegree;
  if (!needsValues)
  {
    return;
  }
  const Index size = PolynomialCount(this->Order);
  this->Values = this->H.topLeftCorner(size, size).ldlt().solve(this->C.topRows(size));
  if (this->Problem.HasReaction())
  {
    this->Stiffness.noalias() +=
      this->Values.transpose() * this->ReactionMass.topLeftCorner(size, size) * this->Values;
  }
  if (this->Problem.HasAdvection())
  {
    const Index low = PolynomialCount(this->GradientDegree);
    this->Stiffness.noalias() += this->Values.transpose() *
      (this->AdvectionMassX.topLeftCorner(size, low) * this->ProjectedX +
        this->AdvectionMassY.topLeftCorner(size, low) * this->ProjectedY);
  }
}

void ElementMatrices::SetLoad()
{
  switch (this->Options.Load)
  {
    case LoadProjection::Gradient:
      this->LoadMatrix = this->Gradient;
      return;
    case LoadProjection::SameDegree:
      this->LoadMatrix = this->Values;
      return;
    case LoadProjection::LowerDegree:
      const Index low = PolynomialCount(this->Order - 1);
      this->LoadMatrix = this->H.topLeftCorner(low, low).ldlt().solve(this->C.topRows(low));
      return;
  }
}

// The integral of the product of two linear functions over a triangle is its area over 12 times
// (the product of the sums of their values at the corners + the sum of the products).
void ElementMatrices::IntegrateLinear()
{
  this->H.setZero(3, 3);
  for (const Triangle2& triangle : this->Parts)
  {
    Eigen::Matrix3d values; // a function a column, a corner a row
    for (Index corner = 0; corner < 3; ++corner)
    {
      const Point2 scaled = this->Lowest.Scaled(triangle[static_cast<std::size_t>(corner)]);
      values.row(corner) << 1.0, scaled.x, scaled.y;
    }
    const Eigen::RowVector3d sums = values.colwise().sum();
    this->H += TriangleArea(triangle) / 12.0 *
      (values.transpose().lazyProduct(values) + sums.transpose().lazyProduct(sums));
  }
}

const Eigen::MatrixXd& ElementMatrices::GetMass()
{
  if (this->ClosedForm)
  {
    this->IntegrateLinear();
  }
  return this->H;
}

const Eigen::MatrixXd& ElementMatrices::GetGradientProducts()
{
  if (this->ClosedForm)
  {
    const double scale = this->ElementArea / (this->ElementDiameter * this->ElementDiameter);
    this->GradientProducts.setZero(3, 3);
    this->GradientProducts(1, 1) = this->GradientProducts(2, 2) = scale;
  }
  return this->GradientProducts;
}

} // namespace pemesh

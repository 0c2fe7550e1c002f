// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// How far the matrices of an element are from the identities that hold in exact arithmetic.
#include "ElementMatrices.h"

namespace pemesh
{

namespace
{

using Eigen::Index;

double RelativeResidual(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

} // namespace

// From the projection as it is used: B is G times it, and C the moments of the projections.
void ElementMatrices::SetMatricesOfClosedForm()
{
  this->IntegrateLinear();
  this->D.resize(this->Dofs, 3);
  for (Index i = 0; i < this->Dofs; ++i)
  {
    const Point2 scaled = this->Lowest.Scaled(this->Vertices[static_cast<std::size_t>(i)]);
    this->D.row(i) << 1.0, scaled.x, scaled.y;
  }
  this->G = this->GetGradientProducts();
  if (this->Options.Constant == ProjectionConstant::VertexMean)
  {
    this->G.row(0) = this->D.colwise().mean();
  }
  else
  {
    const std::vector<double> weights = BoundaryMeanWeights(this->Vertices);
    this->G.row(0).noalias() =
      Eigen::Map<const Eigen::RowVectorXd>(weights.data(), this->Dofs) * this->D;
  }
  this->B.noalias() = this->G * this->Gradient;
  this->C.noalias() = this->H * this->Gradient;
}

ElementChecks ElementMatrices::GetChecks()
{
  if (this->ClosedForm)
  {
    this->SetMatricesOfClosedForm();
  }
  const Index size = PolynomialCount(this->Order);
  ElementChecks checks;
  checks.GradientResidual = RelativeResidual(this->G, this->B * this->D);
  checks.ValueResidual =
    RelativeResidual(this->H.topLeftCorner(size, size), this->C.topRows(size) * this->D);
  checks.StabilisationResidual = RelativeResidual(this->D, this->D * (this->Gradient * this->D));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(this->G);
  checks.Condition = svd.singularValues()(0) / svd.singularValues()(size - 1);
  return checks;
}

} // namespace pemesh

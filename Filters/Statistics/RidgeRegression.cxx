// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RidgeRegression.h"

#include "Correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace pemesh
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index IndexOf(std::size_t i)
{
  return static_cast<Index>(i);
}

/** Less its mean, with variance 1. */
VectorXd Standardised(std::span<const double> sample)
{
  VectorXd values = Eigen::Map<const VectorXd>(sample.data(), IndexOf(sample.size()));
  if (values.size() == 0)
  {
    return values;
  }
  const double largest = values.cwiseAbs().maxCoeff();
  values /= largest > 0.0 ? largest : 1.0;
  values.array() -= values.mean();
  const double norm = values.norm();
  return norm > 0.0 ? VectorXd(values * (std::sqrt(static_cast<double>(sample.size())) / norm))
                    : values;
}

/** Least squares with a penalty, for one penalty after the other. */
class RidgeFits
{
public:
  RidgeFits(const std::vector<std::vector<double>>& predictors, std::span<const double> response,
    const RowFamilies& families)
    : Families(families)
    , Response(Standardised(response))
  {
    MatrixXd design(IndexOf(response.size()), IndexOf(predictors.size()));
    for (std::size_t i = 0; i < predictors.size(); ++i)
    {
      design.col(IndexOf(i)) = Standardised(predictors[i]);
    }
    const Eigen::BDCSVD<MatrixXd> svd(design, Eigen::ComputeThinU | Eigen::ComputeThinV);
    this->Left = svd.matrixU();
    this->Right = svd.matrixV();
    this->Singular = svd.singularValues();
    this->Projected = this->Left.transpose() * this->Response;
  }

  VectorXd Weights(double penalty) const
  {
    const auto d = this->Singular.array();
    return this->Right * (d * this->Projected.array() / (d.square() + penalty)).matrix();
  }

  /** Sum of the squared errors of rows predicted without their family. */
  double LeftOutError(double penalty) const
  {
    const auto squares = this->Singular.array().square();
    const VectorXd shrinkage = squares / (squares + penalty);
    return this->ErrorOf(shrinkage);
  }

  /** The same where the mean of the other families is all that predicts. */
  double ErrorOfMean() const { return this->ErrorOf(VectorXd::Zero(this->Singular.size())); }

private:
  /**
   * The errors e_g of a family that was left out follow from those r_g of the fit to all:
   * (I - H_gg) e_g = r_g with the hat matrix H = 1 1' / n + U diag(shrinkage) U'.
   */
  double ErrorOf(const VectorXd& shrinkage) const
  {
    const VectorXd rest =
      this->Response - this->Left * (shrinkage.array() * this->Projected.array()).matrix();
    const double share = 1.0 / static_cast<double>(this->Response.size());
    double sum = 0.0;
    for (const std::vector<std::size_t>& rows : this->Families)
    {
      const Index count = IndexOf(rows.size());
      MatrixXd left(count, this->Left.cols());
      VectorXd ownRest(count);
      for (Index i = 0; i < count; ++i)
      {
        const Index row = IndexOf(rows[static_cast<std::size_t>(i)]);
        left.row(i) = this->Left.row(row);
        ownRest[i] = rest[row];
      }
      const MatrixXd matrix = MatrixXd::Identity(count, count) -
        MatrixXd::Constant(count, count, share) - left * shrinkage.asDiagonal() * left.transpose();
      sum += matrix.ldlt().solve(ownRest).squaredNorm();
    }
    return sum;
  }

  const RowFamilies& Families;
  VectorXd Response;
  MatrixXd Left;
  MatrixXd Right;
  VectorXd Singular;
  VectorXd Projected;
};

std::string WhyRefused(std::size_t predictors, std::size_t rows, std::size_t families)
{
  if (rows < 2)
  {
    return "Fewer than two rows have all values.";
  }
  if (predictors == 0)
  {
    return "No predictor varies: there is nothing to predict from.";
  }
  if (families < 2)
  {
    return "All rows are of one family: nothing can be predicted without it; pool several studies, "
           "or name the column that tells their families apart.";
  }
  if (rows < RowsPerPredictor * predictors)
  {
    return std::to_string(rows) + " rows are too few for " + std::to_string(predictors) +
      " predictors: three rows a predictor are the least; name fewer predictors.";
  }
  return {};
}

} // namespace

RidgeModel FitRidge(const std::vector<std::vector<double>>& predictors,
  std::span<const double> response, const RowFamilies& families)
{
  RidgeModel model;
  model.Rows = response.size();
  model.Refusal = WhyRefused(predictors.size(), response.size(), families.size());
  if (model.Refusal.empty() && IsConstant(response))
  {
    model.Refusal = "The response has one value only.";
  }
  if (!model.Refusal.empty())
  {
    return model;
  }
  const RidgeFits fits(predictors, response, families);
  const auto rows = static_cast<double>(response.size());
  double least = std::numeric_limits<double>::infinity();
  for (int step = 12; step >= -32; --step) // quarters of a power of ten, the largest first
  {
    const double penalty = std::pow(10.0, step / 4.0);
    const double error = fits.LeftOutError(penalty * rows);
    if (error < least)
    {
      least = error;
      model.Penalty = penalty;
    }
  }
  const VectorXd weights = fits.Weights(model.Penalty * rows);
  model.Weights.assign(weights.data(), weights.data() + weights.size());
  model.PredictedShare = 1.0 - least / fits.ErrorOfMean();
  return model;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PartialCorrelation.h"

#include "Correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/** Less its mean, at length 1; zero where it is constant. */
Eigen::VectorXd Standardised(std::span<const double> sample)
{
  Eigen::VectorXd values =
    Eigen::Map<const Eigen::VectorXd>(sample.data(), static_cast<Eigen::Index>(sample.size()));
  if (values.size() == 0)
  {
    return values; // no row in which both columns are defined
  }
  const double largest = values.cwiseAbs().maxCoeff();
  values /= largest > 0.0 ? largest : 1.0; // squares must not overflow
  values.array() -= values.mean();
  const double norm = values.norm();
  return norm > 1e-14 * std::sqrt(static_cast<double>(sample.size()))
    ? Eigen::VectorXd(values / norm)
    : Eigen::VectorXd::Zero(values.size());
}

bool IsFinite(std::span<const double> sample)
{
  return std::all_of(
    sample.begin(), sample.end(), [](double value) { return std::isfinite(value); });
}

} // namespace

std::vector<double> RegressionResiduals(
  std::span<const double> sample, const std::vector<std::vector<double>>& given)
{
  const auto n = static_cast<Eigen::Index>(sample.size());
  Eigen::VectorXd rest = Standardised(sample);
  Eigen::MatrixXd basis(n, static_cast<Eigen::Index>(given.size()));
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    basis.col(static_cast<Eigen::Index>(i)) = Standardised(given[i]);
  }
  if (!given.empty())
  {
    // The decomposition leaves out columns that others determine.
    rest -= basis * Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(basis).solve(rest);
  }
  if (rest.norm() < 1e-10)
  {
    rest.setZero();
  }
  return { rest.data(), rest.data() + n };
}

double PartialCorrelation(std::span<const double> x, std::span<const double> y,
  const std::vector<std::vector<double>>& given)
{
  const bool finite = IsFinite(x) && IsFinite(y) &&
    std::all_of(given.begin(), given.end(), [](const auto& sample) { return IsFinite(sample); });
  if (!finite || x.size() < given.size() + 3)
  {
    return Undefined;
  }
  return PearsonCorrelation(RegressionResiduals(x, given), RegressionResiduals(y, given));
}

double PartialKendall(std::span<const double> x, std::span<const double> y,
  const std::vector<std::vector<double>>& given)
{
  if (x.size() < given.size() + 3)
  {
    return Undefined;
  }
  std::vector<std::span<const double>> samples{ x, y };
  samples.insert(samples.end(), given.begin(), given.end());
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd tau = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const double value = KendallTauB(CountKendallPairs(
        samples[static_cast<std::size_t>(i)], samples[static_cast<std::size_t>(j)]));
      // A given sample that is constant takes nothing out.
      tau(i, j) = tau(j, i) = std::isnan(value) && i > 1 ? 0.0 : value;
    }
  }
  const Eigen::Index rest = n - 2;
  if (rest == 0)
  {
    return tau(0, 1);
  }
  const Eigen::MatrixXd across = tau.block(2, 0, rest, 2);
  const Eigen::Matrix2d left = tau.topLeftCorner(2, 2) -
    across.transpose() *
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(tau.bottomRightCorner(rest, rest))
        .solve(across);
  constexpr double nothing = 1e-12;
  return left(0, 0) > nothing && left(1, 1) > nothing
    ? std::clamp(left(0, 1) / std::sqrt(left(0, 0) * left(1, 1)), -1.0, 1.0)
    : Undefined;
}

namespace
{

/** Distances of the rows of some columns, centred so that their products have no bias. */
class UnbiasedDistances
{
public:
  explicit UnbiasedDistances(std::vector<Eigen::VectorXd> columns)
    : Columns(std::move(columns))
    , Rows(this->Columns.front().size())
    , Sums(Eigen::VectorXd::Zero(this->Rows))
  {
    for (Eigen::Index i = 0; i < this->Rows; ++i)
    {
      for (Eigen::Index j = 0; j < this->Rows; ++j)
      {
        this->Sums[i] += this->Distance(i, j);
      }
    }
    const auto n = static_cast<double>(this->Rows);
    this->Total = this->Sums.sum() / ((n - 1.0) * (n - 2.0));
    this->Sums /= n - 2.0;
  }

  Eigen::Index Size() const { return this->Rows; }

  /** Of two different rows. */
  double At(Eigen::Index i, Eigen::Index j) const
  {
    return this->Distance(i, j) - this->Sums[i] - this->Sums[j] + this->Total;
  }

private:
  double Distance(Eigen::Index i, Eigen::Index j) const
  {
    if (this->Columns.size() == 1)
    {
      return std::fabs(this->Columns[0][i] - this->Columns[0][j]);
    }
    double squares = 0.0;
    for (const Eigen::VectorXd& column : this->Columns)
    {
      squares += (column[i] - column[j]) * (column[i] - column[j]);
    }
    return std::sqrt(squares);
  }

  std::vector<Eigen::VectorXd> Columns;
  Eigen::Index Rows;
  Eigen::VectorXd Sums;
  double Total = 0.0;
};

} // namespace

double PartialDistanceCorrelation(std::span<const double> x, std::span<const double> y,
  const std::vector<std::vector<double>>& given)
{
  const bool finite = IsFinite(x) && IsFinite(y) &&
    std::all_of(given.begin(), given.end(), [](const auto& sample) { return IsFinite(sample); });
  if (!finite || x.size() < 4 || given.empty())
  {
    return Undefined;
  }
  std::vector<Eigen::VectorXd> fixed;
  std::transform(given.begin(), given.end(), std::back_inserter(fixed),
    [](const std::vector<double>& sample) { return Standardised(sample); });
  const UnbiasedDistances of[3] = { UnbiasedDistances({ Standardised(x) }),
    UnbiasedDistances({ Standardised(y) }), UnbiasedDistances(std::move(fixed)) };
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < of[0].Size(); ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const Eigen::Vector3d each(of[0].At(i, j), of[1].At(i, j), of[2].At(i, j));
      products += each * each.transpose();
    }
  }
  // A column is at length 1, and so are its distances but for a factor: rounding leaves this much.
  constexpr double nothing = 1e-24;
  Eigen::Matrix2d left = products.topLeftCorner<2, 2>();
  if (products(2, 2) > nothing)
  {
    const Eigen::Vector2d along = products.block<2, 1>(0, 2);
    left -= along * along.transpose() / products(2, 2);
  }
  constexpr double determined = 1e-12;
  return left(0, 0) > determined * products(0, 0) && left(1, 1) > determined * products(1, 1)
    ? std::sqrt(std::clamp(left(0, 1) / std::sqrt(left(0, 0) * left(1, 1)), 0.0, 1.0))
    : Undefined;
}

} // namespace pemesh

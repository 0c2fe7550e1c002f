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

/** Less its mean, at length 1; zero where it is constant. */
Eigen::VectorXd Standardised(std::span<const double> sample)
{
  Eigen::VectorXd values =
    Eigen::Map<const Eigen::VectorXd>(sample.data(), static_cast<Eigen::Index>(sample.size()));
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
    return std::numeric_limits<double>::quiet_NaN();
  }
  return PearsonCorrelation(RegressionResiduals(x, given), RegressionResiduals(y, given));
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConditionNumber.h"
#include "SparseCholesky.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>
#include <stdexcept>

namespace
{

using pemesh::SparseCholesky;
using pemesh::SymmetricMatrix;

SymmetricMatrix LowerTriangleOf(const Eigen::MatrixXd& dense)
{
  SymmetricMatrix matrix;
  for (int column = 0; column < dense.cols(); ++column)
  {
    for (int row = column; row < dense.rows(); ++row)
    {
      if (row == column || dense(row, column) != 0.0)
      {
        matrix.Row.push_back(row);
        matrix.Value.push_back(dense(row, column));
      }
    }
    matrix.ColumnStart.push_back(static_cast<int>(matrix.Row.size()));
  }
  return matrix;
}

double OneNorm(const Eigen::MatrixXd& dense)
{
  return dense.cwiseAbs().colwise().sum().maxCoeff();
}

double Uniform(std::mt19937_64& random)
{
  return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
}

// A sparse matrix with entries of both signs and the wanted spread of its diagonal: its inverse,
// unlike that of a discrete Laplacian, has both signs as well.
Eigen::MatrixXd RandomMatrix(int n, double spread, unsigned seed)
{
  std::mt19937_64 random(seed);
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
  {
    factor(i, i) = std::pow(spread, Uniform(random));
    for (int k = 0; k < 3; ++k)
    {
      const int j = static_cast<int>(random() % static_cast<unsigned>(n));
      if (j < i)
      {
        factor(i, j) += 2.0 * Uniform(random);
      }
    }
  }
  return factor * factor.transpose();
}

TEST(SparseCholesky, SolvesLikeADenseSolver)
{
  const Eigen::MatrixXd dense = RandomMatrix(60, 2.0, 3);
  const SymmetricMatrix matrix = LowerTriangleOf(dense);
  const SparseCholesky factor(matrix);
  EXPECT_EQ(factor.Size(), 60);
  Eigen::MatrixXd right = Eigen::MatrixXd::Random(60, 3);
  const auto solution = factor.Solve({ right.data(), 180 }, 3);
  const Eigen::MatrixXd expected = dense.llt().solve(right);
  const Eigen::Map<const Eigen::MatrixXd> found(solution.data(), 60, 3);
  EXPECT_LT((found - expected).norm(), 1.0e-9 * expected.norm());
  const auto product = Multiply(matrix, { right.data(), 60 });
  const Eigen::Map<const Eigen::VectorXd> multiplied(product.data(), 60);
  EXPECT_LT((multiplied - dense * right.col(0)).norm(), 1.0e-12 * dense.norm());
  EXPECT_DOUBLE_EQ(pemesh::OneNorm(matrix), OneNorm(dense));
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefinite)
{
  Eigen::MatrixXd singular(3, 3);
  singular << 1, -1, 0, -1, 2, -1, 0, -1, 1; // the rows add up to nothing
  Eigen::MatrixXd indefinite = Eigen::MatrixXd::Identity(3, 3);
  indefinite(1, 1) = -1;
  Eigen::MatrixXd unconnected = Eigen::MatrixXd::Identity(3, 3);
  unconnected(2, 2) = 0;
  for (const auto& dense : { singular, indefinite, unconnected })
  {
    try
    {
      const SparseCholesky factor(LowerTriangleOf(dense));
      FAIL() << "accepted\n" << dense;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_THAT(error.what(), testing::HasSubstr("singular or indefinite"));
    }
  }
}

TEST(ConditionNumber, IsThatOfTheDenseInverse)
{
  for (const int n : { 1, 2, 7, 63, 64, 65, 200 })
  {
    const Eigen::MatrixXd dense = RandomMatrix(n, 5.0, 10);
    const SymmetricMatrix matrix = LowerTriangleOf(dense);
    const auto [value, exact] = pemesh::ComputeConditionNumber(matrix, SparseCholesky(matrix));
    EXPECT_TRUE(exact);
    EXPECT_NEAR(value / (OneNorm(dense) * OneNorm(dense.inverse())), 1.0, 1.0e-8) << n;
  }
}

// Two hundred matrices with inverses of both signs, the hard case for the estimate.
TEST(ConditionNumber, TheEstimateIsALowerBoundWithinFivePerCent)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    const Eigen::MatrixXd dense = RandomMatrix(60, seed % 2 ? 3.0 : 30.0, seed);
    const SymmetricMatrix matrix = LowerTriangleOf(dense);
    const SparseCholesky factor(matrix);
    const double ratio = pemesh::EstimateInverseNorm(factor) / pemesh::ExactInverseNorm(factor);
    EXPECT_LE(ratio, 1.0 + 1.0e-12) << seed;
    EXPECT_GE(ratio, 0.95) << seed;
  }
}

TEST(ConditionNumber, IsEstimatedFromFiveHundredUnknownsOn)
{
  for (const int n : { 499, 500 })
  {
    Eigen::MatrixXd dense = 2.0 * Eigen::MatrixXd::Identity(n, n);
    dense.diagonal(1).setConstant(-1.0);
    dense.diagonal(-1).setConstant(-1.0);
    const SymmetricMatrix matrix = LowerTriangleOf(dense);
    const auto [value, exact] = pemesh::ComputeConditionNumber(matrix, SparseCholesky(matrix));
    EXPECT_EQ(exact, n < 500);
    // Row i of the inverse of this matrix adds up to i (n + 1 - i) / 2.
    const double middle = (n + 1) / 2;
    EXPECT_NEAR(value, 4.0 * middle * (n + 1 - middle) / 2.0, 1.0e-6 * value);
  }
}

TEST(ConditionNumber, TheEstimateIsTheSameEveryTime)
{
  const SymmetricMatrix matrix = LowerTriangleOf(RandomMatrix(80, 30.0, 5));
  EXPECT_EQ(pemesh::EstimateInverseNorm(SparseCholesky(matrix)),
    pemesh::EstimateInverseNorm(SparseCholesky(matrix)));
}

} // namespace

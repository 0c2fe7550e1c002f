// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConditionNumber.h"
#include "ConjugateGradients.h"
#include "SparseCholesky.h"
#include "SparseLU.h"
#include "SpectralCondition.h"
#include "VirtualElementMethod.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <new>
#include <random>
#include <stdexcept>

namespace
{

using pemesh::SparseCholesky;
using pemesh::SparseMatrix;

SparseMatrix LowerTriangleOf(const Eigen::MatrixXd& dense)
{
  SparseMatrix matrix;
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
  const SparseMatrix matrix = LowerTriangleOf(dense);
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
    const SparseMatrix matrix = LowerTriangleOf(dense);
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
    const SparseMatrix matrix = LowerTriangleOf(dense);
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
    const SparseMatrix matrix = LowerTriangleOf(dense);
    const auto [value, exact] = pemesh::ComputeConditionNumber(matrix, SparseCholesky(matrix));
    EXPECT_EQ(exact, n < 500);
    // Row i of the inverse of this matrix adds up to i (n + 1 - i) / 2.
    const double middle = (n + 1) / 2;
    EXPECT_NEAR(value, 4.0 * middle * (n + 1 - middle) / 2.0, 1.0e-6 * value);
  }
}

TEST(ConditionNumber, TheEstimateIsTheSameEveryTime)
{
  const SparseMatrix matrix = LowerTriangleOf(RandomMatrix(80, 30.0, 5));
  EXPECT_EQ(pemesh::EstimateInverseNorm(SparseCholesky(matrix)),
    pemesh::EstimateInverseNorm(SparseCholesky(matrix)));
}

TEST(SpectralCondition, IsThatOfTheDenseMatrix)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const Eigen::MatrixXd dense = RandomMatrix(250, 100.0, seed);
    const SparseMatrix matrix = LowerTriangleOf(dense);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(dense);
    const double expected = solver.eigenvalues()(249) / solver.eigenvalues()(0);
    EXPECT_NEAR(
      pemesh::ComputeSpectralConditionNumber(matrix, SparseCholesky(matrix)) / expected, 1.0, 1e-6);
  }
}

SparseMatrix WholeMatrixOf(const Eigen::MatrixXd& dense)
{
  SparseMatrix matrix;
  matrix.Symmetric = false;
  for (int column = 0; column < dense.cols(); ++column)
  {
    for (int row = 0; row < dense.rows(); ++row)
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

// A lower triangular factor of another matrix makes it lopsided.
TEST(SparseLU, SolvesAndMeasuresLikeADenseSolver)
{
  const int n = 150;
  const Eigen::MatrixXd dense = RandomMatrix(n, 10.0, 4) +
    Eigen::MatrixXd(RandomMatrix(n, 10.0, 5).triangularView<Eigen::Lower>());
  const SparseMatrix matrix = WholeMatrixOf(dense);
  const pemesh::SparseLU factor(matrix, 1.0e12);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
  const std::span<const double> view(right.data(), static_cast<std::size_t>(n));
  const auto compare = [n](const std::vector<double>& found, const Eigen::VectorXd& expected)
  {
    const Eigen::Map<const Eigen::VectorXd> values(found.data(), n);
    EXPECT_LT((values - expected).norm(), 1.0e-9 * expected.norm());
  };
  compare(factor.Solve(view), dense.partialPivLu().solve(right));
  compare(factor.SolveTransposed(view), dense.transpose().partialPivLu().solve(right));
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(dense);
  EXPECT_NEAR(pemesh::ComputeSpectralConditionNumber(matrix, factor) * svd.singularValues()(n - 1) /
      svd.singularValues()(0),
    1.0, 1.0e-6);
  const auto [condition, exact] = pemesh::ComputeConditionNumber(matrix, factor);
  EXPECT_TRUE(exact);
  EXPECT_NEAR(condition / (OneNorm(dense) * OneNorm(dense.inverse())), 1.0, 1.0e-8);
  EXPECT_THROW(pemesh::SparseLU(matrix, 100.0), std::bad_alloc);
}

TEST(ConjugateGradients, SolveWithEveryPreconditioner)
{
  const Eigen::MatrixXd dense = RandomMatrix(120, 30.0, 6);
  const SparseMatrix matrix = LowerTriangleOf(dense);
  const std::vector<double> ones(120, 1.0);
  const Eigen::VectorXd expected = dense.llt().solve(Eigen::VectorXd::Ones(120));
  int plain = 0;
  for (const auto kind : { pemesh::CgPreconditioner::None, pemesh::CgPreconditioner::Jacobi,
         pemesh::CgPreconditioner::IncompleteCholesky })
  {
    const auto run = pemesh::RunConjugateGradients(matrix, ones, kind, 1.0e-12, 5000);
    EXPECT_TRUE(run.Converged);
    const Eigen::Map<const Eigen::VectorXd> found(run.Solution.data(), 120);
    EXPECT_LT((found - expected).norm(), 1.0e-6 * expected.norm());
    plain = kind == pemesh::CgPreconditioner::None ? run.Iterations : plain;
    if (kind == pemesh::CgPreconditioner::None)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(dense);
      const double kappa = spectrum.eigenvalues()(119) / spectrum.eigenvalues()(0);
      EXPECT_NEAR(pemesh::LanczosConditionNumber(run) / kappa, 1.0, 1.0e-6);
    }
    EXPECT_LE(run.Iterations, plain);
  }
  int calls = 0;
  const auto check = [&calls]
  {
    if (++calls == 5)
    {
      throw pemesh::SolveAborted();
    }
  };
  EXPECT_THROW(
    pemesh::RunConjugateGradients(matrix, ones, pemesh::CgPreconditioner::None, 1e-12, 5000, check),
    pemesh::SolveAborted);
  calls = 0;
  EXPECT_THROW(pemesh::ComputeSpectralConditionNumber(matrix, SparseCholesky(matrix), check),
    pemesh::SolveAborted);
  EXPECT_FALSE(pemesh::RunConjugateGradients(matrix, ones, pemesh::CgPreconditioner::None, 1e-12, 3)
                 .Converged);
}

} // namespace

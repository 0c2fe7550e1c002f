// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SparseMatrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pemesh
{

namespace
{

// Each entry, with its mirror image where the matrix is symmetric: action(row, column, value).
template <typename Action>
void ForEachEntry(const SparseMatrix& matrix, const Action& action)
{
  for (int column = 0; column < matrix.Size(); ++column)
  {
    for (int k = matrix.ColumnStart[column]; k < matrix.ColumnStart[column + 1]; ++k)
    {
      action(matrix.Row[k], column, matrix.Value[k]);
      if (matrix.Symmetric && matrix.Row[k] != column)
      {
        action(column, matrix.Row[k], matrix.Value[k]);
      }
    }
  }
}

} // namespace

double OneNorm(const SparseMatrix& matrix)
{
  std::vector<double> sums(matrix.Size(), 0.0);
  ForEachEntry(matrix, [&sums](int, int column, double value) { sums[column] += std::abs(value); });
  return sums.empty() ? 0.0 : *std::max_element(sums.begin(), sums.end());
}

double CountNonzeros(const SparseMatrix& matrix)
{
  const double stored = static_cast<double>(matrix.Row.size());
  return matrix.Symmetric ? 2.0 * stored - matrix.Size() : stored;
}

void Multiply(const SparseMatrix& matrix, std::span<const double> x, std::span<double> result)
{
  std::fill(result.begin(), result.end(), 0.0);
  ForEachEntry(
    matrix, [&](int row, int column, double value) { result[row] += value * x[column]; });
}

void MultiplyTransposed(
  const SparseMatrix& matrix, std::span<const double> x, std::span<double> result)
{
  std::fill(result.begin(), result.end(), 0.0);
  ForEachEntry(
    matrix, [&](int row, int column, double value) { result[column] += value * x[row]; });
}

std::vector<double> Multiply(const SparseMatrix& matrix, std::span<const double> x)
{
  std::vector<double> result(matrix.Size());
  Multiply(matrix, x, result);
  return result;
}

SparseMatrix WithBothTriangles(const SparseMatrix& matrix)
{
  SparseMatrix full;
  full.Symmetric = full.Definite = false;
  full.ColumnStart.assign(matrix.ColumnStart.size(), 0);
  ForEachEntry(matrix, [&full](int, int column, double) { ++full.ColumnStart[column + 1]; });
  std::partial_sum(full.ColumnStart.begin(), full.ColumnStart.end(), full.ColumnStart.begin());
  full.Row.resize(full.ColumnStart.back());
  full.Value.resize(full.ColumnStart.back());
  std::vector<int> next(full.ColumnStart.begin(), full.ColumnStart.end() - 1);
  // Column by column of the lower triangle the rows of each column come in ascending order.
  ForEachEntry(matrix,
    [&](int row, int column, double value)
    {
      full.Row[next[column]] = row;
      full.Value[next[column]++] = value;
    });
  return full;
}

Factorization::~Factorization() = default;

} // namespace pemesh

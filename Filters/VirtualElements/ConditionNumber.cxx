// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConditionNumber.h"

#include "SparseMatrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace pemesh
{

namespace
{

// More columns find larger sums, which costs next to nothing where the matrix is small.
constexpr std::size_t ManyRows = 20000;
constexpr std::size_t BlockColumnsOfFewRows = 8;
constexpr std::size_t BlockColumnsOfManyRows = 2;
constexpr int BlockSteps = 5;
constexpr int SolveColumns = 64; // right-hand sides at a time for the exact norm

void Ask(const std::function<void()>& check)
{
  if (check)
  {
    check();
  }
}

double ColumnSum(const std::vector<double>& block, std::size_t rows, std::size_t column)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < rows; ++i)
  {
    sum += std::abs(block[column * rows + i]);
  }
  return sum;
}

// A block of a few columns of signs, and what the method asks about it.
class SignBlock
{
public:
  SignBlock(std::size_t rows, std::size_t columns)
    : Rows(rows)
    , Columns(columns)
    , Values(rows * columns, 1.0)
  {
  }

  const std::vector<double>& GetValues() const { return this->Values; }

  void SetSigns(const std::vector<double>& block)
  {
    std::transform(block.begin(), block.end(), this->Values.begin(),
      [](double value) { return value < 0.0 ? -1.0 : 1.0; });
  }

  void RandomizeColumn(std::size_t column, std::mt19937_64& random)
  {
    for (std::size_t i = 0; i < this->Rows; ++i)
    {
      this->Values[column * this->Rows + i] = (random() >> 63) != 0 ? 1.0 : -1.0;
    }
  }

  bool IsParallel(std::size_t column, const SignBlock& other, std::size_t otherColumn) const
  {
    const double* a = this->Values.data() + column * this->Rows;
    const double* b = other.Values.data() + otherColumn * this->Rows;
    const double sign = a[0] * b[0];
    return std::equal(a, a + this->Rows, b, [sign](double x, double y) { return x == sign * y; });
  }

  bool IsParallelToAny(std::size_t column, const SignBlock& other, std::size_t columns) const
  {
    for (std::size_t other_ = 0; other_ < columns; ++other_)
    {
      if (this->IsParallel(column, other, other_))
      {
        return true;
      }
    }
    return false;
  }

  bool AllParallelTo(const SignBlock& other) const
  {
    for (std::size_t column = 0; column < this->Columns; ++column)
    {
      if (!this->IsParallelToAny(column, other, this->Columns))
      {
        return false;
      }
    }
    return true;
  }

  // Replaces columns that tell nothing new. A few tries only: tiny blocks have few sign vectors.
  void MakeColumnsDiffer(const SignBlock& previous, bool fromPrevious, std::mt19937_64& random)
  {
    for (std::size_t column = 0; column < this->Columns; ++column)
    {
      for (int attempt = 0; attempt < 10 &&
           (this->IsParallelToAny(column, *this, column) ||
             (fromPrevious && this->IsParallelToAny(column, previous, this->Columns)));
           ++attempt)
      {
        this->RandomizeColumn(column, random);
      }
    }
  }

private:
  std::size_t Rows;
  std::size_t Columns;
  std::vector<double> Values;
};

// The rows in descending order of their largest absolute value; ties in ascending order.
std::vector<std::size_t> RankRows(const std::vector<double>& block, std::size_t rows,
  std::size_t columns, std::vector<double>& height)
{
  height.assign(rows, 0.0);
  for (std::size_t column = 0; column < columns; ++column)
  {
    for (std::size_t i = 0; i < rows; ++i)
    {
      height[i] = std::max(height[i], std::abs(block[column * rows + i]));
    }
  }
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  // Enough of the order for the columns wanted even if all rows tried before come first.
  const std::size_t wanted = std::min(rows, columns * (BlockSteps + 2));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(wanted), order.end(),
    [&height](std::size_t a, std::size_t b)
    { return height[a] != height[b] ? height[a] > height[b] : a < b; });
  order.resize(wanted);
  return order;
}

// The first rows of the order that were not tried before, which from now on they were; none if
// there are fewer than `wanted`.
std::vector<std::size_t> TakeUntried(
  const std::vector<std::size_t>& order, std::size_t wanted, std::vector<char>& tried)
{
  std::vector<std::size_t> rows;
  for (const std::size_t row : order)
  {
    if (rows.size() < wanted && !tried[row])
    {
      rows.push_back(row);
      tried[row] = 1;
    }
  }
  return rows.size() == wanted ? rows : std::vector<std::size_t>{};
}

// Row is the unit vector that gave the norm, or the number of rows if another vector did.
struct Estimate
{
  double Norm = 0.0;
  std::size_t Row = 0;
};

// True if a column of the image has a larger sum; `units` are the unit vectors that gave it.
bool Improve(Estimate& estimate, const std::vector<double>& image, std::size_t rows,
  std::size_t columns, const std::vector<std::size_t>& units)
{
  bool better = false;
  for (std::size_t column = 0; column < columns; ++column)
  {
    const double sum = ColumnSum(image, rows, column);
    if (sum > estimate.Norm)
    {
      estimate = { sum, units.empty() ? rows : units[column] };
      better = true;
    }
  }
  return better;
}

} // namespace

double ExactInverseNorm(const Factorization& factor, const std::function<void()>& check)
{
  const std::size_t rows = static_cast<std::size_t>(factor.Size());
  double norm = 0.0;
  for (std::size_t first = 0; first < rows; first += SolveColumns)
  {
    Ask(check);
    const std::size_t columns = std::min<std::size_t>(SolveColumns, rows - first);
    std::vector<double> block(rows * columns, 0.0);
    for (std::size_t column = 0; column < columns; ++column)
    {
      block[column * rows + first + column] = 1.0;
    }
    block = factor.Solve(block, static_cast<int>(columns));
    for (std::size_t column = 0; column < columns; ++column)
    {
      norm = std::max(norm, ColumnSum(block, rows, column));
    }
  }
  return norm;
}

double EstimateInverseNorm(const Factorization& factor, const std::function<void()>& check)
{
  const std::size_t rows = static_cast<std::size_t>(factor.Size());
  const std::size_t columns =
    std::min(rows, rows < ManyRows ? BlockColumnsOfFewRows : BlockColumnsOfManyRows);
  std::mt19937_64 random(20000101u);
  SignBlock signs(rows, columns);
  for (std::size_t column = 1; column < columns; ++column)
  {
    signs.RandomizeColumn(column, random);
  }
  std::vector<double> start = signs.GetValues();
  for (double& value : start)
  {
    value /= static_cast<double>(rows);
  }

  Estimate estimate{ 0.0, rows };
  std::vector<std::size_t> units; // the unit vectors of the present step
  std::vector<char> tried(rows, 0);
  std::vector<double> height;
  for (int step = 0; step <= BlockSteps; ++step)
  {
    Ask(check);
    const std::vector<double> image = factor.Solve(start, static_cast<int>(columns));
    if (!Improve(estimate, image, rows, columns, units) || step == BlockSteps)
    {
      break;
    }
    const SignBlock previous = signs;
    signs.SetSigns(image);
    if (step > 0 && signs.AllParallelTo(previous))
    {
      break;
    }
    // The start has told nothing of its signs yet, least of all that all of them should be one.
    signs.MakeColumnsDiffer(previous, step > 0, random);
    Ask(check);
    const std::vector<double> dual =
      factor.SolveTransposed(signs.GetValues(), static_cast<int>(columns));
    const std::vector<std::size_t> order = RankRows(dual, rows, columns, height);
    if (estimate.Row < rows && height[order.front()] == height[estimate.Row])
    {
      break;
    }
    units = TakeUntried(order, columns, tried);
    if (units.empty())
    {
      break;
    }
    std::fill(start.begin(), start.end(), 0.0);
    for (std::size_t column = 0; column < columns; ++column)
    {
      start[column * rows + units[column]] = 1.0;
    }
  }
  return estimate.Norm;
}

ConditionNumber ComputeConditionNumber(
  const SparseMatrix& matrix, const Factorization& factor, const std::function<void()>& check)
{
  const bool exact = factor.Size() < ExactConditionNumberLimit;
  const double inverse =
    exact ? ExactInverseNorm(factor, check) : EstimateInverseNorm(factor, check);
  return { OneNorm(matrix) * inverse, exact };
}

} // namespace pemesh

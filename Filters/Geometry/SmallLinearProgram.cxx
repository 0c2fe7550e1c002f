// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallLinearProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

std::array<std::ptrdiff_t, 3> SmallLinearProgram::GetActiveBounds() const
{
  std::array<std::ptrdiff_t, 3> bounds{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    bounds[k] =
      static_cast<std::ptrdiff_t>(this->Last.Rows[k]) - static_cast<std::ptrdiff_t>(this->Sides);
  }
  return bounds;
}

/**
 * The lowest bound at the origin, and the two sides, or else bounds, that meet where it is highest:
 * the multipliers of this basis are not negative, whatever the other rows.
 */
bool SmallLinearProgram::StartBasis(Basis& basis) const
{
  const std::size_t around = this->Sides > 0 ? this->Sides : this->Size;
  std::size_t lowest = this->Sides;
  for (std::size_t i = this->Sides + 1; i < this->Size; ++i)
  {
    lowest = this->GetRow(i).C < this->GetRow(lowest).C ? i : lowest;
  }
  const Row low = this->GetRow(lowest);
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < around; ++i)
  {
    const std::size_t j = i + 1 == around ? 0 : i + 1;
    const Row a = this->GetRow(i);
    const Row b = this->GetRow(j);
    const double inside = std::min(a.Y * low.X - a.X * low.Y, low.Y * b.X - low.X * b.Y);
    // Of parallels to the lowest, those that meet in a corner.
    const double score = inside + 1e-10 * (a.X * b.Y - a.Y * b.X);
    if (score > best)
    {
      best = score;
      basis.Rows = { i, j, lowest };
    }
  }
  return this->Factorize(basis);
}

/** Whether the last solution is one of these rows, too, with multipliers that are not negative. */
bool SmallLinearProgram::IsLastBasisFeasible()
{
  Basis& basis = this->Last;
  return this->HasBasis && *std::max_element(basis.Rows.begin(), basis.Rows.end()) < this->Size &&
    this->Factorize(basis) &&
    *std::min_element(basis.Multipliers.begin(), basis.Multipliers.end()) >= 0.0;
}

/** Inverts the three rows by cross products; false if they are dependent. */
bool SmallLinearProgram::Factorize(Basis& basis) const
{
  const Row a = this->GetRow(basis.Rows[0]);
  const Row b = this->GetRow(basis.Rows[1]);
  const Row c = this->GetRow(basis.Rows[2]);
  const std::array<double, 3> bc = { b.Y * c.R - b.R * c.Y, b.R * c.X - b.X * c.R,
    b.X * c.Y - b.Y * c.X };
  const std::array<double, 3> ca = { c.Y * a.R - c.R * a.Y, c.R * a.X - c.X * a.R,
    c.X * a.Y - c.Y * a.X };
  const std::array<double, 3> ab = { a.Y * b.R - a.R * b.Y, a.R * b.X - a.X * b.R,
    a.X * b.Y - a.Y * b.X };
  const double determinant = a.X * bc[0] + a.Y * bc[1] + a.R * bc[2];
  if (!(std::abs(determinant) > 1e-300))
  {
    return false;
  }
  constexpr double WellConditioned = 1e-4; // of rows of length one
  basis.IsWellConditioned = std::abs(determinant) > WellConditioned;
  const double scale = 1.0 / determinant;
  for (std::size_t i = 0; i < 3; ++i)
  {
    basis.Inverse[i] = { bc[i] * scale, ca[i] * scale, ab[i] * scale };
  }
  basis.Multipliers = basis.Inverse[2];
  return true;
}

/** Where the three planes of the basis meet. */
SmallLinearProgram::Solution SmallLinearProgram::Meet(const Basis& basis) const
{
  const std::array<Row, 3> rows = { this->GetRow(basis.Rows[0]), this->GetRow(basis.Rows[1]),
    this->GetRow(basis.Rows[2]) };
  std::array<double, 3> residual = { rows[0].C, rows[1].C, rows[2].C };
  std::array<double, 3> place{};
  // Among almost parallel planes the inverse has lost digits, which refinement brings back.
  const int rounds = basis.IsWellConditioned ? 1 : 3;
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::array<double, 3>& inverse = basis.Inverse[i];
      place[i] += inverse[0] * residual[0] + inverse[1] * residual[1] + inverse[2] * residual[2];
    }
    for (std::size_t i = 0; i < 3 && round + 1 < rounds; ++i)
    {
      const Row& row = rows[i];
      residual[i] = row.C - (row.X * place[0] + row.Y * place[1] + row.R * place[2]);
    }
  }
  return { { place[0], place[1] }, place[2], false };
}

double SmallLinearProgram::HeightAt(const Point2& position) const
{
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t i = this->Sides; i < this->Size; ++i)
  {
    const Row row = this->GetRow(i);
    height = std::min(height, row.C - (row.X * position.x + row.Y * position.y));
  }
  return height;
}

std::size_t SmallLinearProgram::MostViolated(const Solution& solution, double tolerance) const
{
  const double x = solution.Position.x;
  const double y = solution.Position.y;
  const double r = solution.Height;
  // The worst row of each place in its group, without branches: which it is cannot be foreseen.
  std::array<double, GroupSize> worst;
  std::array<double, GroupSize> where{};
  worst.fill(tolerance);
  double number = 0.0;
  const std::size_t groups = (this->Size + GroupSize - 1) / GroupSize;
  for (std::size_t g = 0; g < groups; ++g)
  {
    const Group& group = this->Groups[g];
    for (std::size_t k = 0; k < GroupSize; ++k)
    {
      const double violation = group.X[k] * x + group.Y[k] * y + group.R[k] * r - group.C[k];
      where[k] = violation > worst[k] ? number : where[k];
      worst[k] = violation > worst[k] ? violation : worst[k];
    }
    number += 1.0;
  }
  const auto largest =
    static_cast<std::size_t>(std::max_element(worst.begin(), worst.end()) - worst.begin());
  return worst[largest] > tolerance ? GroupSize * static_cast<std::size_t>(where[largest]) + largest
                                    : this->Size;
}

/** Brings a row into the basis; the ratio test keeps the multipliers from going negative. */
bool SmallLinearProgram::Exchange(Basis& basis, std::size_t entering) const
{
  const Row row = this->GetRow(entering);
  double least = std::numeric_limits<double>::infinity();
  double pivot = 0.0;
  std::size_t leaving = 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double weight =
      row.X * basis.Inverse[0][k] + row.Y * basis.Inverse[1][k] + row.R * basis.Inverse[2][k];
    if (weight > 1e-14)
    {
      const double ratio = std::max(0.0, basis.Multipliers[k]) / weight;
      if (ratio < least || (ratio == least && weight > pivot))
      {
        least = ratio;
        pivot = weight;
        leaving = k;
      }
    }
  }
  if (leaving == 3)
  {
    return false;
  }
  basis.Rows[leaving] = entering;
  return this->Factorize(basis);
}

SmallLinearProgram::Solution SmallLinearProgram::Solve(double tolerance, double enough)
{
  Solution solution;
  solution.Height = std::numeric_limits<double>::infinity();
  if ((this->Sides == 0 ? this->Size < 3 : this->Sides < 3 || this->Size <= this->Sides) ||
    (!this->IsLastBasisFeasible() && !this->StartBasis(this->Last)))
  {
    this->HasBasis = false;
    return solution;
  }
  Basis& basis = this->Last;
  this->HasBasis = true;
  // Degenerate steps could cycle in theory; the cap turns that into an upper bound.
  const std::size_t steps = 30 + this->Size;
  for (std::size_t step = 0; step < steps; ++step)
  {
    solution = this->Meet(basis);
    const std::size_t entering = this->MostViolated(solution, tolerance);
    if (entering == this->Size)
    {
      solution.Optimal = true;
      break;
    }
    if (solution.Height <= enough || !this->Exchange(basis, entering))
    {
      break;
    }
  }
  return solution;
}

} // namespace pemesh

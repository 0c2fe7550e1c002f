// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallLinearProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

void SmallLinearProgram::Clear()
{
  this->Groups.clear();
  this->Size = 0;
  this->Sides = 0;
}

void SmallLinearProgram::AddRow(const Row& row)
{
  const std::size_t k = this->Size % GroupSize;
  if (k == 0)
  {
    this->Groups.emplace_back();
    this->Groups.back().C.fill(std::numeric_limits<double>::infinity());
  }
  Group& group = this->Groups.back();
  group.X[k] = row.X;
  group.Y[k] = row.Y;
  group.R[k] = row.R;
  group.C[k] = row.C;
  ++this->Size;
}

void SmallLinearProgram::AddSide(const Point2& outwardNormal, double offset)
{
  this->AddRow({ outwardNormal.x, outwardNormal.y, 0.0, offset });
  ++this->Sides;
}

void SmallLinearProgram::AddBound(double height, const Point2& slope)
{
  this->AddRow({ -slope.x, -slope.y, 1.0, height });
}

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
 * The lowest bound at the origin, and the two sides that meet where it is highest: the multipliers
 * of this basis are not negative, whatever the other rows.
 */
bool SmallLinearProgram::StartBasis(Basis& basis) const
{
  std::size_t lowest = this->Sides;
  for (std::size_t i = this->Sides + 1; i < this->Size; ++i)
  {
    lowest = this->GetRow(i).C < this->GetRow(lowest).C ? i : lowest;
  }
  const Row low = this->GetRow(lowest);
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Sides; ++i)
  {
    const std::size_t j = i + 1 == this->Sides ? 0 : i + 1;
    const Row a = this->GetRow(i);
    const Row b = this->GetRow(j);
    const double inside = std::min(a.Y * low.X - a.X * low.Y, low.Y * b.X - low.X * b.Y);
    if (inside > best)
    {
      best = inside;
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
  const double scale = 1.0 / determinant;
  for (std::size_t i = 0; i < 3; ++i)
  {
    basis.Inverse[i] = { bc[i] * scale, ca[i] * scale, ab[i] * scale };
  }
  basis.Multipliers = basis.Inverse[2];
  return true;
}

std::size_t SmallLinearProgram::MostViolated(
  const Basis& basis, Solution& solution, double tolerance) const
{
  const std::array<double, 3> c = { this->GetRow(basis.Rows[0]).C, this->GetRow(basis.Rows[1]).C,
    this->GetRow(basis.Rows[2]).C };
  const auto Product = [&](std::size_t i)
  { return basis.Inverse[i][0] * c[0] + basis.Inverse[i][1] * c[1] + basis.Inverse[i][2] * c[2]; };
  const double x = Product(0);
  const double y = Product(1);
  const double r = Product(2);
  solution.Position = { x, y };
  solution.Height = r;
  // The worst row of each place in its group, without branches: which it is cannot be foreseen.
  std::array<double, GroupSize> worst;
  std::array<double, GroupSize> where{};
  worst.fill(tolerance);
  double number = 0.0;
  for (const Group& group : this->Groups)
  {
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
  if (this->Sides < 3 || this->Size <= this->Sides ||
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
    const std::size_t entering = this->MostViolated(basis, solution, tolerance);
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

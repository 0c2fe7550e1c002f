// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The highest point below some planes, above a convex region of the plane: the largest r with
 * r <= Height_i + Slope_i . p for all bounds i, p in the region.
 *
 * This is the linear program behind the largest circle inside half planes, and behind upper
 * bounds on a piece of a polygon. Solved by the dual simplex method with a basis of three rows
 * (see e.g. V. Chvatal, Linear Programming, 1983, chapter 10): every step keeps a proven upper
 * bound, so stopping early is safe.
 */
#ifndef pemesh_SmallLinearProgram_h
#define pemesh_SmallLinearProgram_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace pemesh
{

class PEMESHFILTERSGEOMETRY_EXPORT SmallLinearProgram
{
public:
  struct Solution
  {
    Point2 Position;
    double Height = 0.0;  // at most the true optimum plus rounding only if Optimal
    bool Optimal = false; // else Height is an upper bound of the optimum
  };

  /** Lets the next Solve begin anew, not at the solution of the last one. */
  void ForgetBasis() { this->HasBasis = false; }

  /** Forgets region and bounds, for similar ones in the same order unless ForgetBasis is called. */
  void Clear()
  {
    this->Size = 0;
    this->Sides = 0;
  }

  /** The sides of the region, counter-clockwise: normal . p <= offset, normal of length one. */
  void AddSide(const Point2& outwardNormal, double offset)
  {
    this->AddRow({ outwardNormal.x, outwardNormal.y, 0.0, offset });
    ++this->Sides;
  }

  /** r <= height + slope . p. Add all sides first. */
  void AddBound(double height, const Point2& slope)
  {
    this->AddRow({ -slope.x, -slope.y, 1.0, height });
  }

  /**
   * Solves to within `tolerance` (absolute, in r). Stops, not optimal, as soon as the optimum is
   * known to be at most `enough`. Needs three sides and one bound; or no side and three bounds,
   * the slopes in counter-clockwise order and not all in one half plane.
   */
  Solution Solve(double tolerance, double enough);

  /** The lowest bound at a place. */
  double HeightAt(const Point2& position) const;

  /** The bounds that meet in the last optimum, in the order added; negative for sides. */
  std::array<std::ptrdiff_t, 3> GetActiveBounds() const;

private:
  struct Row // X x + Y y + R r <= C, where R is 0 for a side and 1 for a bound
  {
    double X;
    double Y;
    double R;
    double C;
  };
  struct Basis
  {
    std::array<std::size_t, 3> Rows;
    std::array<double, 3> Multipliers;
    std::array<std::array<double, 3>, 3> Inverse;
    bool IsWellConditioned;
  };

  static constexpr std::size_t GroupSize = 4;
  struct Group // rows side by side, which the processor takes two or four at a time
  {
    std::array<double, GroupSize> X;
    std::array<double, GroupSize> Y;
    std::array<double, GroupSize> R;
    std::array<double, GroupSize> C;
  };

  Row GetRow(std::size_t i) const
  {
    const Group& group = this->Groups[i / GroupSize];
    const std::size_t k = i % GroupSize;
    return { group.X[k], group.Y[k], group.R[k], group.C[k] };
  }
  void AddRow(const Row& row)
  {
    const std::size_t group = this->Size / GroupSize;
    const std::size_t k = this->Size % GroupSize;
    if (group == this->Groups.size())
    {
      this->Groups.emplace_back();
    }
    Group& rows = this->Groups[group];
    if (k == 0)
    {
      rows = {};
      rows.C.fill(std::numeric_limits<double>::infinity());
    }
    rows.X[k] = row.X;
    rows.Y[k] = row.Y;
    rows.R[k] = row.R;
    rows.C[k] = row.C;
    ++this->Size;
  }
  bool StartBasis(Basis& basis) const;
  bool IsLastBasisFeasible();
  bool Factorize(Basis& basis) const;
  Solution Meet(const Basis& basis) const;
  std::size_t MostViolated(const Solution& solution, double tolerance) const;
  bool Exchange(Basis& basis, std::size_t entering) const;

  std::vector<Group> Groups; // the last one in use is filled up with rows that hold everywhere
  std::size_t Size = 0;
  std::size_t Sides = 0;
  Basis Last;
  bool HasBasis = false;
};

} // namespace pemesh

#endif

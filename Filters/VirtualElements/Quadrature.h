// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Integrals over triangles to a wanted accuracy.
 *
 * Three symmetric rules of degree 5, 8 and 12 (7, 16 and 33 points, all inside, all weights
 * positive; D. A. Dunavant, Int. J. Numer. Methods Eng. 21 (1985) 1129-1148) are tried in turn
 * until two agree; where the last two do not, the triangle is cut into four. Small elements
 * thus cost 23 evaluations, and the accepted value is far better than the difference that was
 * asked for, because the better of the two rules is the one that is returned.
 */
#ifndef pemesh_Quadrature_h
#define pemesh_Quadrature_h

#include "Point2.h"
#include "PointBlock.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace pemesh
{

using Triangle2 = std::array<Point2, 3>;

/** Points in barycentric coordinates; the weights of a rule sum to one. */
struct QuadratureBlock
{
  BlockOfNumbers First;
  BlockOfNumbers Second;
  BlockOfNumbers Third;
  BlockOfNumbers Weight; ///< zero at the points that only fill up the last block
};

inline constexpr std::size_t NumberOfTriangleRules = 3;
inline constexpr std::array<int, NumberOfTriangleRules> TriangleRuleDegrees = { 5, 8, 12 };

/** The rule exact for polynomials of degree TriangleRuleDegrees[index]. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const QuadratureBlock> TriangleRule(
  std::size_t index);

/**
 * A rule exact for polynomials of at least `degree`, all points inside: one of the above, or from
 * degree 13 on Gauss' rules in collapsed coordinates (A. H. Stroud, Approximate calculation of
 * multiple integrals, 1971). Safe to call from several threads.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const QuadratureBlock> TriangleRuleOfDegree(
  int degree);

/** Signed: positive when counter-clockwise. */
inline double TriangleArea(const Triangle2& triangle)
{
  const auto& [a, b, c] = triangle;
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/** Puts the points of a block on a triangle. */
inline void PlaceBlock(const QuadratureBlock& block, const Triangle2& triangle, PointBlock& points)
{
  const auto& [a, b, c] = triangle;
  for (std::size_t i = 0; i < PointBlockSize; ++i)
  {
    points.X[i] = block.First[i] * a.x + block.Second[i] * b.x + block.Third[i] * c.x;
    points.Y[i] = block.First[i] * a.y + block.Second[i] * b.y + block.Third[i] * c.y;
  }
}

/** The integrals of the components of a vector-valued function, and of their absolute values. */
struct TriangleIntegrals
{
  std::vector<double> Value;
  std::vector<double> Absolute;
};

/** What an integrand fills: its components, each at all points of a block. */
using IntegrandValues = std::span<BlockOfNumbers>;

/**
 * Integrates functions with `size` components, `integrand(const PointBlock&, IntegrandValues)`,
 * over triangles. Keeps its memory from call to call; a thread needs one of its own.
 */
class TriangleIntegrator
{
public:
  explicit TriangleIntegrator(std::size_t size)
    : Values(size)
    , Levels(1)
  {
  }

  /** One rule, no subdivision. */
  template <typename Integrand>
  void ApplyRule(std::size_t rule, const Triangle2& triangle, const Integrand& integrand,
    TriangleIntegrals& sums)
  {
    const std::size_t size = this->Values.size();
    sums.Value.assign(size, 0.0);
    sums.Absolute.assign(size, 0.0);
    PointBlock points;
    for (const QuadratureBlock& block : TriangleRule(rule))
    {
      PlaceBlock(block, triangle, points);
      integrand(points, IntegrandValues(this->Values));
      for (std::size_t k = 0; k < size; ++k)
      {
        double value = sums.Value[k];
        double absolute = sums.Absolute[k];
        for (std::size_t i = 0; i < PointBlockSize; ++i)
        {
          const double term = block.Weight[i] * this->Values[k][i];
          value += term;
          absolute += std::abs(term);
        }
        sums.Value[k] = value;
        sums.Absolute[k] = absolute;
      }
    }
    const double area = TriangleArea(triangle);
    for (std::size_t k = 0; k < size; ++k)
    {
      sums.Value[k] *= area;
      sums.Absolute[k] *= std::abs(area);
    }
  }

  /**
   * Adds the integral over a triangle (signed area) to `sum`. `agree(coarse, fine, area) -> bool`
   * decides whether two approximations, both TriangleIntegrals, are near enough. At most `depth`
   * bisections of the sides are made.
   */
  template <typename Integrand, typename Agree>
  void Add(const Triangle2& triangle, const Integrand& integrand, const Agree& agree,
    std::span<double> sum, int depth = 14)
  {
    this->AddLevel(0, triangle, integrand, agree, sum, depth);
  }

private:
  template <typename Integrand, typename Agree>
  void AddLevel(std::size_t level, const Triangle2& triangle, const Integrand& integrand,
    const Agree& agree, std::span<double> sum, int depth)
  {
    if (this->Levels.size() <= level)
    {
      this->Levels.resize(level + 1);
    }
    const double area = TriangleArea(triangle);
    this->ApplyRule(0, triangle, integrand, this->Coarse);
    for (std::size_t rule = 1; rule < NumberOfTriangleRules; ++rule)
    {
      this->ApplyRule(rule, triangle, integrand, this->Fine);
      if (agree(this->Coarse, this->Fine, area) ||
        (depth <= 0 && rule + 1 == NumberOfTriangleRules))
      {
        for (std::size_t k = 0; k < sum.size(); ++k)
        {
          sum[k] += this->Fine.Value[k];
        }
        return;
      }
      std::swap(this->Coarse, this->Fine);
    }
    const auto middle = [](const Point2& p, const Point2& q) {
      return Point2{ 0.5 * (p.x + q.x), 0.5 * (p.y + q.y) };
    };
    const auto& [a, b, c] = triangle;
    const Point2 ab = middle(a, b);
    const Point2 bc = middle(b, c);
    const Point2 ca = middle(c, a);
    this->Levels[level].assign(sum.size(), 0.0);
    for (const Triangle2& part : { Triangle2{ a, ab, ca }, Triangle2{ ab, b, bc },
           Triangle2{ ca, bc, c }, Triangle2{ ab, bc, ca } })
    {
      this->AddLevel(level + 1, part, integrand, agree, this->Levels[level], depth - 1);
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
    {
      sum[k] += this->Levels[level][k];
    }
  }

  std::vector<BlockOfNumbers> Values;
  TriangleIntegrals Coarse;
  TriangleIntegrals Fine;
  std::vector<std::vector<double>> Levels; // the sums of the triangles that are cut, by depth
};

} // namespace pemesh

#endif

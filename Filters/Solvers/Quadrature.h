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
#include "TestProblems.h"
#include "pemeshFiltersSolversModule.h" // For export macro

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

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
PEMESHFILTERSSOLVERS_EXPORT std::span<const QuadratureBlock> TriangleRule(std::size_t index);

/** Signed: positive when counter-clockwise. */
inline double TriangleArea(const Triangle2& triangle)
{
  const auto& [a, b, c] = triangle;
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/** The integrals of the components of a vector-valued function, and of their absolute values. */
template <std::size_t Size>
struct TriangleIntegrals
{
  std::array<double, Size> Value{};
  std::array<double, Size> Absolute{};
};

/** What an integrand gives: its components, each at all points of a block. */
template <std::size_t Size>
using IntegrandValues = std::array<BlockOfNumbers, Size>;

template <std::size_t Size, typename Integrand>
TriangleIntegrals<Size> ApplyTriangleRule(
  std::size_t rule, const Triangle2& triangle, double area, const Integrand& integrand)
{
  TriangleIntegrals<Size> sums;
  const auto& [a, b, c] = triangle;
  IntegrandValues<Size> values;
  PointBlock points;
  for (const QuadratureBlock& block : TriangleRule(rule))
  {
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      points.X[i] = block.First[i] * a.x + block.Second[i] * b.x + block.Third[i] * c.x;
      points.Y[i] = block.First[i] * a.y + block.Second[i] * b.y + block.Third[i] * c.y;
    }
    integrand(points, values);
    for (std::size_t k = 0; k < Size; ++k)
    {
      for (std::size_t i = 0; i < PointBlockSize; ++i)
      {
        const double term = block.Weight[i] * values[k][i];
        sums.Value[k] += term;
        sums.Absolute[k] += std::abs(term);
      }
    }
  }
  for (std::size_t k = 0; k < Size; ++k)
  {
    sums.Value[k] *= area;
    sums.Absolute[k] *= std::abs(area);
  }
  return sums;
}

/**
 * Integrates `integrand(const PointBlock&, IntegrandValues<Size>&)` over a triangle (signed area).
 * `agree(coarse, fine, area) -> bool` decides whether two approximations, both
 * TriangleIntegrals<Size>, are near enough. At most `depth` bisections of the sides are made.
 */
template <std::size_t Size, typename Integrand, typename Agree>
std::array<double, Size> IntegrateOverTriangle(
  const Triangle2& triangle, const Integrand& integrand, const Agree& agree, int depth = 14)
{
  const double area = TriangleArea(triangle);
  auto coarse = ApplyTriangleRule<Size>(0, triangle, area, integrand);
  for (std::size_t rule = 1; rule < NumberOfTriangleRules; ++rule)
  {
    const auto fine = ApplyTriangleRule<Size>(rule, triangle, area, integrand);
    if (agree(coarse, fine, area) || (depth <= 0 && rule + 1 == NumberOfTriangleRules))
    {
      return fine.Value;
    }
    coarse = fine;
  }
  const auto middle = [](const Point2& p, const Point2& q) {
    return Point2{ 0.5 * (p.x + q.x), 0.5 * (p.y + q.y) };
  };
  const auto& [a, b, c] = triangle;
  const Point2 ab = middle(a, b);
  const Point2 bc = middle(b, c);
  const Point2 ca = middle(c, a);
  std::array<double, Size> sum{};
  for (const Triangle2& part : { Triangle2{ a, ab, ca }, Triangle2{ ab, b, bc },
         Triangle2{ ca, bc, c }, Triangle2{ ab, bc, ca } })
  {
    const auto values = IntegrateOverTriangle<Size>(part, integrand, agree, depth - 1);
    for (std::size_t k = 0; k < Size; ++k)
    {
      sum[k] += values[k];
    }
  }
  return sum;
}

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Integrals over triangles to a wanted accuracy, of functions that are smooth on the scale of the
 * triangle or that quadrature can see not to be so: what is narrower than about a tenth of a
 * triangle, or jumps in a corner of it, may be missed.
 *
 * Symmetric rules of degree 5, 8 and 12 (7, 16 and 33 points, all inside, all weights positive; D.
 * A. Dunavant, Int. J. Numer. Methods Eng. 21 (1985) 1129-1148) are tried in turn until two agree;
 * where the last two do not, the triangle is cut into four. The first is compared with a rule of
 * lower degree on its own points, so that small elements cost little. It is the better one of the
 * two rules that is returned, and DifferenceAllowed says from which difference of the two its own
 * error follows, as QUADPACK does (R. Piessens, E. de Doncker-Kapenga, C. W. Ueberhuber, D. K.
 * Kahaner, QUADPACK, 1983).
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
  ///@{
  /** Of a rule on some of these points: of degree 2, 4, 6 for that of degree 5, 8, 12. */
  BlockOfNumbers EmbeddedWeight;
  BlockOfNumbers FirstDegreeWeight; ///< of degree 1; only in the rule of degree 5
  ///@}
};

inline constexpr std::size_t NumberOfTriangleRules = 3;
inline constexpr std::array<int, NumberOfTriangleRules> TriangleRuleDegrees = { 5, 8, 12 };

/** The degrees of two rules that are compared. */
struct ComparedRules
{
  int Coarse;
  int Fine;
};

/** A rule, and what it is compared with: the one before, or for the first the one on its points. */
struct QuadratureStep
{
  std::span<const QuadratureBlock> Rule;
  ComparedRules Degrees; ///< Coarse is negative where there is nothing to compare the first with
};

/** For any function: 2 with 5, 5 with 8, 8 with 12. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const QuadratureStep> GeneralSteps();

/**
 * For squares of the errors of a method of order 1 … 6, polynomials of degree 2 k + 2 on tiny
 * triangles: rules from that degree on.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const QuadratureStep> StepsForErrors(int order);

/**
 * The relative difference of two rules at which the error of the finer one is about `tolerance`.
 * The error of a rule of degree d on a triangle that is small for the integrand is proportional to
 * a power d + 1 - lowest of its size, where `lowest` is the degree of the polynomial that the
 * integrand is on a tiny triangle: 0 in general, 2 k + 2 for the square of the error of a method of
 * order k. Zero where the coarser rule does not even take that polynomial. Never more than
 * tolerance^(2/5), because a small difference may be chance.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double DifferenceAllowed(
  double tolerance, const ComparedRules& rules, int lowest = 0);

/** The same for all steps. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::vector<double> DifferencesAllowed(
  double tolerance, std::span<const QuadratureStep> steps, int lowest = 0);

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
  ///@{
  /** By the rules on the same points; empty from the second rule on. */
  std::vector<double> Embedded;
  std::vector<double> FirstDegree;
  ///@}
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
  /** Every triangle is cut `leastCuts` times whatever the rules say, for functions with jumps. */
  explicit TriangleIntegrator(std::size_t size,
    std::span<const QuadratureStep> steps = GeneralSteps(), std::size_t leastCuts = 0)
    : Steps(steps)
    , LeastCuts(leastCuts)
    , Values(size)
    , Levels(1)
  {
  }

  /** One rule, no subdivision; those on the same points as well if asked for. */
  template <typename Integrand>
  void ApplyRule(std::span<const QuadratureBlock> rule, bool withEmbedded,
    const Triangle2& triangle, const Integrand& integrand, TriangleIntegrals& sums)
  {
    const std::size_t size = this->Values.size();
    sums.Value.assign(size, 0.0);
    sums.Absolute.assign(size, 0.0);
    const std::size_t lower = withEmbedded ? size : 0;
    sums.Embedded.assign(lower, 0.0);
    sums.FirstDegree.assign(lower, 0.0);
    PointBlock points;
    for (const QuadratureBlock& block : rule)
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
      for (std::size_t k = 0; k < lower; ++k)
      {
        for (std::size_t i = 0; i < PointBlockSize; ++i)
        {
          sums.Embedded[k] += block.EmbeddedWeight[i] * this->Values[k][i];
          sums.FirstDegree[k] += block.FirstDegreeWeight[i] * this->Values[k][i];
        }
      }
    }
    const double area = TriangleArea(triangle);
    for (std::size_t k = 0; k < size; ++k)
    {
      sums.Value[k] *= area;
      sums.Absolute[k] *= std::abs(area);
    }
    for (std::size_t k = 0; k < lower; ++k)
    {
      sums.Embedded[k] *= area;
      sums.FirstDegree[k] *= area;
    }
  }

  /**
   * Adds the integral over a triangle (signed area) to `sum`. `agree(coarse, fine, area, step) ->
   * bool` decides whether two approximations, both TriangleIntegrals, by the rules
   * of a step, are near enough. At most `depth` bisections of the sides are made.
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
    for (std::size_t step = 0; level >= this->LeastCuts && step < this->Steps.size(); ++step)
    {
      const bool isCompared = this->Steps[step].Degrees.Coarse >= 0;
      this->ApplyRule(
        this->Steps[step].Rule, step == 0 && isCompared, triangle, integrand, this->Fine);
      if (step == 0)
      {
        this->Coarse.Value.swap(this->Fine.Embedded);
        this->Coarse.FirstDegree.swap(this->Fine.FirstDegree);
      }
      if ((isCompared && agree(this->Coarse, this->Fine, area, step)) ||
        (depth <= 0 && step + 1 == this->Steps.size()))
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

  std::span<const QuadratureStep> Steps;
  std::size_t LeastCuts;
  std::vector<BlockOfNumbers> Values;
  TriangleIntegrals Coarse;
  TriangleIntegrals Fine;
  std::vector<std::vector<double>> Levels; // the sums of the triangles that are cut, by depth
};

} // namespace pemesh

#endif

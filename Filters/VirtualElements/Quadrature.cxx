// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quadrature.h"

#include "GaussRules.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace pemesh
{

namespace
{

struct QuadraturePoint
{
  double First;
  double Second;
  double Third;
  double Weight;
  double EmbeddedWeight = 0.0;
  double FirstDegreeWeight = 0.0;
};

// The orbits of the symmetry group of the triangle: the centroid, three points (1-2a, a, a), six
// points (a, b, 1-a-b).
// Each may have a weight of the rule of lower degree on the same points.
void AddCentroid(std::vector<QuadraturePoint>& rule, double weight, double embedded = 0.0)
{
  const double third = 1.0 / 3.0;
  rule.push_back({ third, third, third, weight, embedded });
}

void AddThree(std::vector<QuadraturePoint>& rule, double weight, double a, double embedded = 0.0)
{
  const double b = 1.0 - 2.0 * a;
  rule.push_back({ b, a, a, weight, embedded });
  rule.push_back({ a, b, a, weight, embedded });
  rule.push_back({ a, a, b, weight, embedded });
}

void AddSix(
  std::vector<QuadraturePoint>& rule, double weight, double a, double b, double embedded = 0.0)
{
  const double c = 1.0 - a - b;
  for (const auto& [first, second, third] :
    { std::array{ a, b, c }, std::array{ b, c, a }, std::array{ c, a, b }, std::array{ a, c, b },
      std::array{ c, b, a }, std::array{ b, a, c } })
  {
    rule.push_back({ first, second, third, weight, embedded });
  }
}

// J. Radon, Monatsh. Math. Phys. 52 (1948) 286-300.
std::vector<QuadraturePoint> MakeDegreeFive()
{
  const double root = std::sqrt(15.0);
  std::vector<QuadraturePoint> rule;
  AddCentroid(rule, 9.0 / 40.0);
  const double a = (6.0 - root) / 21.0;
  const double b = (6.0 + root) / 21.0;
  AddThree(rule, (155.0 - root) / 1200.0, a);
  AddThree(rule, (155.0 + root) / 1200.0, b);
  // Without the centroid, two equations for the weights of degree 2: they sum to one, and the mean
  // of l1 l2 + l2 l3 + l3 l1 (l the barycentric coordinates) is 1/4. One orbit alone has degree 1.
  const auto mean = [](double c) { return 2.0 * c * (1.0 - 2.0 * c) + c * c; };
  const double first = (0.25 - mean(b)) / (mean(a) - mean(b));
  constexpr std::size_t three = 3;
  for (std::size_t i = 1; i <= three; ++i)
  {
    rule[i].EmbeddedWeight = first / three;
    rule[i + three].EmbeddedWeight = (1.0 - first) / three;
    rule[i].FirstDegreeWeight = 1.0 / three;
  }
  return rule;
}

// Dunavant's tables, carried to full precision by Newton's method on the moment equations. Four
// orbits are enough for degree 4, and seven for degree 6, with positive weights.
std::vector<QuadraturePoint> MakeDegreeEight()
{
  std::vector<QuadraturePoint> rule;
  AddCentroid(rule, 0.14431560767778716836, 0.03867445238198533853);
  AddThree(rule, 0.09509163426728462468, 0.45929258829272315610, 0.15362259832124543615);
  AddThree(rule, 0.10321737053471825023, 0.17056930775176020672, 0.12189192577927783179);
  AddThree(rule, 0.03245849762319808033, 0.05054722831703097548, 0.04492732510548161922);
  AddSix(rule, 0.02723031417443499432, 0.00839477740995760547, 0.26311282963463811327);
  return rule;
}

std::vector<QuadraturePoint> MakeDegreeTwelve()
{
  std::vector<QuadraturePoint> rule;
  AddThree(rule, 0.02573106644045533647, 0.48821738977380488156, 0.01055475450880007859);
  AddThree(rule, 0.04369254453803840582, 0.43972439229446027146, 0.09254988106435702105);
  AddThree(rule, 0.06285822421788509822, 0.27121038501211592347, 0.06053297579384178486);
  AddThree(rule, 0.03479611293070893682, 0.12757614554158591368, 0.07882407615266144454);
  AddThree(rule, 0.00616626105155901815, 0.02131735045321037234, 0.01250369653917057246);
  AddSix(rule, 0.04037155776638093275, 0.11534349453469800111, 0.27571326968551417835);
  AddSix(rule, 0.02235677320230344489, 0.02283833222225702872, 0.28132558098993955327,
    0.03661701299389244045);
  AddSix(rule, 0.01731623110865889129, 0.02573405054833022637, 0.11625191590759714562,
    0.00256696164335877547);
  return rule;
}

std::vector<QuadratureBlock> MakeBlocks(const std::vector<QuadraturePoint>& rule)
{
  std::vector<QuadratureBlock> blocks((rule.size() + PointBlockSize - 1) / PointBlockSize);
  for (std::size_t slot = 0; slot < blocks.size() * PointBlockSize; ++slot)
  {
    QuadratureBlock& block = blocks[slot / PointBlockSize];
    const std::size_t i = slot % PointBlockSize;
    const bool real = slot < rule.size();
    const QuadraturePoint& point = real ? rule[slot] : rule.back();
    block.First[i] = point.First;
    block.Second[i] = point.Second;
    block.Third[i] = point.Third;
    block.Weight[i] = real ? point.Weight : 0.0;
    block.EmbeddedWeight[i] = real ? point.EmbeddedWeight : 0.0;
    block.FirstDegreeWeight[i] = real ? point.FirstDegreeWeight : 0.0;
  }
  return blocks;
}

// Gauss' rules of n points in u and v, (x, y) = (u, v (1 - u)). The factor 1 - u of the area takes
// one degree more in u.
std::vector<QuadraturePoint> MakeCollapsed(int degree)
{
  const GaussRule outer = GaussLegendre(degree / 2 + 2);
  const GaussRule inner = GaussLegendre(degree / 2 + 1);
  std::vector<QuadraturePoint> rule;
  for (std::size_t i = 0; i < outer.Points.size(); ++i)
  {
    const double u = outer.Points[i];
    for (std::size_t j = 0; j < inner.Points.size(); ++j)
    {
      const double v = inner.Points[j] * (1.0 - u);
      rule.push_back({ 1.0 - u - v, u, v, 2.0 * (1.0 - u) * outer.Weights[i] * inner.Weights[j] });
    }
  }
  return rule;
}

constexpr int LargestCollapsedDegree = 200;

const std::vector<QuadratureBlock>& CollapsedRule(int degree)
{
  static std::array<std::once_flag, LargestCollapsedDegree + 1> made;
  static std::array<std::vector<QuadratureBlock>, LargestCollapsedDegree + 1> rules;
  const std::size_t index = static_cast<std::size_t>(std::min(degree, LargestCollapsedDegree));
  std::call_once(
    made[index], [index] { rules[index] = MakeBlocks(MakeCollapsed(static_cast<int>(index))); });
  return rules[index];
}

} // namespace

double DifferenceAllowed(double tolerance, const ComparedRules& rules, int lowest)
{
  const int coarse = rules.Coarse + 1 - lowest;
  const int fine = rules.Fine + 1 - lowest;
  constexpr double smallestPower = 0.4;
  return coarse <= 0
    ? 0.0
    : std::pow(tolerance, std::max(smallestPower, static_cast<double>(coarse) / fine));
}

std::vector<double> DifferencesAllowed(
  double tolerance, std::span<const QuadratureStep> steps, int lowest)
{
  std::vector<double> allowed;
  for (const QuadratureStep& step : steps)
  {
    allowed.push_back(DifferenceAllowed(tolerance, step.Degrees, lowest));
  }
  return allowed;
}

std::span<const QuadratureStep> GeneralSteps()
{
  static const std::array steps{ QuadratureStep{ TriangleRule(0), { 2, 5 } },
    QuadratureStep{ TriangleRule(1), { 5, 8 } }, QuadratureStep{ TriangleRule(2), { 8, 12 } } };
  return steps;
}

std::span<const QuadratureStep> StepsForErrors(int order)
{
  using Steps = std::vector<QuadratureStep>;
  static const Steps ofOrderOne{ { TriangleRule(1), { 4, 8 } }, { TriangleRule(2), { 8, 12 } } };
  static const Steps ofOrderTwo{ { TriangleRule(2), { 6, 12 } } };
  static const Steps ofOrderThree{ { TriangleRule(1), { -1, 8 } }, { TriangleRule(2), { 8, 12 } } };
  static const auto collapsed = [](int degree)
  {
    return Steps{ { CollapsedRule(degree), { -1, degree } },
      { CollapsedRule(degree + 4), { degree, degree + 4 } } };
  };
  static const Steps ofOrderFour = collapsed(10);
  static const Steps ofOrderFive = collapsed(12);
  static const Steps ofOrderSix = collapsed(14);
  static const std::array all{ &ofOrderOne, &ofOrderTwo, &ofOrderThree, &ofOrderFour, &ofOrderFive,
    &ofOrderSix };
  return *all[static_cast<std::size_t>(std::clamp(order, 1, 6) - 1)];
}

std::span<const QuadratureBlock> TriangleRuleOfDegree(int degree)
{
  for (std::size_t index = 0; index < NumberOfTriangleRules; ++index)
  {
    if (degree <= TriangleRuleDegrees[index])
    {
      return TriangleRule(index);
    }
  }
  return CollapsedRule(degree);
}

std::span<const QuadratureBlock> TriangleRule(std::size_t index)
{
  static const std::array<std::vector<QuadratureBlock>, NumberOfTriangleRules> rules = {
    MakeBlocks(MakeDegreeFive()), MakeBlocks(MakeDegreeEight()), MakeBlocks(MakeDegreeTwelve())
  };
  return rules[index];
}

} // namespace pemesh

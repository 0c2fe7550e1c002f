// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestProblems.h"

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

namespace pemesh
{

namespace
{

using Numbers = Eigen::Array<double, PointBlockSize, 1>;

// exp(x) for -708 <= x <= 708 (values below count as -708), to about one unit in the last place:
// with x = k log 2 + r, exp(x) = 2^k exp(r), and Taylor's series has an error of 4e-18 for |r| <=
// log(2)/2. Free of branches, so that the compiler treats several numbers at a time; the
// exponential is what a study spends its time on, and the library's takes them one by one.
Numbers Exponential(const Numbers& argument)
{
  constexpr double magic = 0x1.8p52; // adding it rounds to an integer, left in the low bits
  constexpr double inverseFactorial[] = { 1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0,
    1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0,
    1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0 };
  const Numbers x = argument.max(-708.0);
  const Numbers shifted = x * std::numbers::log2e + magic;
  const Numbers k = shifted - magic;
  // log 2 in two parts: the first has so few digits that its product with k is exact.
  const Numbers r = (x - k * 0x1.62e42fee00000p-1) - k * 0x1.a39ef35793c76p-33;
  Numbers series = Numbers::Constant(inverseFactorial[0]);
  for (std::size_t j = 1; j < std::size(inverseFactorial); ++j)
  {
    series = series * r + inverseFactorial[j];
  }
  Numbers result;
  for (std::size_t i = 0; i < PointBlockSize; ++i)
  {
    result.data()[i] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(series.data()[i]) +
      (std::bit_cast<std::uint64_t>(shifted.data()[i]) << 52));
  }
  return result;
}

// What a problem's function fills.
struct Values
{
  Numbers Solution = Numbers::Zero();
  Numbers GradientX = Numbers::Zero();
  Numbers GradientY = Numbers::Zero();
  Numbers Source = Numbers::Zero();

  // Adds w exp(q) where q has gradient (qx, qy) and Laplacian `curvature`:
  // grad = w exp(q) grad q, Laplace = w exp(q) (Laplace q + |grad q|^2).
  void AddBump(
    double weight, const Numbers& q, const Numbers& qx, const Numbers& qy, double curvature)
  {
    const Numbers value = weight * Exponential(q);
    this->Solution += value;
    this->GradientX += value * qx;
    this->GradientY += value * qy;
    this->Source -= value * (curvature + qx.square() + qy.square());
  }
};

// R. Franke, A critical comparison of some methods for interpolation of scattered data,
// NPS-53-79-003, 1979, has lastWeight -1/5; the literature on polytopal methods often has +1/5.
Values Franke(const Numbers& pointX, const Numbers& pointY, double lastWeight)
{
  const Numbers x = 9.0 * pointX;
  const Numbers y = 9.0 * pointY;
  Values sum;
  sum.AddBump(0.75, -((x - 2.0).square() + (y - 2.0).square()) / 4.0, -4.5 * (x - 2.0),
    -4.5 * (y - 2.0), -81.0);
  sum.AddBump(0.75, -(x + 1.0).square() / 49.0 - (y + 1.0) / 10.0, -18.0 / 49.0 * (x + 1.0),
    Numbers::Constant(-0.9), -162.0 / 49.0);
  sum.AddBump(0.5, -((x - 7.0).square() + (y - 3.0).square()) / 4.0, -4.5 * (x - 7.0),
    -4.5 * (y - 3.0), -81.0);
  sum.AddBump(lastWeight, -(x - 4.0).square() - (y - 7.0).square(), -18.0 * (x - 4.0),
    -18.0 * (y - 7.0), -324.0);
  return sum;
}

Values FrankePlus(const Numbers& x, const Numbers& y)
{
  return Franke(x, y, 0.2);
}

Values FrankeMinus(const Numbers& x, const Numbers& y)
{
  return Franke(x, y, -0.2);
}

Values Linear(const Numbers& x, const Numbers& y)
{
  return { 1.0 + x + 2.0 * y, Numbers::Constant(1.0), Numbers::Constant(2.0), Numbers::Zero() };
}

Values Polynomial(const Numbers& x, const Numbers& y)
{
  const Numbers a = x * (1.0 - x);
  const Numbers b = y * (1.0 - y);
  return { 16.0 * a * b + 1.1, 16.0 * (1.0 - 2.0 * x) * b, 16.0 * a * (1.0 - 2.0 * y),
    32.0 * (a + b) };
}

Values Trigonometric(const Numbers& x, const Numbers& y)
{
  const double omega = 2.0 * std::numbers::pi;
  const Numbers sx = (omega * x).sin();
  const Numbers sy = (omega * y).sin();
  const Numbers u = sx * sy;
  return { u, omega * (omega * x).cos() * sy, omega * sx * (omega * y).cos(),
    2.0 * omega * omega * u };
}

// Brings a problem's function into the form of the table, which knows nothing of Eigen.
template <Values (*Function)(const Numbers&, const Numbers&)>
void Evaluate(const PointBlock& points, TestProblemBlock& block)
{
  const Values values = Function(
    Eigen::Map<const Numbers>(points.X.data()), Eigen::Map<const Numbers>(points.Y.data()));
  Eigen::Map<Numbers>(block.Solution.data()) = values.Solution;
  Eigen::Map<Numbers>(block.GradientX.data()) = values.GradientX;
  Eigen::Map<Numbers>(block.GradientY.data()) = values.GradientY;
  Eigen::Map<Numbers>(block.Source.data()) = values.Source;
}

// The harmonic function of a re-entrant corner at the centre of the unit square, without the part x
// > 1/2, y < 1/2: r^(2/3) sin(2 theta / 3), theta from the edge to the right of the corner.
void EvaluateCorner(const PointBlock& points, TestProblemBlock& block)
{
  const double quarter = std::numbers::pi / 4.0;
  for (std::size_t i = 0; i < PointBlockSize; ++i)
  {
    const double x = points.X[i] - 0.5;
    const double y = points.Y[i] - 0.5;
    const double r = std::hypot(x, y);
    // The branch cut runs through the middle of the part that is missing.
    const double theta = 3.0 * quarter + std::atan2(-x - y, y - x);
    const double slope = 2.0 / 3.0 / std::cbrt(r); // infinite in the corner
    block.Solution[i] = std::cbrt(r * r) * std::sin(2.0 / 3.0 * theta);
    block.GradientX[i] = -slope * std::sin(theta / 3.0);
    block.GradientY[i] = slope * std::cos(theta / 3.0);
    block.Source[i] = 0.0;
  }
}

constexpr std::array Problems = {
  TestProblem{ "franke", "Franke function",
    "3/4 exp(-((9x-2)^2 + (9y-2)^2)/4) + 3/4 exp(-(9x+1)^2/49 - (9y+1)/10) + "
    "1/2 exp(-((9x-7)^2 + (9y-3)^2)/4) + 1/5 exp(-(9x-4)^2 - (9y-7)^2)",
    Evaluate<FrankePlus> },
  TestProblem{ "franke-1979", "Franke function of 1979",
    "3/4 exp(-((9x-2)^2 + (9y-2)^2)/4) + 3/4 exp(-(9x+1)^2/49 - (9y+1)/10) + "
    "1/2 exp(-((9x-7)^2 + (9y-3)^2)/4) - 1/5 exp(-(9x-4)^2 - (9y-7)^2)",
    Evaluate<FrankeMinus> },
  TestProblem{ "linear", "Linear (patch test)", "1 + x + 2 y", Evaluate<Linear> },
  TestProblem{ "polynomial", "Polynomial", "16 x y (1-x) (1-y) + 1.1", Evaluate<Polynomial> },
  TestProblem{
    "trigonometric", "Trigonometric", "sin(2 pi x) sin(2 pi y)", Evaluate<Trigonometric> },
  TestProblem{
    "cosine", "Trigonometric, not zero on the boundary", "cos(pi*x)*cos(pi*y)+x*sin(pi*y)" },
  TestProblem{ "constant", "Constant", "1" },
  TestProblem{ "quadratic", "Quadratic (patch test)", "1+x+2*y+x^2-x*y+2*y^2" },
  TestProblem{ "cubic", "Cubic (patch test)", "1+x+2*y-x*y+x^3-2*x^2*y+x*y^2+3*y^3" },
  TestProblem{ "quartic", "Quartic (patch test)", "1+x-y^2+x^3*y-2*x^2*y^2+x^4-y^4" },
  TestProblem{ "quintic", "Quintic (patch test)", "1-y+x*y+x^5-3*x^3*y^2+2*x*y^4-y^5" },
  TestProblem{ "sextic", "Sextic (patch test)", "1+x^2+y^5+x^6-2*x^4*y^2+x^3*y^3-y^6" },
  TestProblem{ "boundary-layer", "Boundary layer", "x*y*(1-exp((x-1)/0.05))*(1-exp((y-1)/0.05))" },
  TestProblem{ "l-shape", "Re-entrant corner",
    "r^(2/3) sin(2 theta/3) about (1/2, 1/2), on a domain without x > 1/2, y < 1/2",
    EvaluateCorner },
  TestProblem{ "advection", "Advection-dominated", "x*y*(1-exp((x-1)/0.02))*(1-exp((y-1)/0.02))",
    nullptr, "0.02", "1", "1" },
  TestProblem{ "reaction", "Diffusion, advection and reaction that vary", "sin(pi*x)*exp(y)",
    nullptr, "1+x*y/2", "1+y", "-x", "2+sin(x*y)" },
  TestProblem{ "anisotropic", "Anisotropic diffusion that varies", "sin(pi*x)*exp(y)", nullptr,
    "1+x", "0", "0", "0", "x*y/2", "0.1+y" },
};

} // namespace

std::span<const TestProblem> TestProblems()
{
  return Problems;
}

const TestProblem* FindTestProblem(std::string_view name)
{
  for (const TestProblem& problem : Problems)
  {
    if (name == problem.Name)
    {
      return &problem;
    }
  }
  return nullptr;
}

} // namespace pemesh

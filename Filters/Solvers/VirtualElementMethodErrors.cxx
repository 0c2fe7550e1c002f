// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodErrors.h"

#include "ElementTriangles.h"
#include "ParallelLoop.h"
#include "Quadrature.h"
#include "TestProblems.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr double NormTolerance = 1.0e-10;

// Rounding in u and its gradient, in units of their largest values: where the error is of that
// size its square cannot be integrated to a relative tolerance, and need not be.
constexpr double RoundingUnits = 16.0 * std::numeric_limits<double>::epsilon();

// The squares that are integrated, in this order.
enum Square : std::size_t
{
  ErrorL2,
  ErrorH1,
  NormL2,
  NormH1,
  EnergyError,
  EnergyNorm,
  NumberOfSquares
};
constexpr std::size_t NumberOfIntegrals = 4;

// The largest |u| and |grad u| at the vertices.
struct Magnitude
{
  double Solution = 0.0;
  double Gradient = 0.0;
};

class SquaresAgree
{
public:
  explicit SquaresAgree(const Magnitude& magnitude)
    : Rounding{ RoundingUnits * magnitude.Solution, RoundingUnits * magnitude.Gradient,
      RoundingUnits * magnitude.Solution, RoundingUnits * magnitude.Gradient }
  {
  }

  bool operator()(const TriangleIntegrals<NumberOfIntegrals>& coarse,
    const TriangleIntegrals<NumberOfIntegrals>& fine, double area) const
  {
    for (std::size_t k = 0; k < NumberOfIntegrals; ++k)
    {
      // The square of e + rounding differs from that of e by 2 e rounding + rounding^2.
      const double noise = this->Rounding[k] * std::sqrt(std::abs(area));
      const double allowed =
        NormTolerance * fine.Absolute[k] + noise * (2.0 * std::sqrt(fine.Absolute[k]) + noise);
      if (!(std::abs(coarse.Value[k] - fine.Value[k]) <= allowed))
      {
        return false;
      }
    }
    return true;
  }

private:
  double Rounding[NumberOfIntegrals];
};

class ErrorWorker
{
public:
  ErrorWorker(const VirtualElementMesh& mesh, const VirtualElementParts& parts,
    const TestProblem& problem, const VirtualElementOptions& options,
    const VirtualElementResult& result, const Magnitude& magnitude,
    std::vector<std::array<double, NumberOfSquares>>& squares)
    : Mesh(mesh)
    , Parts(parts)
    , Problem(problem)
    , Options(options)
    , Result(result)
    , Agree(magnitude)
    , Squares(squares)
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    VirtualElement element;
    std::vector<Point2> vertices;
    ElementTriangles triangles;
    for (vtkIdType id = first; id < last; ++id)
    {
      this->Mesh.GetVertices(id, vertices);
      element.Set(vertices, this->Options.Constant);
      this->AddIntegrals(id, element, triangles.Cut(vertices));
      this->AddEnergies(id);
    }
  }

private:
  void AddIntegrals(
    vtkIdType id, const VirtualElement& element, std::span<const Triangle2> triangles) const
  {
    double constant = 0.0;
    Point2 gradient; // in the scaled monomials
    const auto ids = this->Mesh.Element(id);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const double value = this->Result.Solution[ids[i]];
      constant += value * element.Constant()[i];
      gradient.x += value * element.GradientX()[i];
      gradient.y += value * element.GradientY()[i];
    }
    const double h = element.Diameter();
    TestProblemBlock exact;
    const auto integrand = [&](const PointBlock& points, IntegrandValues<NumberOfIntegrals>& values)
    {
      this->Problem.Evaluate(points, exact);
      for (std::size_t i = 0; i < PointBlockSize; ++i)
      {
        const Point2 m = element.Scaled({ points.X[i], points.Y[i] });
        const double u = exact.Solution[i];
        const double ux = exact.GradientX[i];
        const double uy = exact.GradientY[i];
        const double e = u - (constant + gradient.x * m.x + gradient.y * m.y);
        const double ex = ux - gradient.x / h;
        const double ey = uy - gradient.y / h;
        values[ErrorL2][i] = e * e;
        values[ErrorH1][i] = ex * ex + ey * ey;
        values[NormL2][i] = u * u;
        values[NormH1][i] = ux * ux + uy * uy;
      }
    };
    auto& squares = this->Squares[id];
    squares.fill(0.0);
    for (const Triangle2& triangle : triangles)
    {
      const auto part = IntegrateOverTriangle<NumberOfIntegrals>(triangle, integrand, this->Agree);
      std::transform(part.begin(), part.end(), squares.begin(), squares.begin(), std::plus<>());
    }
  }

  void AddEnergies(vtkIdType id) const
  {
    const auto ids = this->Mesh.Element(id);
    const auto stiffness = this->Parts.StiffnessOf(id);
    auto& squares = this->Squares[id];
    std::size_t slot = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const double u = this->Result.GroundTruth[ids[i]];
      const double e = u - this->Result.Solution[ids[i]];
      for (std::size_t j = 0; j <= i; ++j, ++slot)
      {
        const double v = this->Result.GroundTruth[ids[j]];
        const double weight = i == j ? stiffness[slot] : 2.0 * stiffness[slot];
        squares[EnergyError] += weight * e * (v - this->Result.Solution[ids[j]]);
        squares[EnergyNorm] += weight * u * v;
      }
    }
  }

  const VirtualElementMesh& Mesh;
  const VirtualElementParts& Parts;
  const TestProblem& Problem;
  const VirtualElementOptions& Options;
  const VirtualElementResult& Result;
  SquaresAgree Agree;
  std::vector<std::array<double, NumberOfSquares>>& Squares;
};

Magnitude FindMagnitude(
  const VirtualElementMesh& mesh, const TestProblem& problem, std::span<const double> values)
{
  Magnitude magnitude;
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    if (mesh.Used[id])
    {
      const Point2 gradient = problem.Gradient(mesh.Points[id]);
      magnitude.Solution = std::max(magnitude.Solution, std::abs(values[id]));
      magnitude.Gradient = std::max(magnitude.Gradient, std::hypot(gradient.x, gradient.y));
    }
  }
  return magnitude;
}

// NaN where the exact solution is nothing but rounding, compared with `scale`.
double RelativeError(double error, double norm, double scale)
{
  return norm > 1.0e-12 * scale ? error / norm : std::numeric_limits<double>::quiet_NaN();
}

double SquareRoot(double square)
{
  return std::sqrt(std::max(square, 0.0)); // a vanishing energy may come out below zero
}

} // namespace

void ComputeErrors(const VirtualElementMesh& mesh, const VirtualElementParts& parts,
  const TestProblem& problem, const VirtualElementOptions& options, VirtualElementResult& result)
{
  std::vector<std::array<double, NumberOfSquares>> squares(mesh.NumberOfElements());
  ErrorWorker worker(mesh, parts, problem, options, result,
    FindMagnitude(mesh, problem, result.GroundTruth), squares);
  ParallelLoop(0, mesh.NumberOfElements(), 0, worker);
  std::array<double, NumberOfSquares> sums{};
  for (const auto& square : squares)
  {
    std::transform(sums.begin(), sums.end(), square.begin(), sums.begin(), std::plus<>());
  }
  double largestError = 0.0;
  double largestValue = 0.0;
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    if (mesh.Used[id])
    {
      const double u = result.GroundTruth[id];
      largestError = std::max(largestError, std::abs(u - result.Solution[id]));
      largestValue = std::max(largestValue, std::abs(u));
    }
  }
  // For scale: the H1 seminorm, and the gradient times the size of the domain.
  const double seminorm = SquareRoot(sums[NormH1]);
  result.RelativeErrorEnergy =
    RelativeError(SquareRoot(sums[EnergyError]), SquareRoot(sums[EnergyNorm]), seminorm);
  result.RelativeErrorInf = RelativeError(largestError, largestValue, seminorm);
  result.RelativeErrorL2 = RelativeError(SquareRoot(sums[ErrorL2]), SquareRoot(sums[NormL2]), 0.0);
  result.RelativeErrorH1 = RelativeError(SquareRoot(sums[ErrorH1]), seminorm, 0.0);
}

} // namespace pemesh

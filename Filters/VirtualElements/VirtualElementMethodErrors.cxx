// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodErrors.h"

#include "ElementMatrices.h"
#include "EllipticProblem.h"
#include "ParallelLoop.h"
#include "Quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double NormTolerance = 1.0e-10;

// Rounding in u and its gradient, in units of their largest values: where the error is of that
// size its square cannot be integrated to a relative tolerance, and need not be.
constexpr double RoundingUnits = 16.0 * std::numeric_limits<double>::epsilon();

// The squares that are summed over the elements; the first four are integrated.
enum Square : std::size_t
{
  ErrorL2,
  ErrorH1,
  NormL2,
  NormH1,
  EnergyError,
  EnergyNorm,
  ProjectedErrorL2,
  ProjectedErrorH1,
  ProjectedNormL2,
  ProjectedNormH1,
  NumberOfSquares
};
constexpr std::size_t NumberOfIntegrals = 4;

using Squares = std::array<double, NumberOfSquares>;

// The largest |u| and |grad u| at the vertices, or of a polynomial on an element.
struct Magnitude
{
  double Solution = 0.0;
  double Gradient = 0.0;
};

// By the integral and the step of the quadrature.
using AllowedDifferences = std::array<std::vector<double>, NumberOfIntegrals>;

AllowedDifferences DifferencesOfOrder(int order)
{
  const auto steps = StepsForErrors(order);
  return { DifferencesAllowed(NormTolerance, steps, 2 * order + 2),
    DifferencesAllowed(NormTolerance, steps, 2 * order), DifferencesAllowed(NormTolerance, steps),
    DifferencesAllowed(NormTolerance, steps) };
}

// For the integrals of the squares, and after them those of u times monomials.
class SquaresAgree
{
public:
  SquaresAgree(
    const AllowedDifferences& differences, const Magnitude& exact, const Magnitude& polynomial)
    : Differences(differences)
    , Rounding{ RoundingUnits * (exact.Solution + polynomial.Solution),
      RoundingUnits * (exact.Gradient + polynomial.Gradient), RoundingUnits * exact.Solution,
      RoundingUnits * exact.Gradient }
  {
  }

  bool operator()(const TriangleIntegrals& coarse, const TriangleIntegrals& fine, double area,
    std::size_t step) const
  {
    if (!std::isfinite(fine.Absolute[ErrorL2] + fine.Absolute[ErrorH1]))
    {
      return true; // and would not be anywhere in the triangle
    }
    for (std::size_t k = 0; k < NumberOfIntegrals; ++k)
    {
      // The square of e + rounding differs from that of e by 2 e rounding + rounding^2.
      const double noise = this->Rounding[k] * std::sqrt(std::abs(area));
      const double allowed = this->Differences[k][step] * fine.Absolute[k] +
        noise * (2.0 * std::sqrt(fine.Absolute[k]) + noise);
      if (!(std::abs(coarse.Value[k] - fine.Value[k]) <= allowed))
      {
        return false;
      }
    }
    const double allowed =
      this->Differences[NormL2][step] * std::sqrt(std::abs(area) * fine.Absolute[NormL2]);
    for (std::size_t k = NumberOfIntegrals; k < fine.Value.size(); ++k)
    {
      if (!(std::abs(coarse.Value[k] - fine.Value[k]) <= allowed))
      {
        return false;
      }
    }
    return true;
  }

private:
  const AllowedDifferences& Differences;
  double Rounding[NumberOfIntegrals];
};

// What the worker finds, by element.
struct ElementFindings
{
  std::vector<Squares> Sums;
  std::vector<ElementChecks> Checks;
};

class ErrorWorker
{
public:
  ErrorWorker(const VirtualElementMesh& mesh, const DegreesOfFreedom& dofs,
    const VirtualElementParts& parts, const EllipticProblem& problem,
    const VirtualElementOptions& options, std::span<const double> values, const ExactValues& truth,
    ElementFindings& findings)
    : Mesh(mesh)
    , Dofs(dofs)
    , Parts(parts)
    , Problem(problem)
    , Options(options)
    , Values(values)
    , Truth(truth.Solution)
    , Size{ truth.LargestValue, truth.LargestSlope }
    , Findings(findings)
    , Differences(DifferencesOfOrder(options.Order))
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    ElementMatrices matrices(this->Problem, this->Options);
    Space space(this->Options.Order, static_cast<std::size_t>(matrices.NumberOfMoments()),
      this->Problem.IsSmooth() ? 0 : 1);
    std::vector<Point2> vertices;
    for (vtkIdType id = first; id < last; ++id)
    {
      this->Mesh.GetVertices(id, vertices);
      matrices.SetForErrors(vertices);
      if (this->Problem.KnowsSolution())
      {
        this->FindErrors(id, matrices, space);
      }
      if (this->Options.Details)
      {
        this->Findings.Checks[id] = matrices.GetChecks();
      }
    }
  }

private:
  // Kept from element to element.
  struct Space
  {
    TriangleIntegrator Integrator;
    std::vector<double> Integrals;
    BlockValues Monomials;
    Eigen::VectorXd Values;
    Eigen::VectorXd Truth;
    Eigen::VectorXd Error;

    Space(int order, std::size_t moments, std::size_t leastCuts)
      : Integrator(NumberOfIntegrals + moments, StepsForErrors(order), leastCuts)
      , Integrals(NumberOfIntegrals + moments)
    {
    }
  };

  // The values of all degrees of freedom; of the moments those that solve the element's equations.
  void Recover(vtkIdType id, const ElementMatrices& matrices, Eigen::VectorXd& values) const
  {
    const auto ids = this->Dofs.OfElement(id);
    const auto outer = static_cast<Eigen::Index>(ids.size());
    const Eigen::Index moments = matrices.NumberOfMoments();
    values.resize(outer + moments);
    for (Eigen::Index i = 0; i < outer; ++i)
    {
      values(i) = this->Values[ids[static_cast<std::size_t>(i)]];
    }
    if (moments > 0)
    {
      const auto& matrix = matrices.Matrix();
      const Eigen::Map<const Eigen::VectorXd> load(
        this->Parts.MomentLoad.data() + id * moments, moments);
      values.tail(moments) =
        matrix.bottomRightCorner(moments, moments)
          .partialPivLu()
          .solve(load - matrix.bottomLeftCorner(moments, outer) * values.head(outer));
    }
  }

  void FindErrors(vtkIdType id, ElementMatrices& matrices, Space& space) const
  {
    const auto ids = this->Dofs.OfElement(id);
    const auto outer = static_cast<Eigen::Index>(ids.size());
    this->Recover(id, matrices, space.Values);
    const PolynomialCoefficients coefficients = matrices.Projection().lazyProduct(space.Values);
    this->Integrate(matrices, coefficients, space);
    Squares& squares = this->Findings.Sums[id];
    squares.fill(0.0);
    std::copy_n(space.Integrals.begin(), NumberOfIntegrals, squares.begin());

    Eigen::VectorXd& truth = space.Truth;
    truth.resize(space.Values.size());
    for (Eigen::Index i = 0; i < outer; ++i)
    {
      truth(i) = this->Truth[ids[static_cast<std::size_t>(i)]];
    }
    const Eigen::Map<const Eigen::VectorXd> moments(
      space.Integrals.data() + NumberOfIntegrals, truth.size() - outer);
    truth.tail(moments.size()) = matrices.Basis().FromMonomialIntegrals(moments) / matrices.Area();
    space.Error = truth - space.Values;
    const auto form = [](const auto& matrix, const auto& vector)
    { return vector.dot(matrix.lazyProduct(vector)); };
    const auto energy = [&](const Eigen::VectorXd& vector)
    {
      return matrices.NumberOfMoments() > 0
        ? form(matrices.Matrix(), vector)
        : this->Parts.Form(id, { vector.data(), static_cast<std::size_t>(vector.size()) });
    };
    squares[EnergyError] = energy(space.Error);
    squares[EnergyNorm] = energy(truth);
    const PolynomialCoefficients projectedTruth = matrices.Projection().lazyProduct(truth);
    const PolynomialCoefficients projectedError = projectedTruth - coefficients;
    const Eigen::Index size = coefficients.size();
    const auto mass = matrices.GetMass().topLeftCorner(size, size);
    squares[ProjectedErrorL2] = form(mass, projectedError);
    squares[ProjectedNormL2] = form(mass, projectedTruth);
    const auto& products = matrices.GetGradientProducts();
    squares[ProjectedErrorH1] = form(products, projectedError);
    squares[ProjectedNormH1] = form(products, projectedTruth);
  }

  void Integrate(
    const ElementMatrices& matrices, const PolynomialCoefficients& coefficients, Space& space) const
  {
    using Eight = Eigen::Array<double, PointBlockSize, 1>;
    const PolynomialBasis& basis = matrices.Basis();
    const Eigen::Index size = coefficients.size();
    const PolynomialCoefficients value = basis.ToMonomials(coefficients);
    const auto slope = [&](const Eigen::MatrixXd& derivative)
    {
      return basis.ToMonomials(
        derivative.topLeftCorner(size, size).transpose().lazyProduct(coefficients));
    };
    const PolynomialCoefficients slopeX = slope(basis.DerivativeX());
    const PolynomialCoefficients slopeY = slope(basis.DerivativeY());
    TestProblemBlock exact;
    BlockValues& monomials = space.Monomials;
    const auto map = [](const BlockOfNumbers& block)
    { return Eigen::Map<const Eight>(block.data()); };
    const auto integrand = [&](const PointBlock& points, IntegrandValues values)
    {
      this->Problem.Evaluate(points, exact);
      basis.EvaluateMonomials(points, this->Options.Order, monomials);
      const auto set = [&](std::size_t k, const Eight& numbers)
      { Eigen::Map<Eight>(values[k].data()) = numbers; };
      Eight e = map(exact.Solution);
      Eight ex = map(exact.GradientX);
      Eight ey = map(exact.GradientY);
      set(NormL2, e.square());
      set(NormH1, ex.square() + ey.square());
      for (std::size_t k = NumberOfIntegrals; k < values.size(); ++k)
      {
        set(k, e * monomials.col(static_cast<Eigen::Index>(k - NumberOfIntegrals)));
      }
      for (Eigen::Index a = 0; a < size; ++a)
      {
        e -= value(a) * monomials.col(a);
        ex -= slopeX(a) * monomials.col(a);
        ey -= slopeY(a) * monomials.col(a);
      }
      set(ErrorL2, e.square());
      set(ErrorH1, ex.square() + ey.square());
    };
    const SquaresAgree agree(this->Differences, this->Size,
      { value.lpNorm<1>(), slopeX.lpNorm<1>() + slopeY.lpNorm<1>() });
    std::fill(space.Integrals.begin(), space.Integrals.end(), 0.0);
    for (const Triangle2& triangle : matrices.Triangles())
    {
      space.Integrator.Add(triangle, integrand, agree, space.Integrals);
    }
  }

  const VirtualElementMesh& Mesh;
  const DegreesOfFreedom& Dofs;
  const VirtualElementParts& Parts;
  const EllipticProblem& Problem;
  const VirtualElementOptions& Options;
  std::span<const double> Values;
  std::span<const double> Truth;
  Magnitude Size;
  ElementFindings& Findings;
  AllowedDifferences Differences;
};

// NaN where the exact solution is nothing but rounding, compared with `scale`.
double RelativeError(double error, double norm, double scale)
{
  return norm > 1.0e-12 * scale ? error / norm : NotKnown;
}

double SquareRoot(double square)
{
  return std::sqrt(std::max(square, 0.0)); // a vanishing energy may come out below zero
}

double LargestRelativeError(const VirtualElementMesh& mesh, std::span<const double> values,
  std::span<const double> truth, double scale)
{
  double largestError = 0.0;
  double largestValue = 0.0;
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    if (mesh.Used[id])
    {
      largestError = std::max(largestError, std::abs(truth[id] - values[id]));
      largestValue = std::max(largestValue, std::abs(truth[id]));
    }
  }
  return RelativeError(largestError, largestValue, scale);
}

void SumErrors(const VirtualElementMesh& mesh, const std::vector<Squares>& elements,
  std::span<const double> values, std::span<const double> truth, VirtualElementResult& result)
{
  Squares sums{};
  result.ErrorL2.reserve(elements.size());
  result.ErrorH1.reserve(elements.size());
  for (const Squares& square : elements)
  {
    std::transform(sums.begin(), sums.end(), square.begin(), sums.begin(), std::plus<>());
    result.ErrorL2.push_back(SquareRoot(square[ErrorL2]));
    result.ErrorH1.push_back(SquareRoot(square[ErrorH1]));
  }
  const auto root = [&sums](Square which) { return SquareRoot(sums[which]); };
  // For scale: the H1 seminorm, and the gradient times the size of the domain.
  const double seminorm = root(NormH1);
  // A negative reaction may make the form indefinite, and then it is no norm.
  const bool isNorm = sums[EnergyError] > -1.0e-12 * std::abs(sums[EnergyNorm]);
  result.RelativeErrorEnergy =
    isNorm ? RelativeError(root(EnergyError), root(EnergyNorm), seminorm) : NotKnown;
  result.RelativeErrorInf = LargestRelativeError(mesh, values, truth, seminorm);
  result.AbsoluteErrorL2 = root(ErrorL2);
  result.AbsoluteErrorH1 = root(ErrorH1);
  result.RelativeErrorL2 = RelativeError(root(ErrorL2), root(NormL2), 0.0);
  result.RelativeErrorH1 = RelativeError(root(ErrorH1), seminorm, 0.0);
  result.ProjectedErrorL2 = RelativeError(root(ProjectedErrorL2), root(ProjectedNormL2), seminorm);
  result.ProjectedErrorH1 = RelativeError(root(ProjectedErrorH1), root(ProjectedNormH1), seminorm);
}

void SumChecks(const std::vector<ElementChecks>& elements, VirtualElementResult& result)
{
  result.WorstProjectionCondition = result.WorstGradientResidual = result.WorstValueResidual =
    result.WorstStabilisationResidual = 0.0;
  const auto raise = [](double& worst, double value)
  { worst = std::isnan(worst) || std::isnan(value) ? NotKnown : std::max(worst, value); };
  for (const ElementChecks& checks : elements)
  {
    result.ProjectionCondition.push_back(checks.Condition);
    raise(result.WorstProjectionCondition, checks.Condition);
    raise(result.WorstGradientResidual, checks.GradientResidual);
    raise(result.WorstValueResidual, checks.ValueResidual);
    raise(result.WorstStabilisationResidual, checks.StabilisationResidual);
  }
}

} // namespace

ExactValues EvaluateExactly(const DegreesOfFreedom& dofs, const EllipticProblem& problem)
{
  ExactValues exact;
  exact.Solution.assign(dofs.Points.size(), NotKnown);
  if (!problem.KnowsSolution())
  {
    return exact;
  }
  std::vector<double> slopes(dofs.Points.size());
  const auto evaluate = [&](vtkIdType first, vtkIdType last)
  {
    PointBlock points;
    TestProblemBlock block;
    for (vtkIdType start = first; start < last; start += PointBlockSize)
    {
      const std::size_t count =
        std::min<std::size_t>(PointBlockSize, static_cast<std::size_t>(last - start));
      for (std::size_t i = 0; i < PointBlockSize; ++i)
      {
        const Point2& point = dofs.Points[static_cast<std::size_t>(start) + std::min(i, count - 1)];
        points.X[i] = point.x;
        points.Y[i] = point.y;
      }
      problem.Evaluate(points, block);
      for (std::size_t i = 0; i < count; ++i)
      {
        exact.Solution[static_cast<std::size_t>(start) + i] = block.Solution[i];
        slopes[static_cast<std::size_t>(start) + i] =
          std::hypot(block.GradientX[i], block.GradientY[i]);
      }
    }
  };
  ParallelLoop(0, dofs.Size(), 0, evaluate);
  for (std::size_t i = 0; i < slopes.size(); ++i)
  {
    if (dofs.Used[i])
    {
      exact.LargestValue = std::max(exact.LargestValue, std::abs(exact.Solution[i]));
      exact.LargestSlope =
        std::isfinite(slopes[i]) ? std::max(exact.LargestSlope, slopes[i]) : exact.LargestSlope;
    }
  }
  return exact;
}

void ComputeErrors(const VirtualElementMesh& mesh, const DegreesOfFreedom& dofs,
  const VirtualElementParts& parts, const EllipticProblem& problem,
  const VirtualElementOptions& options, std::span<const double> values, const ExactValues& truth,
  SolveReport& report, VirtualElementResult& result)
{
  if (!problem.KnowsSolution() && !options.Details)
  {
    return;
  }
  ElementFindings findings;
  findings.Sums.resize(problem.KnowsSolution() ? mesh.NumberOfElements() : 0);
  findings.Checks.resize(options.Details ? mesh.NumberOfElements() : 0);
  ForElements(mesh.NumberOfElements(), report,
    ErrorWorker(mesh, dofs, parts, problem, options, values, truth, findings));
  if (problem.KnowsSolution())
  {
    SumErrors(mesh, findings.Sums, values, truth.Solution, result);
  }
  if (options.Details)
  {
    SumChecks(findings.Checks, result);
  }
}

} // namespace pemesh

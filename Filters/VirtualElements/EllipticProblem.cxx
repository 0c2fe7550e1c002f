// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EllipticProblem.h"

#include "SymbolicFormula.h"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double RoundingUnits = 32.0 * std::numeric_limits<double>::epsilon();

// The outputs of the programs, in this order.
enum CoefficientOutput : std::size_t
{
  DiffusionXX,
  DiffusionXXbyX,
  DiffusionXXbyY,
  DiffusionXY,
  DiffusionXYbyX,
  DiffusionXYbyY,
  DiffusionYY,
  DiffusionYYbyY,
  AdvectionX,
  AdvectionY,
  Reaction,
  NumberOfCoefficients
};

enum SolutionOutput : std::size_t
{
  Value,
  ValueX,
  ValueY,
  ValueXX,
  ValueXY,
  ValueYY,
  NumberOfSolutionOutputs
};

std::optional<FormulaProgram> CompileOptional(const char* what, const std::string& text)
{
  return text.empty() ? std::nullopt : std::optional(CompileFormulas({ { what, text } }));
}

BlockOfNumbers EvaluateOne(const FormulaProgram& program, const PointBlock& points)
{
  BlockOfNumbers values;
  program.Evaluate(points, { &values, 1 });
  return values;
}

PointBlock RepeatPoint(Point2 point)
{
  PointBlock points;
  points.X.fill(point.x);
  points.Y.fill(point.y);
  return points;
}

ProblemFormulas FormulasOf(const TestProblem& problem)
{
  ProblemFormulas formulas;
  formulas.Solution = problem.Evaluate ? "" : problem.Formula;
  formulas.Diffusion = problem.Diffusion;
  formulas.DiffusionXY = problem.DiffusionXY;
  formulas.DiffusionYY = problem.DiffusionYY;
  formulas.AdvectionX = problem.AdvectionX;
  formulas.AdvectionY = problem.AdvectionY;
  formulas.Reaction = problem.Reaction;
  return formulas;
}

} // namespace

struct EllipticProblem::Internals
{
  void (*Native)(const PointBlock&, TestProblemBlock&) = nullptr;
  std::optional<FormulaProgram> Solution;
  FormulaProgram Coefficients;
  std::optional<FormulaProgram> Load;
  std::optional<FormulaProgram> Dirichlet;
  std::optional<FormulaProgram> Neumann;
  std::optional<FormulaProgram> Flux;
  bool UnitDiffusion = true;
  bool TensorDiffusion = false;
  bool Advection = false;
  bool Reaction = false;

  Internals(const ProblemFormulas& formulas, void (*native)(const PointBlock&, TestProblemBlock&))
    : Native(native)
  {
    this->CompileCoefficients(formulas);
    if (const std::string& u = formulas.Solution; !u.empty())
    {
      this->Solution = CompileFormulas({ { "solution", u }, { "solution", u, Derivative::X },
        { "solution", u, Derivative::Y }, { "solution", u, Derivative::XX },
        { "solution", u, Derivative::XY }, { "solution", u, Derivative::YY } });
      this->Native = nullptr;
    }
    this->Load = CompileOptional("load", formulas.Load);
    this->Dirichlet = CompileOptional("boundary values", formulas.Dirichlet);
    this->Neumann = CompileOptional("Neumann boundary", formulas.Neumann);
    this->Flux = CompileOptional("flux", formulas.Flux);
    this->CheckTensor();
    if (!this->KnowsSolution() && (!this->Load || !this->Dirichlet))
    {
      throw std::runtime_error("A problem without a solution needs the formulas of the load and of "
                               "the boundary values.");
    }
  }

  void CompileCoefficients(const ProblemFormulas& formulas)
  {
    const auto text = [](const std::string& formula, const char* standard)
    { return formula.empty() ? std::string(standard) : formula; };
    const std::string kappa = text(formulas.Diffusion, "1");
    const std::string kappaXY = text(formulas.DiffusionXY, "0");
    const std::string kappaYY = text(formulas.DiffusionYY, kappa.c_str());
    this->Coefficients =
      CompileFormulas({ { "diffusion", kappa }, { "diffusion", kappa, Derivative::X },
        { "diffusion", kappa, Derivative::Y }, { "diffusion xy", kappaXY },
        { "diffusion xy", kappaXY, Derivative::X }, { "diffusion xy", kappaXY, Derivative::Y },
        { "diffusion yy", kappaYY }, { "diffusion yy", kappaYY, Derivative::Y },
        { "advection in x", text(formulas.AdvectionX, "0") },
        { "advection in y", text(formulas.AdvectionY, "0") },
        { "reaction", text(formulas.Reaction, "0") } });
    this->TensorDiffusion = !formulas.DiffusionXY.empty() || !formulas.DiffusionYY.empty();
    this->UnitDiffusion = !this->TensorDiffusion && this->Coefficients.IsConstant(DiffusionXX, 1.0);
    this->Advection = !this->Coefficients.IsConstant(pemesh::AdvectionX, 0.0) ||
      !this->Coefficients.IsConstant(pemesh::AdvectionY, 0.0);
    this->Reaction = !this->Coefficients.IsConstant(pemesh::Reaction, 0.0);
  }

  void CheckTensor() const
  {
    if (this->TensorDiffusion && this->Native && !this->Load)
    {
      throw std::runtime_error("The source that belongs to this test problem is not known for a "
                               "diffusion that is a tensor: give the solution as a formula.");
    }
  }

  bool KnowsSolution() const { return this->Native || this->Solution; }
  bool IsPoisson() const { return this->UnitDiffusion && !this->Advection && !this->Reaction; }

  // -Laplace u takes the place of the source; `size` is the sum of the terms' absolute values.
  void EvaluateSolution(
    const PointBlock& points, TestProblemBlock& values, BlockOfNumbers& size) const
  {
    if (this->Native)
    {
      this->Native(points, values);
      for (std::size_t i = 0; i < PointBlockSize; ++i)
      {
        size[i] = std::abs(values.Source[i]);
      }
      return;
    }
    std::array<BlockOfNumbers, NumberOfSolutionOutputs> outputs;
    this->Solution->Evaluate(points, outputs);
    values.Solution = outputs[Value];
    values.GradientX = outputs[ValueX];
    values.GradientY = outputs[ValueY];
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      values.Source[i] = -(outputs[ValueXX][i] + outputs[ValueYY][i]);
      size[i] = std::abs(outputs[ValueXX][i]) + std::abs(outputs[ValueYY][i]);
    }
  }

  // Turns -Laplace u into f.
  void AddCoefficients(
    const PointBlock& points, TestProblemBlock& values, BlockOfNumbers& size) const
  {
    std::array<BlockOfNumbers, NumberOfCoefficients> c;
    this->Coefficients.Evaluate(points, c);
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      const double kappa = c[DiffusionXX][i];
      const double x = (c[pemesh::AdvectionX][i] - c[DiffusionXXbyX][i]) * values.GradientX[i];
      const double y = (c[pemesh::AdvectionY][i] - c[DiffusionXXbyY][i]) * values.GradientY[i];
      const double r = c[pemesh::Reaction][i] * values.Solution[i];
      values.Source[i] = kappa * values.Source[i] + x + y + r;
      size[i] = std::abs(kappa) * size[i] + std::abs(x) + std::abs(y) + std::abs(r);
    }
  }

  // Everything at once: with a tensor -Laplace u is of no use.
  void EvaluateWithTensor(
    const PointBlock& points, TestProblemBlock& values, BlockOfNumbers& size) const
  {
    std::array<BlockOfNumbers, NumberOfSolutionOutputs> u;
    std::array<BlockOfNumbers, NumberOfCoefficients> c;
    this->Solution->Evaluate(points, u);
    this->Coefficients.Evaluate(points, c);
    values.Solution = u[Value];
    values.GradientX = u[ValueX];
    values.GradientY = u[ValueY];
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      const double driftX = c[pemesh::AdvectionX][i] - c[DiffusionXXbyX][i] - c[DiffusionXYbyY][i];
      const double driftY = c[pemesh::AdvectionY][i] - c[DiffusionXYbyX][i] - c[DiffusionYYbyY][i];
      const std::array<double, 6> terms{ -c[DiffusionXX][i] * u[ValueXX][i],
        -2.0 * c[DiffusionXY][i] * u[ValueXY][i], -c[DiffusionYY][i] * u[ValueYY][i],
        driftX * u[ValueX][i], driftY * u[ValueY][i], c[pemesh::Reaction][i] * u[Value][i] };
      values.Source[i] = size[i] = 0.0;
      for (const double term : terms)
      {
        values.Source[i] += term;
        size[i] += std::abs(term);
      }
    }
  }

  void Evaluate(const PointBlock& points, TestProblemBlock& values, BlockOfNumbers& size) const
  {
    if (this->TensorDiffusion && this->Solution)
    {
      this->EvaluateWithTensor(points, values, size);
    }
    else if (this->KnowsSolution())
    {
      this->EvaluateSolution(points, values, size);
      if (!this->Load && !this->IsPoisson())
      {
        this->AddCoefficients(points, values, size);
      }
    }
    else
    {
      values.Solution.fill(NotKnown);
      values.GradientX.fill(NotKnown);
      values.GradientY.fill(NotKnown);
    }
    if (this->Load)
    {
      values.Source = EvaluateOne(*this->Load, points);
      size = values.Source;
    }
  }
};

EllipticProblem::EllipticProblem(const TestProblem& problem)
  : Parts(std::make_shared<const Internals>(FormulasOf(problem), problem.Evaluate))
{
}

EllipticProblem::EllipticProblem(const ProblemFormulas& formulas, const TestProblem* base)
{
  ProblemFormulas all = formulas;
  if (base)
  {
    const ProblemFormulas standard = FormulasOf(*base);
    for (const auto field : { &ProblemFormulas::Solution, &ProblemFormulas::Diffusion,
           &ProblemFormulas::DiffusionXY, &ProblemFormulas::DiffusionYY,
           &ProblemFormulas::AdvectionX, &ProblemFormulas::AdvectionY, &ProblemFormulas::Reaction })
    {
      all.*field = (all.*field).empty() ? standard.*field : all.*field;
    }
  }
  this->Parts = std::make_shared<const Internals>(all, base ? base->Evaluate : nullptr);
}

bool EllipticProblem::KnowsSolution() const
{
  return this->Parts->KnowsSolution();
}

bool EllipticProblem::IsPoisson() const
{
  return this->Parts->IsPoisson();
}

bool EllipticProblem::HasTensorDiffusion() const
{
  return this->Parts->TensorDiffusion;
}

bool EllipticProblem::HasAdvection() const
{
  return this->Parts->Advection;
}

bool EllipticProblem::HasReaction() const
{
  return this->Parts->Reaction;
}

bool EllipticProblem::HasNeumannEdges() const
{
  return this->Parts->Neumann.has_value();
}

bool EllipticProblem::IsSmooth() const
{
  const auto isSmooth = [](const std::optional<FormulaProgram>& program)
  { return !program || program->IsSmooth(); };
  return this->Parts->Coefficients.IsSmooth() && isSmooth(this->Parts->Solution) &&
    isSmooth(this->Parts->Load);
}

void EllipticProblem::Evaluate(const PointBlock& points, TestProblemBlock& values) const
{
  BlockOfNumbers size;
  this->Parts->Evaluate(points, values, size);
}

void EllipticProblem::EvaluateSource(const PointBlock& points, SourceBlock& values) const
{
  TestProblemBlock all;
  this->Parts->Evaluate(points, all, values.Uncertainty);
  values.Source = all.Source;
  for (double& size : values.Uncertainty)
  {
    size = RoundingUnits * std::abs(size);
  }
}

void EllipticProblem::EvaluateCoefficients(const PointBlock& points, CoefficientBlock& values) const
{
  std::array<BlockOfNumbers, NumberOfCoefficients> c;
  this->Parts->Coefficients.Evaluate(points, c);
  values = { c[DiffusionXX], c[DiffusionXY], c[DiffusionYY], c[pemesh::AdvectionX],
    c[pemesh::AdvectionY], c[pemesh::Reaction] };
}

double EllipticProblem::Solution(Point2 point) const
{
  TestProblemBlock block;
  this->Evaluate(RepeatPoint(point), block);
  return block.Solution[0];
}

Point2 EllipticProblem::Gradient(Point2 point) const
{
  TestProblemBlock block;
  this->Evaluate(RepeatPoint(point), block);
  return { block.GradientX[0], block.GradientY[0] };
}

double EllipticProblem::Source(Point2 point) const
{
  TestProblemBlock block;
  this->Evaluate(RepeatPoint(point), block);
  return block.Source[0];
}

DiffusionTensor EllipticProblem::Diffusion(Point2 point) const
{
  CoefficientBlock block;
  this->EvaluateCoefficients(RepeatPoint(point), block);
  return { block.DiffusionXX[0], block.DiffusionXY[0], block.DiffusionYY[0] };
}

double EllipticProblem::BoundaryValue(Point2 point) const
{
  return this->Parts->Dirichlet ? EvaluateOne(*this->Parts->Dirichlet, RepeatPoint(point))[0]
                                : this->Solution(point);
}

bool EllipticProblem::IsNeumann(Point2 point) const
{
  return this->Parts->Neumann && EvaluateOne(*this->Parts->Neumann, RepeatPoint(point))[0] > 0.0;
}

double EllipticProblem::Flux(Point2 point, Point2 normal) const
{
  if (this->Parts->Flux)
  {
    return EvaluateOne(*this->Parts->Flux, RepeatPoint(point))[0];
  }
  if (!this->KnowsSolution())
  {
    return 0.0;
  }
  const Point2 gradient = this->Gradient(point);
  const DiffusionTensor kappa = this->Diffusion(point);
  return normal.x * (kappa.XX * gradient.x + kappa.XY * gradient.y) +
    normal.y * (kappa.XY * gradient.x + kappa.YY * gradient.y);
}

} // namespace pemesh

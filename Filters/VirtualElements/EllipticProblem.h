// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A problem as the solver sees it:
 *   -div(kappa grad u) + beta . grad u + c u = f  in the domain,
 *   u given on the boundary, or kappa du/dn on the part where the Neumann formula is positive.
 *
 * Made from an entry of the table of test problems or from formulas of x and y. Where u is known,
 * f and the data on the boundary are derived from it, unless they are given. Immutable; any number
 * of threads may use one.
 */
#ifndef pemesh_EllipticProblem_h
#define pemesh_EllipticProblem_h

#include "Point2.h"
#include "TestProblems.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <memory>
#include <string>

namespace pemesh
{

/** Formulas of x and y; an empty one is not given. */
struct ProblemFormulas
{
  std::string Solution;  ///< u
  std::string Diffusion; ///< kappa > 0, default 1; of a tensor kappa_xx
  ///@{
  /** The rest of a tensor, symmetric and positive definite; where both are empty kappa is none. */
  std::string DiffusionXY; ///< default 0
  std::string DiffusionYY; ///< default that of kappa_xx
  ///@}
  std::string AdvectionX; ///< beta, default 0
  std::string AdvectionY;
  std::string Reaction;  ///< c, default 0
  std::string Load;      ///< f; needed where there is no solution
  std::string Dirichlet; ///< u on the boundary; needed where there is no solution
  std::string Neumann;   ///< kappa du/dn is given on the edges at whose midpoints this is positive
  std::string Flux;      ///< kappa du/dn; derived, or 0 where there is no solution
};

struct DiffusionTensor
{
  double XX = 1.0;
  double XY = 0.0;
  double YY = 1.0;
};

struct CoefficientBlock
{
  BlockOfNumbers DiffusionXX; ///< kappa itself where it is no tensor
  BlockOfNumbers DiffusionXY;
  BlockOfNumbers DiffusionYY;
  BlockOfNumbers AdvectionX;
  BlockOfNumbers AdvectionY;
  BlockOfNumbers Reaction;
};

struct SourceBlock
{
  BlockOfNumbers Source;      ///< f
  BlockOfNumbers Uncertainty; ///< what rounding may do to it, where its terms cancel
};

class PEMESHFILTERSVIRTUALELEMENTS_EXPORT EllipticProblem
{
public:
  /** An entry of the table is a problem. */
  EllipticProblem(const TestProblem& problem); // NOLINT: a conversion on purpose

  /**
   * Formulas; those that are empty are taken from `base`, if there is one. Throws
   * std::runtime_error, one sentence that names the formula and the position of what is wrong.
   */
  explicit EllipticProblem(const ProblemFormulas& formulas, const TestProblem* base = nullptr);

  bool KnowsSolution() const;
  bool IsPoisson() const; ///< kappa = 1, no advection, no reaction
  bool HasTensorDiffusion() const;
  bool HasAdvection() const; ///< so that the system is not symmetric
  bool HasReaction() const;
  bool HasNeumannEdges() const;
  bool IsSmooth() const; ///< no formula calls a function with a jump or a kink

  /** u, its gradient, f. NaN for what is not known. */
  void Evaluate(const PointBlock& points, TestProblemBlock& values) const;
  void EvaluateSource(const PointBlock& points, SourceBlock& values) const;
  void EvaluateCoefficients(const PointBlock& points, CoefficientBlock& values) const;

  ///@{
  /** At one point. */
  double Solution(Point2 point) const;
  Point2 Gradient(Point2 point) const;
  double Source(Point2 point) const;
  DiffusionTensor Diffusion(Point2 point) const;
  double BoundaryValue(Point2 point) const;
  bool IsNeumann(Point2 point) const;
  double Flux(Point2 point, Point2 normal) const; ///< n . kappa grad u, `normal` of length one
  ///@}

private:
  struct Internals;
  std::shared_ptr<const Internals> Parts;
};

} // namespace pemesh

#endif

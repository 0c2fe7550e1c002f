// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The virtual element method of order 1 … 6 for
 *   -div(kappa grad u) + beta . grad u + c u = f
 * on a polygonal mesh; see ElementMatrices.h for the method on an element and EllipticProblem.h for
 * the data.
 *
 * Integrals of f and of the errors are taken over a triangulation of each element, to a relative
 * 1e-10 where the functions are smooth on the scale of its triangles; where a formula has jumps or
 * kinks, triangles are cut at least once, and up to 1e-2 of one that a jump crosses is left. What
 * is narrower than a tenth of a triangle may not be seen at all (Quadrature.h). Polynomials are
 * integrated exactly, coefficients by a rule of degree 2k
 * + 8. Vertices in the middle of a side of an element are vertices like all others; the edges of
 * one element are the boundary. Elements are treated in parallel with vtkSMPTools, every result in
 * a slot of its own, sums in the order of the elements: the same bits with any number of threads.
 */
#ifndef pemesh_VirtualElementMethod_h
#define pemesh_VirtualElementMethod_h

#include "VirtualElementOptions.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <exception>
#include <functional>
#include <span>
#include <vector>

class vtkPolyData;

namespace pemesh
{

class EllipticProblem;

struct VirtualElementResult
{
  ///@{
  /**
   * One number a vertex of the mesh; a vertex that no element uses has the exact solution, or NaN.
   * No ground truth where the solution is not known.
   */
  std::vector<double> Solution;
  std::vector<double> GroundTruth;
  ///@}

  ///@{
  /**
   * One number an element: the L2 norm and the H1 seminorm of u - Pi u_h, whose squares add up to
   * those of the absolute errors below, and, with the option Details, the condition number of the
   * gradient projection's matrix. Empty where not known.
   */
  std::vector<double> ErrorL2;
  std::vector<double> ErrorH1;
  std::vector<double> ProjectionCondition;
  ///@}

  double DegreesOfFreedom = 0.0; ///< unknowns of the system: those inside elements are eliminated
  double MeshSize = 0.0;         ///< largest diameter of an element

  ///@{
  /**
   * In the 1-norm, of the system's matrix: from order 2 on that is the Schur complement which
   * elimination of the moments leaves. Exact below 500 unknowns, else a lower bound, seldom more
   * than a few per cent below, and ConditionIsEstimate is 1. NaN, both, if Iterative is 1, because
   * then there is no factor.
   */
  double ConditionNumber = 0.0;
  double ConditionIsEstimate = 0.0;
  double Iterative = 0.0;
  ///@}

  ///@{
  /**
   * With K the matrix on all degrees of freedom, e = u - u_h in these, Pi the gradient projection:
   * sqrt(e^T K e / u^T K u), max |e| / max |u| at the vertices, and the L2 norm and the H1 seminorm
   * of u - Pi u_h, over those of u and absolute, and of Pi (u - u_h) over those of Pi u. NaN where
   * the denominator vanishes (the first two when u is zero, or constant, at all vertices), e^T K e
   * is negative, as a negative reaction may make it, or u is not known.
   */
  double RelativeErrorEnergy = 0.0;
  double RelativeErrorInf = 0.0;
  double RelativeErrorL2 = 0.0;
  double RelativeErrorH1 = 0.0;
  double AbsoluteErrorL2 = 0.0;
  double AbsoluteErrorH1 = 0.0;
  double ProjectedErrorL2 = 0.0;
  double ProjectedErrorH1 = 0.0;
  ///@}

  double Nonzeros = 0.0;        ///< entries of the system's matrix
  double AssemblySeconds = 0.0; ///< wall time of element matrices and assembly
  double SolveSeconds = 0.0;    ///< wall time of factorising and solving
  double MemoryMegabytes = 0.0; ///< the most that the process has used so far

  ///@{
  /** With the option Details, else NaN. */
  double SpectralConditionNumber = 0.0; ///< 2-norm; if solved by iteration, a lower bound
  double WorstProjectionCondition = 0.0;
  double WorstGradientResidual = 0.0; ///< see ElementChecks
  double WorstValueResidual = 0.0;
  double WorstStabilisationResidual = 0.0;
  /** Of conjugate gradients to 1e-8; NaN with advection, or where they do not converge. */
  double CgIterations = 0.0;
  double CgIterationsJacobi = 0.0;
  double CgIterationsCholesky = 0.0; ///< incomplete, without fill
  ///@}
};

/** No arrays, and NaN for all performances. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT VirtualElementResult UndefinedVirtualElementResult();

/**
 * Told between the parts of a run, and about ten times a second within most of them, the fraction
 * done; false ends it with SolveAborted. A factorisation, complete or not, cannot be interrupted: a
 * program that must be able to end at any time runs pemesh-vem.
 */
using SolveProgress = std::function<bool(double fraction)>;

class SolveAborted : public std::exception
{
};

/**
 * Throws std::runtime_error with one sentence where there is nothing to solve or the system cannot
 * be solved in double precision.
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT VirtualElementResult SolveElliptic(vtkPolyData* mesh,
  const EllipticProblem& problem, const VirtualElementOptions& options = {},
  const SolveProgress& progress = {});

/** A number that a run of the solver reports; the table names the files and the help. */
struct VirtualElementPerformance
{
  const char* Name;
  const char* Label;
  bool Logarithmic; ///< best shown on a logarithmic axis
  bool Measured;    ///< differs from run to run and machine to machine
  bool Detail;      ///< NaN without the option Details
  double VirtualElementResult::*Value;
};

PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const VirtualElementPerformance>
VirtualElementPerformances();

/** An array with one number an element that a run reports. */
struct VirtualElementArray
{
  const char* Name; ///< of the file and the array
  const char* Label;
  std::vector<double> VirtualElementResult::*Values;
};

PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const VirtualElementArray> VirtualElementArrays();

} // namespace pemesh

#endif

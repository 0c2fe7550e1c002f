// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The lowest-order virtual element method for -Laplace u = f on a polygonal mesh, u given on the
 * boundary; see VirtualElementMethodElement.h for the method on an element.
 *
 * Integrals of f and of the errors are taken over a triangulation of each element, to a relative
 * 1e-10 (Quadrature.h). Elements are treated in parallel with vtkSMPTools, every result in a slot
 * of its own, sums in the order of the elements: the same bits with any number of threads.
 */
#ifndef pemesh_VirtualElementMethod_h
#define pemesh_VirtualElementMethod_h

#include "VirtualElementMethodElement.h"
#include "pemeshFiltersSolversModule.h" // For export macro

#include <span>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace pemesh
{

struct TestProblem;

/** The test functions that f is integrated against. */
enum class LoadProjection
{
  Mean,    ///< the mean of the projected basis function ("pi0")
  Gradient ///< the projected basis function itself ("pinabla")
};

struct VirtualElementOptions
{
  ProjectionConstant Constant = ProjectionConstant::BoundaryMean;
  LoadProjection Load = LoadProjection::Mean;
};

struct VirtualElementResult
{
  ///@{
  /** One number a vertex of the mesh; a vertex that no element uses has the exact solution. */
  std::vector<double> Solution;
  std::vector<double> GroundTruth;
  ///@}

  double DegreesOfFreedom = 0.0; ///< unknowns: vertices inside
  double MeshSize = 0.0;         ///< largest diameter of an element
  double ConditionNumber = 0.0;  ///< 1-norm, of the stiffness matrix on the vertices inside
  bool ConditionNumberIsExact = true;

  ///@{
  /**
   * With K the stiffness matrix on all vertices, e = u - u_h at the vertices, Pi the projection:
   * sqrt(e^T K e / u^T K u), max |e| / max |u|, and the L2 norm and the H1 seminorm of u - Pi u_h
   * over those of u. NaN where the denominator vanishes: the first two when u is zero, or
   * constant, at all vertices.
   */
  double RelativeErrorEnergy = 0.0;
  double RelativeErrorInf = 0.0;
  double RelativeErrorL2 = 0.0;
  double RelativeErrorH1 = 0.0;
  ///@}

  double SolveSeconds = 0.0; ///< wall time of factorising and solving
};

/**
 * Throws std::runtime_error with one sentence where there is nothing to solve or the system
 * cannot be solved in double precision.
 */
PEMESHFILTERSSOLVERS_EXPORT VirtualElementResult SolvePoisson(
  vtkPolyData* mesh, const TestProblem& problem, const VirtualElementOptions& options = {});

/** A number that a run of the solver reports; the table names the files and the help. */
struct VirtualElementPerformance
{
  const char* Name;
  const char* Label;
  bool Logarithmic; ///< best shown on a logarithmic axis
  bool Measured;    ///< differs from run to run and machine to machine
  double VirtualElementResult::*Value;
};

PEMESHFILTERSSOLVERS_EXPORT std::span<const VirtualElementPerformance> VirtualElementPerformances();

} // namespace pemesh

#endif

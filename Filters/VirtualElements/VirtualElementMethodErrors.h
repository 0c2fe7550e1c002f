// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What is known of a virtual element solution element by element: the moments inside, the errors
 * where the exact solution is known, the checks of the matrices. Private to the module.
 */
#ifndef pemesh_VirtualElementMethodErrors_h
#define pemesh_VirtualElementMethodErrors_h

#include "VirtualElementMethodSystem.h"

namespace pemesh
{

/** The exact solution at all degrees of freedom that have a point, NaN where it is not known. */
struct ExactValues
{
  std::vector<double> Solution;
  double LargestValue = 0.0; ///< of |u| where elements are
  double LargestSlope = 0.0; ///< of |grad u| there, singular corners left out
};

ExactValues EvaluateExactly(const DegreesOfFreedom& dofs, const EllipticProblem& problem);

/**
 * Fills the errors of `result`, its arrays of the elements and, with the option Details, the
 * checks. `values` belong to the degrees of freedom.
 */
void ComputeErrors(const VirtualElementMesh& mesh, const DegreesOfFreedom& dofs,
  const VirtualElementParts& parts, const EllipticProblem& problem,
  const VirtualElementOptions& options, std::span<const double> values, const ExactValues& truth,
  SolveReport& report, VirtualElementResult& result);

} // namespace pemesh

#endif

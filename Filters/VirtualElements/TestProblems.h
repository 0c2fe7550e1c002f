// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The problems that the bundled solver brings along:
 *   -div(kappa grad u) + beta . grad u + c u = f  with u known everywhere.
 *
 * One entry of the table in TestProblems.cxx is one problem; the solver, the command line, the
 * shell and the help read the table. A new problem is a line there: its formulas, from which f is
 * derived, or, where speed counts, a function.
 */
#ifndef pemesh_TestProblems_h
#define pemesh_TestProblems_h

#include "PointBlock.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <span>
#include <string_view>

namespace pemesh
{

/** u, its gradient, and the source. Together, because they share much. */
struct TestProblemBlock
{
  BlockOfNumbers Solution;
  BlockOfNumbers GradientX;
  BlockOfNumbers GradientY;
  BlockOfNumbers Source; ///< of a function of the table: -Laplace u; else f
};

struct TestProblem
{
  const char* Name;    ///< as in files and on the command line
  const char* Label;   ///< as shown to people
  const char* Formula; ///< of the solution u

  /** u, its gradient and -Laplace u; null where they are to be derived from the formula. */
  void (*Evaluate)(const PointBlock& points, TestProblemBlock& values) = nullptr;

  ///@{
  /** Formulas of the coefficients. */
  const char* Diffusion = "1";
  const char* AdvectionX = "0";
  const char* AdvectionY = "0";
  const char* Reaction = "0";
  const char* DiffusionXY = ""; ///< of a tensor; else empty, as the next one
  const char* DiffusionYY = "";
  ///@}
};

PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const TestProblem> TestProblems();

/** Null where there is none of this name. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT const TestProblem* FindTestProblem(std::string_view name);

} // namespace pemesh

#endif

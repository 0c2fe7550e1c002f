// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The test problems of the bundled solver: -Laplace u = f with u known everywhere.
 *
 * One entry of the table in TestProblems.cxx is one problem; the solver, the command line, the
 * shell and the help read the table. A new problem is a function and a line there.
 */
#ifndef pemesh_TestProblems_h
#define pemesh_TestProblems_h

#include "Point2.h"
#include "pemeshFiltersSolversModule.h" // For export macro

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace pemesh
{

/** Problems are evaluated at several points at once, which lets the processor do so too. */
inline constexpr std::size_t PointBlockSize = 8;
using BlockOfNumbers = std::array<double, PointBlockSize>;

struct PointBlock
{
  BlockOfNumbers X{};
  BlockOfNumbers Y{};
};

/** u, its gradient, and f = -Laplace u. Together, because they share much. */
struct TestProblemBlock
{
  BlockOfNumbers Solution;
  BlockOfNumbers GradientX;
  BlockOfNumbers GradientY;
  BlockOfNumbers Source;
};

struct PEMESHFILTERSSOLVERS_EXPORT TestProblem
{
  const char* Name;    ///< as in files and on the command line
  const char* Label;   ///< as shown to people
  const char* Formula; ///< of the solution u
  void (*Evaluate)(const PointBlock& points, TestProblemBlock& values);

  ///@{
  /** At one point. */
  double Solution(Point2 point) const;
  Point2 Gradient(Point2 point) const;
  double Source(Point2 point) const;
  ///@}
};

PEMESHFILTERSSOLVERS_EXPORT std::span<const TestProblem> TestProblems();

/** Null where there is none of this name. */
PEMESHFILTERSSOLVERS_EXPORT const TestProblem* FindTestProblem(std::string_view name);

} // namespace pemesh

#endif

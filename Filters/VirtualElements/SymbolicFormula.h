// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Formulas as people write them, read and differentiated by GiNaC (C. Bauer, A. Frink, R. Kreckel,
 * J. Symb. Comput. 33 (2002) 1-12). Private to the module.
 *
 * GiNaC's expressions share parts without locks: the functions here take turns, and hand out
 * nothing of GiNaC.
 */
#ifndef pemesh_SymbolicFormula_h
#define pemesh_SymbolicFormula_h

#include "FormulaProgram.h"

#include <string>
#include <vector>

namespace pemesh
{

/** What to make of a formula. */
enum class Derivative
{
  None,
  X,
  Y,
  XX,
  XY,
  YY
};

struct WantedFormula
{
  std::string What; ///< what it is called in messages: "solution"
  std::string Text;
  Derivative Of = Derivative::None;
};

/**
 * A program whose outputs are the formulas, in this order. Throws std::runtime_error, one sentence
 * that names the formula and the position of what is wrong.
 */
FormulaProgram CompileFormulas(const std::vector<WantedFormula>& formulas);

} // namespace pemesh

#endif

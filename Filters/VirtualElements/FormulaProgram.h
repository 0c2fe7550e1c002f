// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Formulas of x and y made into a list of operations on blocks of points, shared among formulas
 * that have parts in common. Immutable once made; any number of threads may evaluate it. Private to
 * the module.
 */
#ifndef pemesh_FormulaProgram_h
#define pemesh_FormulaProgram_h

#include "PointBlock.h"

#include <span>
#include <string_view>
#include <vector>

namespace pemesh
{

/** A function of one number that formulas may call. */
struct FormulaFunction
{
  const char* Name;
  double (*Function)(double);
  bool Smooth = true; ///< where it is defined
};

std::span<const FormulaFunction> FormulaFunctions();

class FormulaProgram
{
public:
  enum class Operation
  {
    Constant,
    X,
    Y,
    Add,
    Multiply,
    IntegerPower, ///< of First, to the power Number
    Power,
    ArcTangent, ///< of First / Second, in the quadrant of (Second, First)
    Call        ///< Functions[Second] of First
  };

  struct Step
  {
    Operation What;
    int First = 0;
    int Second = 0;
    double Number = 0.0;
  };

  /** Appends a step and answers its number, which later steps refer to. */
  int Append(const Step& step);
  void AddOutput(int step) { this->Outputs.push_back(step); }

  std::size_t NumberOfOutputs() const { return this->Outputs.size(); }
  bool IsConstant(std::size_t output, double value) const;
  /** Whether the output does not depend on the place. */
  bool IsConstant(std::size_t output) const;

  /** Whether no function with a jump or a kink is called. */
  bool IsSmooth() const;

  void Evaluate(const PointBlock& points, std::span<BlockOfNumbers> outputs) const;

private:
  std::vector<Step> Steps;
  std::vector<int> Outputs;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FormulaProgram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr std::array Functions = {
  FormulaFunction{ "sin", [](double v) { return std::sin(v); } },
  FormulaFunction{ "cos", [](double v) { return std::cos(v); } },
  FormulaFunction{ "tan", [](double v) { return std::tan(v); } },
  FormulaFunction{ "asin", [](double v) { return std::asin(v); } },
  FormulaFunction{ "acos", [](double v) { return std::acos(v); } },
  FormulaFunction{ "atan", [](double v) { return std::atan(v); } },
  FormulaFunction{ "sinh", [](double v) { return std::sinh(v); } },
  FormulaFunction{ "cosh", [](double v) { return std::cosh(v); } },
  FormulaFunction{ "tanh", [](double v) { return std::tanh(v); } },
  FormulaFunction{ "asinh", [](double v) { return std::asinh(v); } },
  FormulaFunction{ "acosh", [](double v) { return std::acosh(v); } },
  FormulaFunction{ "atanh", [](double v) { return std::atanh(v); } },
  FormulaFunction{ "exp", [](double v) { return std::exp(v); } },
  FormulaFunction{ "log", [](double v) { return std::log(v); } },
  FormulaFunction{ "abs", [](double v) { return std::abs(v); }, false },
  FormulaFunction{ "step", [](double v) { return v < 0.0 ? 0.0
                                            : v > 0.0    ? 1.0
                                                         : 0.5; }, false },
};

double IntegerPower(double base, double power)
{
  double result = 1.0;
  double square = power < 0.0 ? 1.0 / base : base;
  for (auto rest = static_cast<unsigned long>(std::abs(power)); rest != 0; rest >>= 1)
  {
    result *= rest & 1 ? square : 1.0;
    square *= square;
  }
  return result;
}

void Apply(const FormulaProgram::Step& step, const PointBlock& points,
  const std::vector<BlockOfNumbers>& values, BlockOfNumbers& result)
{
  using Operation = FormulaProgram::Operation;
  const BlockOfNumbers& a = values[static_cast<std::size_t>(step.First)];
  const BlockOfNumbers& b = values[static_cast<std::size_t>(step.Second)];
  const auto each = [&result](const auto& function)
  {
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      result[i] = function(i);
    }
  };
  switch (step.What)
  {
    case Operation::Constant:
      return result.fill(step.Number);
    case Operation::X:
      result = points.X;
      return;
    case Operation::Y:
      result = points.Y;
      return;
    case Operation::Add:
      return each([&](std::size_t i) { return a[i] + b[i]; });
    case Operation::Multiply:
      return each([&](std::size_t i) { return a[i] * b[i]; });
    case Operation::IntegerPower:
      return each([&](std::size_t i) { return IntegerPower(a[i], step.Number); });
    case Operation::Power:
      return each([&](std::size_t i) { return std::pow(a[i], b[i]); });
    case Operation::ArcTangent:
      return each([&](std::size_t i) { return std::atan2(a[i], b[i]); });
    case Operation::Call:
      return each([&, function = Functions[static_cast<std::size_t>(step.Second)].Function](
                    std::size_t i) { return function(a[i]); });
  }
}

} // namespace

std::span<const FormulaFunction> FormulaFunctions()
{
  return Functions;
}

int FormulaProgram::Append(const Step& step)
{
  this->Steps.push_back(step);
  return static_cast<int>(this->Steps.size()) - 1;
}

bool FormulaProgram::IsConstant(std::size_t output) const
{
  return this->Steps[static_cast<std::size_t>(this->Outputs[output])].What == Operation::Constant;
}

bool FormulaProgram::IsConstant(std::size_t output, double value) const
{
  return this->IsConstant(output) &&
    this->Steps[static_cast<std::size_t>(this->Outputs[output])].Number == value;
}

bool FormulaProgram::IsSmooth() const
{
  return std::none_of(this->Steps.begin(), this->Steps.end(),
    [](const Step& step)
    {
      return step.What == Operation::Call &&
        !Functions[static_cast<std::size_t>(step.Second)].Smooth;
    });
}

void FormulaProgram::Evaluate(const PointBlock& points, std::span<BlockOfNumbers> outputs) const
{
  thread_local std::vector<BlockOfNumbers> values;
  // The second operand of a call is the number of a function, not a step.
  values.resize(std::max({ values.size(), this->Steps.size(), Functions.size() }));
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    Apply(this->Steps[i], points, values, values[i]);
  }
  for (std::size_t i = 0; i < this->Outputs.size(); ++i)
  {
    outputs[i] = values[static_cast<std::size_t>(this->Outputs[i])];
  }
}

} // namespace pemesh

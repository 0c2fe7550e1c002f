// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SymbolicFormula.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string_view>

namespace pemesh
{

namespace
{

std::mutex GinacMutex;

// The symbols are the same for all formulas, so that these can share parts.
const GiNaC::realsymbol& SymbolX()
{
  static const GiNaC::realsymbol symbol("x");
  return symbol;
}

const GiNaC::realsymbol& SymbolY()
{
  static const GiNaC::realsymbol symbol("y");
  return symbol;
}

[[noreturn]] void Complain(const WantedFormula& formula, const std::string& reason)
{
  throw std::runtime_error(
    "The formula of the " + formula.What + ", \"" + formula.Text + "\", " + reason);
}

bool IsNameCharacter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool IsKnownName(std::string_view name)
{
  constexpr std::string_view more[] = { "x", "y", "pi", "Pi", "sqrt", "pow", "atan2" };
  const auto functions = FormulaFunctions();
  return std::find(std::begin(more), std::end(more), name) != std::end(more) ||
    std::any_of(functions.begin(), functions.end(),
      [name](const FormulaFunction& function) { return name == function.Name; });
}

// GiNaC does not say where a name is that it does not know.
void CheckNames(const WantedFormula& formula)
{
  const std::string& text = formula.Text;
  for (std::size_t first = 0; first < text.size();)
  {
    std::size_t last = first;
    while (last < text.size() && IsNameCharacter(text[last]))
    {
      ++last;
    }
    const std::string name = text.substr(first, last - first);
    const bool isName = !name.empty() && !(name[0] >= '0' && name[0] <= '9');
    if (isName && !IsKnownName(name))
    {
      Complain(formula,
        "has at position " + std::to_string(first + 1) + " the name \"" + name +
          "\", which means nothing: there are x, y, pi and functions such as sin, exp, sqrt, "
          "atan2.");
    }
    first = std::max(last, first + 1);
  }
}

// GiNaC says "parse error at line 0, column 7: expected … got: EOF" and more lines on itself; the
// column of an end is not set.
std::string PlaceAndReason(const GiNaC::parse_error& error, std::size_t length)
{
  std::string reason = error.what();
  reason = reason.substr(0, reason.find('\n'));
  const std::size_t column = reason.find("column ");
  const std::size_t colon = reason.find(": ", column);
  reason =
    column == std::string::npos || colon == std::string::npos ? reason : reason.substr(colon + 2);
  const bool atEnd = reason.find("EOF") != std::string::npos;
  return "at position " + std::to_string(atEnd ? length + 1 : error.column + 1) + ": " + reason;
}

GiNaC::ex Parse(const WantedFormula& formula)
{
  GiNaC::symtab names{ { "x", SymbolX() }, { "y", SymbolY() }, { "pi", GiNaC::Pi } };
  GiNaC::parser reader(names, true);
  if (formula.Text.find_first_not_of(" \t") == std::string::npos)
  {
    Complain(formula, "is empty.");
  }
  CheckNames(formula);
  try
  {
    return reader(formula.Text);
  }
  catch (const GiNaC::parse_error& error)
  {
    Complain(formula,
      "cannot be read " + PlaceAndReason(error, formula.Text.size()) +
        ". It may use x, y, pi, numbers, + - * / ^ and functions such as sin, exp, sqrt, atan2.");
  }
  catch (const std::exception& error)
  {
    Complain(formula, std::string("cannot be read: ") + error.what() + ".");
  }
}

GiNaC::ex Differentiate(const GiNaC::ex& formula, Derivative what)
{
  switch (what)
  {
    case Derivative::None:
      return formula;
    case Derivative::X:
      return formula.diff(SymbolX());
    case Derivative::Y:
      return formula.diff(SymbolY());
    case Derivative::XX:
      return formula.diff(SymbolX(), 2);
    case Derivative::XY:
      return formula.diff(SymbolX()).diff(SymbolY());
    case Derivative::YY:
      return formula.diff(SymbolY(), 2);
  }
  return formula;
}

// Turns expressions into steps; an expression met before is not computed again.
class Compiler
{
public:
  explicit Compiler(FormulaProgram& program)
    : Program(program)
  {
  }

  int Compile(const GiNaC::ex& expression)
  {
    const auto found = this->Known.find(expression);
    if (found != this->Known.end())
    {
      return found->second;
    }
    const int step = this->CompileNew(expression);
    this->Known.emplace(expression, step);
    return step;
  }

private:
  using Operation = FormulaProgram::Operation;

  int CompileNew(const GiNaC::ex& expression)
  {
    if (expression.is_equal(SymbolX()))
    {
      return this->Program.Append({ Operation::X });
    }
    if (expression.is_equal(SymbolY()))
    {
      return this->Program.Append({ Operation::Y });
    }
    if (const GiNaC::ex value = expression.evalf(); GiNaC::is_a<GiNaC::numeric>(value))
    {
      return this->CompileNumber(GiNaC::ex_to<GiNaC::numeric>(value));
    }
    if (GiNaC::is_a<GiNaC::add>(expression))
    {
      return this->CompileList(expression, Operation::Add);
    }
    if (GiNaC::is_a<GiNaC::mul>(expression))
    {
      return this->CompileList(expression, Operation::Multiply);
    }
    if (GiNaC::is_a<GiNaC::power>(expression))
    {
      return this->CompilePower(expression);
    }
    if (GiNaC::is_a<GiNaC::function>(expression))
    {
      return this->CompileCall(expression);
    }
    Refuse(expression);
  }

  int CompileNumber(const GiNaC::numeric& number)
  {
    if (!number.is_real())
    {
      throw std::runtime_error("has a part that is not a real number");
    }
    return this->Program.Append({ Operation::Constant, 0, 0, number.to_double() });
  }

  int CompileList(const GiNaC::ex& expression, Operation operation)
  {
    int result = this->Compile(expression.op(0));
    for (std::size_t i = 1; i < expression.nops(); ++i)
    {
      const int operand = this->Compile(expression.op(i));
      result = this->Program.Append({ operation, result, operand });
    }
    return result;
  }

  int CompilePower(const GiNaC::ex& expression)
  {
    constexpr int largest = 64;
    const int base = this->Compile(expression.op(0));
    const GiNaC::ex exponent = expression.op(1);
    if (GiNaC::is_a<GiNaC::numeric>(exponent))
    {
      const auto& number = GiNaC::ex_to<GiNaC::numeric>(exponent);
      if (number.is_integer() && abs(number) <= largest)
      {
        return this->Program.Append({ Operation::IntegerPower, base, 0, number.to_double() });
      }
    }
    return this->Program.Append({ Operation::Power, base, this->Compile(exponent) });
  }

  int CompileCall(const GiNaC::ex& expression)
  {
    const std::string name = GiNaC::ex_to<GiNaC::function>(expression).get_name();
    if (name == "atan2")
    {
      const int first = this->Compile(expression.op(0));
      return this->Program.Append(
        { Operation::ArcTangent, first, this->Compile(expression.op(1)) });
    }
    const auto functions = FormulaFunctions();
    for (std::size_t i = 0; i < functions.size(); ++i)
    {
      if (name == functions[i].Name)
      {
        const int operand = this->Compile(expression.op(0));
        return this->Program.Append({ Operation::Call, operand, static_cast<int>(i) });
      }
    }
    Refuse(expression);
  }

  [[noreturn]] static void Refuse(const GiNaC::ex& expression)
  {
    std::ostringstream text;
    text << expression;
    throw std::runtime_error(
      "has a part that cannot be evaluated or differentiated: " + text.str());
  }

  FormulaProgram& Program;
  std::map<GiNaC::ex, int, GiNaC::ex_is_less> Known;
};

} // namespace

FormulaProgram CompileFormulas(const std::vector<WantedFormula>& formulas)
{
  const std::scoped_lock lock(GinacMutex);
  FormulaProgram program;
  Compiler compiler(program);
  for (const WantedFormula& formula : formulas)
  {
    const GiNaC::ex expression = Parse(formula);
    try
    {
      program.AddOutput(compiler.Compile(Differentiate(expression, formula.Of)));
    }
    catch (const std::exception& error)
    {
      Complain(formula, std::string(error.what()) + ".");
    }
  }
  return program;
}

} // namespace pemesh

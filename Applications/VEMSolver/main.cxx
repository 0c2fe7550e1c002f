// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `pemesh-vem`: the bundled solver, a program like any other solver: it reads a mesh and leaves
 * one number a vertex, an element or a mesh in each of its files (Applications/Solvers/README.md).
 */
#include "ConditionNumber.h"
#include "EllipticProblem.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "ParallelLoop.h"
#include "TestProblems.h"
#include "TextFile.h"
#include "VirtualElementMethod.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace
{

enum ExitCode
{
  Solved = 0,
  Failed = 1,
  WrongUsage = 2
};

struct Arguments
{
  std::string Mesh;
  std::string Elements;
  std::string Output;
  std::string Problem = "franke";
  int Order = 1;
  std::string Basis = pemesh::BasisRules().front().Name;
  std::string Stabilisation = pemesh::StabilisationRules().front().Name;
  std::string Constant = "boundary";
  std::string Load = "pi0";
  std::string Solver = "auto";
  std::string Details = "basic";
  pemesh::ProblemFormulas Formulas;
  int Threads = 1;
  bool ListProblems = false;
};

void Say(const std::string& sentence)
{
  std::fputs(("pemesh-vem: " + sentence + "\n").c_str(), stderr);
}

// An option whose value is the name of an entry of a table.
template <typename Entry>
void AddChoice(CLI::App& program, const char* name, std::string& value,
  std::span<const Entry> table, const std::string& description)
{
  std::vector<std::string> names;
  for (const Entry& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  program.add_option(name, value, description)->check(CLI::IsMember(names))->capture_default_str();
}

void AddFormulas(CLI::App& program, pemesh::ProblemFormulas& formulas)
{
  const auto add = [&program](const char* name, std::string& formula, const char* description)
  { program.add_option(name, formula, description)->group("Formulas of x and y"); };
  add("--solution", formulas.Solution, "The solution u, in place of the test problem");
  add("--diffusion", formulas.Diffusion, "kappa in -div(kappa grad u) + beta . grad u + c u = f");
  add("--diffusion-xy", formulas.DiffusionXY,
    "The entry xy of kappa where it is a tensor; --diffusion is xx then");
  add("--diffusion-yy", formulas.DiffusionYY, "The entry yy; that of xx where it is not given");
  add("--advection-x", formulas.AdvectionX, "The first component of beta");
  add("--advection-y", formulas.AdvectionY, "The second component of beta");
  add("--reaction", formulas.Reaction, "c");
  add("--source", formulas.Load, "f, where there is no solution to derive it from");
  add("--dirichlet", formulas.Dirichlet, "u on the boundary, where there is no solution");
  add("--neumann", formulas.Neumann,
    "kappa du/dn in place of u is given on the edges of the boundary at whose midpoints this is "
    "positive");
  add("--flux", formulas.Flux, "kappa du/dn there; derived from the solution, else 0");
}

void AddOptions(CLI::App& program, Arguments& arguments)
{
  program.add_option("--mesh", arguments.Mesh, "The mesh: OFF, OBJ, NODE (with ELE), STL or VTP");
  program.add_option("--ele", arguments.Elements,
    "The elements of a NODE file; only needed if a caller passes both: the name must be the same");
  program.add_option("--output", arguments.Output, "The folder for the results");
  program.add_option("--problem", arguments.Problem, "The test problem")->capture_default_str();
  program.add_option("--order", arguments.Order, "The order of the method: 1 to 6")
    ->capture_default_str();
  AddChoice(program, "--basis", arguments.Basis, pemesh::BasisRules(),
    "The basis of the polynomials on an element");
  AddChoice(program, "--stabilisation", arguments.Stabilisation, pemesh::StabilisationRules(),
    "The stabilisation");
  AddChoice(program, "--p0", arguments.Constant, pemesh::ProjectionConstants(),
    "What fixes the constant of the projection at order 1: the mean over the boundary of the "
    "element, or over its vertices");
  AddChoice(program, "--load", arguments.Load, pemesh::LoadProjections(),
    "What the source is integrated against: the basis functions' L2 projections of degree order - "
    "1 (pi0), their gradient projections (pinabla), or their L2 projections (pi0-k)");
  AddChoice(program, "--solver", arguments.Solver, pemesh::SolverKinds(),
    "Direct, iterative, or direct if the factor fits into memory");
  program
    .add_option("--details", arguments.Details,
      "all: also what may cost more than solving (condition number in the 2-norm, iterations of "
      "conjugate gradients, conditions and checks of the elements)")
    ->check(CLI::IsMember({ "basic", "all" }))
    ->capture_default_str();
  program
    .add_option(
      "--threads", arguments.Threads, "Threads for the elements; 0 is one for each processor")
    ->check(CLI::Range(0, 4096))
    ->capture_default_str();
  program.add_flag("--list-problems", arguments.ListProblems, "Print the test problems and stop");
  AddFormulas(program, arguments.Formulas);
}

void ListProblems()
{
  for (const pemesh::TestProblem& problem : pemesh::TestProblems())
  {
    std::printf("%-15s %s: u = %s\n", problem.Name, problem.Label, problem.Formula);
  }
}

// Empty if all is well, else a sentence.
std::string WhyWrong(const Arguments& arguments)
{
  if (arguments.Mesh.empty())
  {
    return "A mesh is needed: --mesh FILE.";
  }
  if (arguments.Output.empty())
  {
    return "A folder for the results is needed: --output DIR.";
  }
  if (arguments.Order < 1 || arguments.Order > pemesh::LargestOrder)
  {
    return "Order " + std::to_string(arguments.Order) + " is not available: --order is 1 to " +
      std::to_string(pemesh::LargestOrder) + ".";
  }
  if (!pemesh::FindTestProblem(arguments.Problem))
  {
    std::vector<std::string> names;
    for (const pemesh::TestProblem& problem : pemesh::TestProblems())
    {
      names.emplace_back(problem.Name);
    }
    return "There is no problem \"" + arguments.Problem + "\"; did you mean \"" +
      pemesh::NearestWord(arguments.Problem, names) + "\"? (--list-problems shows all.)";
  }
  if (!arguments.Elements.empty())
  {
    // The pair is found by the common name, whatever the case of the extensions.
    std::filesystem::path nodes(arguments.Mesh);
    std::filesystem::path elements(arguments.Elements);
    if (nodes.replace_extension().lexically_normal() !=
      elements.replace_extension().lexically_normal())
    {
      return "The files \"" + arguments.Mesh + "\" and \"" + arguments.Elements +
        "\" are not a pair: apart from .node and .ele their names must be the same.";
    }
  }
  return {};
}

void WriteNumbers(const std::filesystem::path& path, std::span<const double> values)
{
  std::string text;
  for (const double value : values)
  {
    pemesh::AppendNumber(text, value);
    text += '\n';
  }
  pemesh::WriteTextFile(path, text);
}

// A solution or a source of one's own takes the place of the test problem.
pemesh::EllipticProblem MakeProblem(const Arguments& arguments)
{
  const bool own = !arguments.Formulas.Solution.empty() || !arguments.Formulas.Load.empty();
  return pemesh::EllipticProblem(
    arguments.Formulas, own ? nullptr : pemesh::FindTestProblem(arguments.Problem));
}

pemesh::VirtualElementOptions MakeOptions(const Arguments& arguments)
{
  pemesh::VirtualElementOptions options;
  options.Order = arguments.Order;
  options.Basis = FindByName(pemesh::BasisRules(), arguments.Basis);
  options.Stabilisation = FindByName(pemesh::StabilisationRules(), arguments.Stabilisation);
  options.Constant = FindByName(pemesh::ProjectionConstants(), arguments.Constant)->Choice;
  options.Load = FindByName(pemesh::LoadProjections(), arguments.Load)->Choice;
  options.Solver = FindByName(pemesh::SolverKinds(), arguments.Solver)->Choice;
  options.Details = arguments.Details == "all";
  return options;
}

// One line for all: a note is no error.
void NoteUndefined(const pemesh::VirtualElementResult& result, bool details)
{
  std::string names;
  for (const auto& performance : pemesh::VirtualElementPerformances())
  {
    if (!std::isfinite(result.*performance.Value) && (details || !performance.Detail))
    {
      names += (names.empty() ? "" : ", ") + std::string(performance.Name);
    }
  }
  if (!names.empty())
  {
    Say("note: " + names +
      " is undefined on this mesh: the exact solution is not known, vanishes, or is constant, at "
      "all vertices; or the solver cannot tell it.");
  }
}

void WriteResult(
  const pemesh::VirtualElementResult& result, const std::filesystem::path& stem, bool details)
{
  const auto file = [&stem](const std::string& name)
  { return std::filesystem::path(stem.string() + '-' + name + ".txt"); };
  WriteNumbers(file("solution"), result.Solution);
  if (!result.GroundTruth.empty())
  {
    WriteNumbers(file("ground-truth"), result.GroundTruth);
  }
  for (const pemesh::VirtualElementPerformance& performance : pemesh::VirtualElementPerformances())
  {
    const double value = result.*performance.Value;
    WriteNumbers(file(performance.Name), { &value, 1 });
  }
  for (const pemesh::VirtualElementArray& array : pemesh::VirtualElementArrays())
  {
    if (!(result.*array.Values).empty())
    {
      WriteNumbers(file(array.Name), result.*array.Values);
    }
  }
  NoteUndefined(result, details);
  if (result.ConditionNumber > pemesh::LargestMeaningfulConditionNumber)
  {
    Say("note: the condition number " + pemesh::FormatNumber(result.ConditionNumber) +
      " is beyond double precision: the results have no correct digits.");
  }
}

void Solve(const Arguments& arguments, const pemesh::EllipticProblem& problem)
{
  pemesh::SetNumberOfThreads(arguments.Threads);
  const std::filesystem::path meshFile(arguments.Mesh);
  const vtkSmartPointer<vtkPolyData> mesh = pemesh::ReadMesh(meshFile);
  const pemesh::VirtualElementOptions options = MakeOptions(arguments);
  WriteResult(pemesh::SolveElliptic(mesh, problem, options),
    std::filesystem::path(arguments.Output) / meshFile.stem(), options.Details);
}

// Empty if the formulas make a problem, else a sentence.
std::string WhyNoProblem(const Arguments& arguments)
{
  try
  {
    MakeProblem(arguments);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App program(
    "Solves -div(kappa grad u) + beta . grad u + c u = f with the virtual element method\n"
    "of order 1 to 6, and reports errors and conditioning.\n"
    "Exit code: 0 solved, 1 bad mesh or system, 2 wrong usage.");
  program.name("pemesh-vem");
  program.set_version_flag("--version", std::string("pemesh-vem ") + PEMESH_VERSION);
  Arguments arguments;
  AddOptions(program, arguments);
  try
  {
    program.parse(argc, argv);
    if (arguments.ListProblems)
    {
      ListProblems();
      return Solved;
    }
    std::string wrong = WhyWrong(arguments);
    wrong = wrong.empty() ? WhyNoProblem(arguments) : wrong;
    if (!wrong.empty())
    {
      Say(wrong);
      return WrongUsage;
    }
    Solve(arguments, MakeProblem(arguments));
  }
  catch (const CLI::ParseError& error)
  {
    return program.exit(error) == 0 ? Solved : WrongUsage;
  }
  catch (const std::bad_alloc&)
  {
    Say("There is not enough memory for this mesh.");
    return Failed;
  }
  catch (const std::exception& error)
  {
    Say(error.what());
    return Failed;
  }
  return Solved;
}

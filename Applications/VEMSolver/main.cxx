// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `pemesh-vem`: the bundled solver, a program like any other solver: it reads a mesh and leaves
 * one number a vertex, or one number, in each of its files (Applications/Solvers/README.md).
 */
#include "ConditionNumber.h"
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
  std::string Constant = "boundary";
  std::string Load = "pi0";
  int Threads = 1;
  bool ListProblems = false;
};

void Say(const std::string& sentence)
{
  std::fputs(("pemesh-vem: " + sentence + "\n").c_str(), stderr);
}

void AddOptions(CLI::App& program, Arguments& arguments)
{
  program.add_option("--mesh", arguments.Mesh, "The mesh: OFF, OBJ, NODE (with ELE), STL or VTP");
  program.add_option("--ele", arguments.Elements,
    "The elements of a NODE file; only needed if a caller passes both: the name must be the same");
  program.add_option("--output", arguments.Output, "The folder for the results");
  program.add_option("--problem", arguments.Problem, "The test problem")->capture_default_str();
  program.add_option("--order", arguments.Order, "The order of the method: 1")
    ->capture_default_str();
  program
    .add_option("--p0", arguments.Constant,
      "What fixes the constant of the projection: the mean over the boundary of the element, or "
      "over its vertices")
    ->check(CLI::IsMember({ "boundary", "vertex" }))
    ->capture_default_str();
  program
    .add_option("--load", arguments.Load,
      "What the source is integrated against: the means of the projected basis functions (pi0), "
      "or these functions (pinabla)")
    ->check(CLI::IsMember({ "pi0", "pinabla" }))
    ->capture_default_str();
  program
    .add_option(
      "--threads", arguments.Threads, "Threads for the elements; 0 is one for each processor")
    ->check(CLI::Range(0, 4096))
    ->capture_default_str();
  program.add_flag("--list-problems", arguments.ListProblems, "Print the test problems and stop");
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
  if (arguments.Order != 1)
  {
    return "Order " + std::to_string(arguments.Order) +
      " is not available: this version solves with --order 1 only.";
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

void Solve(const Arguments& arguments)
{
  pemesh::SetNumberOfThreads(arguments.Threads);
  const std::filesystem::path meshFile(arguments.Mesh);
  const vtkSmartPointer<vtkPolyData> mesh = pemesh::ReadMesh(meshFile);
  pemesh::VirtualElementOptions options;
  options.Constant = arguments.Constant == "vertex" ? pemesh::ProjectionConstant::VertexMean
                                                    : pemesh::ProjectionConstant::BoundaryMean;
  options.Load =
    arguments.Load == "pinabla" ? pemesh::LoadProjection::Gradient : pemesh::LoadProjection::Mean;
  const pemesh::VirtualElementResult result =
    pemesh::SolvePoisson(mesh, *pemesh::FindTestProblem(arguments.Problem), options);

  const std::filesystem::path folder(arguments.Output);
  const std::string stem = meshFile.stem().string();
  WriteNumbers(folder / (stem + "-solution.txt"), result.Solution);
  WriteNumbers(folder / (stem + "-ground-truth.txt"), result.GroundTruth);
  for (const pemesh::VirtualElementPerformance& performance : pemesh::VirtualElementPerformances())
  {
    const double value = result.*performance.Value;
    WriteNumbers(folder / (stem + "-" + performance.Name + ".txt"), { &value, 1 });
    if (!std::isfinite(value))
    {
      Say(std::string("note: ") + performance.Name +
        " is undefined on this mesh: the exact solution vanishes, or is constant, at all "
        "vertices.");
    }
  }
  if (result.ConditionNumber > pemesh::LargestMeaningfulConditionNumber)
  {
    Say("note: the condition number " + pemesh::FormatNumber(result.ConditionNumber) +
      " is beyond double precision: the results have no correct digits.");
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App program(
    "Solves -Laplace u = f with the lowest-order virtual element method, u given on\n"
    "the boundary, and reports errors and conditioning.\n"
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
    const std::string wrong = WhyWrong(arguments);
    if (!wrong.empty())
    {
      Say(wrong);
      return WrongUsage;
    }
    Solve(arguments);
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

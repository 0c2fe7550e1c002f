// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The solvers of Applications/Solvers as a user meets them. A test whose program is not installed
 * is skipped.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

void WriteFile(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/** n x n quadrilaterals of the unit square, none of them a rectangle. */
std::string Quadrilaterals(int n)
{
  std::string text =
    "OFF\n" + std::to_string((n + 1) * (n + 1)) + ' ' + std::to_string(n * n) + " 0\n";
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = static_cast<double>(i) / n;
      const double y = static_cast<double>(j) / n;
      constexpr double twoPi = 6.283185307179586;
      const double bend = 0.08 * std::sin(twoPi * x) * std::sin(twoPi * y);
      text += std::to_string(x + bend) + ' ' + std::to_string(y - bend) + " 0\n";
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      for (const int vertex : { 4, a, a + 1, a + n + 2, a + n + 1 })
      {
        text += std::to_string(vertex) + ' ';
      }
      text += '\n';
    }
  }
  return text;
}

struct ShippedSolver
{
  const char* Name;
  const char* Probe; // succeeds where the solver can run
};

void PrintTo(const ShippedSolver& solver, std::ostream* stream)
{
  *stream << solver.Name;
}

class Shipped : public testing::TestWithParam<ShippedSolver>
{
protected:
  void SetUp() override
  {
    if (std::system((GetParam().Probe + std::string(" >/dev/null 2>&1")).c_str()) != 0)
    {
      GTEST_SKIP() << "The programs of " << GetParam().Name << " are not installed.";
    }
  }
};

} // namespace

TEST_P(Shipped, PassesTheCheck)
{
  const auto run = RunProgram("pemesh", { "solvers", "check", GetParam().Name });
  EXPECT_EQ(run.ExitCode, 0) << run.Output << run.Errors;
  EXPECT_EQ(run.Output, GetParam().Name + std::string(": OK\n"));
}

TEST_P(Shipped, ConvergesOnRefinedMeshes)
{
  const fs::path folder = TestFolder(std::string("converges-") + GetParam().Name);
  std::vector<std::string> arguments{ "solve" };
  for (const int n : { 4, 8, 16 })
  {
    const fs::path mesh = folder / ("r" + std::to_string(n) + ".off");
    WriteFile(mesh, Quadrilaterals(n));
    arguments.push_back(mesh);
  }
  const fs::path output = folder / "out";
  arguments.insert(arguments.end(), { "--solver", GetParam().Name, "-o", output });
  const auto run = RunProgram("pemesh", arguments);
  ASSERT_EQ(run.ExitCode, 0) << run.Output << run.Errors;
  const auto results = pemesh::ReadCsvFile(output / "results.csv");
  const std::string column = GetParam().Name + std::string("_error-inf");
  for (vtkIdType row = 1; row < 3; ++row)
  {
    // Second order: a quarter, once the mesh is fine.
    const double before = results->GetValueByName(row - 1, column.c_str()).ToDouble();
    const double error = results->GetValueByName(row, column.c_str()).ToDouble();
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, before / (row == 1 ? 2.0 : 3.5));
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, Shipped,
  testing::Values(ShippedSolver{ "python-vem", "/usr/bin/python3 -c 'import numpy'" },
    ShippedSolver{ "octave-vem", "octave-cli --version" }),
  [](const auto& test)
  { return std::string(test.param.Name).substr(0, std::string(test.param.Name).find('-')); });

TEST(ShippedSolvers, TheBundledOnePassesTheCheck)
{
  const auto run = RunProgram("pemesh", { "solvers", "check", "pemesh-vem" });
  EXPECT_EQ(run.ExitCode, 0) << run.Output << run.Errors;
  EXPECT_THAT(run.Output, testing::StartsWith("pemesh-vem: OK\n"));
}

TEST(ShippedSolvers, ResultsComputedElsewhereAreReplayed)
{
  const fs::path folder = TestFolder("replay");
  WriteFile(folder / "a.off", Quadrilaterals(1));
  WriteFile(folder / "their results" / "a-solution.txt", "1\n2\n3\n4\n");
  const std::string results = folder / "their results";
  auto run = RunProgram("pemesh",
    { "solve", folder / "a.off", "--solver", "replay", "--option", "results=" + results, "-o",
      folder / "out" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(FileText(folder / "out" / "results.csv"), HasSubstr(",ok,ok\n"));
  WriteFile(folder / "b.off", Quadrilaterals(1));
  run = RunProgram("pemesh",
    { "solve", folder / "b.off", "--solver", "replay", "--option", "results=" + results, "-o",
      folder / "none" });
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_THAT(run.Errors, HasSubstr("has no file b-*.txt"));
}

TEST(ShippedSolvers, ResultsOfVersionOneAreRead)
{
  const fs::path folder = TestFolder("version-1");
  std::vector<std::string> arguments{ "solve" };
  for (const std::string name : { "b", "a", "c" })
  {
    WriteFile(folder / (name + ".off"), Quadrilaterals(1));
    arguments.push_back(folder / (name + ".off"));
    WriteFile(folder / "old" / (name + "-VEM-sol.txt"), "1\n2\n3\n4\n");
    WriteFile(folder / "old" / (name + "-GROUND-TRUTH-sol.txt"), "1\n2\n3\n5\n");
  }
  WriteFile(folder / "old" / "output.txt",
    "errS errInf errL2 hEmax condVect\n1 2 3 4 5\n6 7 8 9 10\n\n11 12 13 14 15\n");
  const std::string old = folder / "old";
  arguments.insert(arguments.end(),
    { "--solver", "replay-version-1", "--option", "results=" + old, "-o", folder / "out" });
  const auto run = RunProgram("pemesh", arguments);
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  // The lines of output.txt are those of the meshes by name, whatever the order of the study.
  EXPECT_EQ(results->GetValueByName(0, "Mesh").ToString(), "b");
  EXPECT_EQ(results->GetValueByName(0, "replay-version-1_errS").ToDouble(), 6.0);
  EXPECT_EQ(results->GetValueByName(1, "replay-version-1_errL2").ToDouble(), 3.0);
  EXPECT_EQ(results->GetValueByName(2, "replay-version-1_condVect").ToDouble(), 15.0);
}

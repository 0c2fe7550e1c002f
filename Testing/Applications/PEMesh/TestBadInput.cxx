// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Whatever is wrong is told in one clear sentence with exit code 1 or 2, and the rest of the study
 * is done and saved.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <vtkDataArray.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

const std::string SquareMesh = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

void WriteFile(const fs::path& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

/** One sentence: a line that starts with the program's name. */
void ExpectOneSentence(const std::string& errors)
{
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  EXPECT_EQ(errors.rfind("pemesh: ", 0), 0U) << errors;
}

struct BadMesh
{
  const char* Name;
  std::string Text;
  const char* Says;
};

void PrintTo(const BadMesh& bad, std::ostream* stream)
{
  *stream << bad.Name; // not its bytes, which are in the name of the test and change
}

class BadMeshFile : public testing::TestWithParam<BadMesh>
{
};

} // namespace

TEST_P(BadMeshFile, IsARowOfItsOwnAndTheOthersAreDone)
{
  const BadMesh& bad = GetParam();
  const fs::path folder = TestFolder(std::string("bad-mesh-") + bad.Name);
  WriteFile(folder / "a.off", SquareMesh);
  WriteFile(folder / "b.off", bad.Text);
  WriteFile(folder / "c.off", SquareMesh);
  WriteFile(folder / "s.json", R"({"pemesh": 1, "name": "s", "meshes": "*.off"})");
  const auto run = RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 1) << run.Output << run.Errors;
  ExpectOneSentence(run.Errors);
  EXPECT_THAT(run.Errors, HasSubstr("b.off"));
  EXPECT_THAT(run.Errors, HasSubstr(bad.Says));
  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  ASSERT_EQ(results->GetNumberOfRows(), 3);
  auto* area = vtkDataArray::SafeDownCast(results->GetColumnByName("Area_min"));
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->GetComponent(0, 0), 1.0);
  EXPECT_TRUE(std::isnan(area->GetComponent(1, 0)));
  EXPECT_EQ(area->GetComponent(2, 0), 1.0);
  EXPECT_EQ(results->GetValueByName(1, "Status").ToString(), "unreadable-mesh");
  EXPECT_TRUE(fs::exists(folder / "out" / "failures.csv"));
}

INSTANTIATE_TEST_SUITE_P(Files, BadMeshFile,
  testing::Values(BadMesh{ "empty", "", "empty" },
    BadMesh{ "truncated", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n", "line" },
    BadMesh{ "wrong-index", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n", "line 7" },
    BadMesh{ "nan", "OFF\n4 1 0\n0 0 0\nnan 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "line 4" }),
  [](const auto& parameter)
  {
    std::string name = parameter.param.Name;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
  });

TEST(BadStudy, MissingFile)
{
  const auto run = RunProgram("pemesh", { "run", "/nowhere/study.json" });
  EXPECT_EQ(run.ExitCode, 2);
  ExpectOneSentence(run.Errors);
  EXPECT_THAT(run.Errors, HasSubstr("/nowhere/study.json"));
}

TEST(BadStudy, UnknownKeyNamesTheNearest)
{
  const fs::path folder = TestFolder("unknown-key");
  WriteFile(folder / "s.json",
    R"({"pemesh": 1, "polygons": [{"family": "star"}], "mesh": {"min-angel": 20}})");
  const auto run = RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 2);
  ExpectOneSentence(run.Errors);
  EXPECT_THAT(run.Errors, HasSubstr("min-angel"));
  EXPECT_THAT(run.Errors, HasSubstr("min-angle"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(BadStudy, AFolderWithSomethingElseIsNotWrittenInto)
{
  const fs::path folder = TestFolder("foreign-folder");
  WriteFile(folder / "thesis.tex", "years of work");
  const auto run = RunProgram(
    "pemesh", { "run", PEMESH_SOURCE_DIR "/Data/Studies/quickstart.json", "-o", folder });
  EXPECT_EQ(run.ExitCode, 2);
  ExpectOneSentence(run.Errors);
  EXPECT_EQ(pemesh::FileText(folder / "thesis.tex"), "years of work");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(BadStudy, OverlappingPolygonsAreNamedWithTheirT)
{
  const fs::path folder = TestFolder("overlap");
  // A square-like polygon that grows into its neighbour only later in the family.
  WriteFile(folder / "s.json",
    R"({"pemesh": 1, "name": "s", "polygons": [{"family": "star", "center": [0.4, 0.5]},
        {"family": "comb", "center": [0.6, 0.5]}],
        "sweep": [{"parameter": "t", "from": 0, "to": 0.5, "count": 2}]})");
  const auto run = RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 1) << run.Errors;
  EXPECT_THAT(run.Errors, HasSubstr("star"));
  EXPECT_THAT(run.Errors, HasSubstr("comb"));
  EXPECT_THAT(run.Errors, HasSubstr("t = 0.5"));
  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  EXPECT_EQ(results->GetNumberOfRows(), 2);
  EXPECT_EQ(results->GetValueByName(0, "Status").ToString(), "invalid-layout");
}

namespace
{

struct BadSolver
{
  const char* Name;
  std::string Script;
  const char* Status;
  const char* Says;
};

void PrintTo(const BadSolver& bad, std::ostream* stream)
{
  *stream << bad.Name;
}

class FailingSolver : public testing::TestWithParam<BadSolver>
{
};

} // namespace

TEST_P(FailingSolver, IsTheStatusOfItsRunAndTheMetricsAreSaved)
{
  const BadSolver& bad = GetParam();
  const fs::path folder = TestFolder(std::string("solver-") + bad.Name);
  WriteFile(folder / "a.off", SquareMesh);
  WriteFile(folder / "solver.sh", "#!/bin/sh\n" + bad.Script);
  fs::permissions(folder / "solver.sh", fs::perms::owner_all);
  const std::string command = bad.Script.empty() ? "./no-such-program" : "./solver.sh";
  WriteFile(folder / "solver.json",
    R"({"name": "fake", "command": [")" + command +
      R"(", "{mesh}", "{output}", "{stem}"], "mesh-format": "off", "time-limit": 1,
          "performances": [{"name": "error"}]})");
  WriteFile(folder / "s.json",
    R"({"pemesh": 1, "name": "s", "meshes": "a.off", "solvers": [{"solver": "solver.json"}]})");
  const auto run = RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 1) << run.Output << run.Errors;
  ExpectOneSentence(run.Errors);
  EXPECT_THAT(run.Errors, HasSubstr(bad.Says));
  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  ASSERT_EQ(results->GetNumberOfRows(), 1);
  EXPECT_EQ(results->GetValueByName(0, "Area_min").ToDouble(), 1.0);
  EXPECT_EQ(results->GetValueByName(0, "solver_Status").ToString(), bad.Status);
  EXPECT_TRUE(std::isnan(results->GetValueByName(0, "solver_error").ToDouble()));
}

INSTANTIATE_TEST_SUITE_P(Solvers, FailingSolver,
  testing::Values(BadSolver{ "missing", "", "not-found", "no-such-program" },
    BadSolver{ "fails", "echo 'matrix is singular' >&2; exit 3\n", "exit-status", "singular" },
    BadSolver{ "hangs", "sleep 60\n", "time-out", "time limit of 1 s" },
    BadSolver{
      "short", "printf '1\\n2\\n' > \"$2/$3-solution.txt\"\n", "bad-output", "has 2 numbers" }),
  [](const auto& parameter) { return std::string(parameter.param.Name); });

TEST(BadSolverName, IsRefusedBeforeAnythingRuns)
{
  const fs::path folder = TestFolder("solver-name");
  WriteFile(folder / "s.json",
    R"({"pemesh": 1, "polygons": [{"family": "star"}], "solvers": [{"solver": "pemesh-wem"}]})");
  const auto run = RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 2);
  ExpectOneSentence(run.Errors);
  EXPECT_THAT(run.Errors, HasSubstr("pemesh-wem"));
  EXPECT_THAT(run.Errors, HasSubstr("pemesh-vem"));
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Every command, run as a user runs it.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <vtkDataArray.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;
using testing::StartsWith;

namespace
{

const fs::path Meshes = fs::path(PEMESH_TEST_DATA) / "Meshes" / "vem_quality_2d";

/** Unit square of two rectangles, 1/4 and 3/4 wide. */
const std::string TwoRectangles = "OFF\n6 2 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n"
                                  "4 0 1 4 5\n4 1 2 3 4\n";

fs::path WriteTwoRectangles(const fs::path& folder)
{
  std::ofstream(folder / "two.off") << TwoRectangles;
  return folder / "two.off";
}

} // namespace

TEST(Commands, HelpIsEverywhere)
{
  for (const char* command : { "run", "generate", "metrics", "solve", "correlate", "convergence",
         "plot", "render", "check", "report", "list" })
  {
    const auto run = RunProgram("pemesh", { command, "--help" });
    EXPECT_EQ(run.ExitCode, 0) << command;
    EXPECT_THAT(run.Output, HasSubstr("Usage")) << command;
  }
  EXPECT_EQ(RunProgram("pemesh", {}).ExitCode, 2);
  EXPECT_EQ(RunProgram("pemesh", { "rum" }).ExitCode, 2);
  EXPECT_EQ(RunProgram("pemesh", { "run" }).ExitCode, 2);
}

TEST(Commands, ListPrintsEveryTable)
{
  const std::vector<std::pair<std::string, std::string>> contents = { { "families", "u-like" },
    { "metrics", "KernelAreaRatio" }, { "solvers", "pemesh-vem" }, { "problems", "franke-1979" },
    { "rules", "shortest-edge" }, { "rules", "metis" }, { "checks", "t-junctions" },
    { "domains", "l-shape" }, { "sources", "triangulation" }, { "sources", "koch" } };
  for (const auto& [what, word] : contents)
  {
    EXPECT_THAT(RunProgram("pemesh", { "list", what }).Output, HasSubstr(word));
    const auto json = RunProgram("pemesh", { "list", what, "--json" });
    EXPECT_EQ(json.ExitCode, 0);
    EXPECT_THAT(json.Output, StartsWith("["));
    EXPECT_THAT(json.Output, HasSubstr("\"" + word + "\""));
  }
  EXPECT_EQ(RunProgram("pemesh", { "list", "nothing" }).ExitCode, 2);
}

TEST(Commands, MetricsGivesARowAMeshAndARowAnElement)
{
  const fs::path folder = TestFolder("metrics");
  const std::string mesh = WriteTwoRectangles(folder);
  const auto run = RunProgram(
    "pemesh", { "metrics", mesh, "-o", folder / "summary.csv", "--cells", folder / "cells" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto summary = pemesh::ReadCsvFile(folder / "summary.csv");
  ASSERT_EQ(summary->GetNumberOfRows(), 1);
  EXPECT_EQ(summary->GetValueByName(0, "Area_min").ToDouble(), 0.25);
  EXPECT_EQ(summary->GetValueByName(0, "Area_max").ToDouble(), 0.75);
  EXPECT_EQ(summary->GetValueByName(0, "Area_mean").ToDouble(), 0.5);
  EXPECT_EQ(summary->GetValueByName(0, "Area_max_element").ToInt(), 1);
  EXPECT_EQ(summary->GetValueByName(0, "InscribedRadius_max").ToDouble(), 0.375);
  EXPECT_DOUBLE_EQ(summary->GetValueByName(0, "MeshSize").ToDouble(), 1.25);
  const auto cells = pemesh::ReadCsvFile(folder / "cells" / "two.csv");
  ASSERT_EQ(cells->GetNumberOfRows(), 2);
  EXPECT_EQ(cells->GetValueByName(0, "Area").ToDouble(), 0.25);
  EXPECT_NEAR(cells->GetValueByName(1, "MinAngle").ToDouble(), std::acos(0.0), 1e-15);
}

TEST(Commands, MetricsToStandardOutputOfChosenOnes)
{
  const fs::path folder = TestFolder("metrics-only");
  const auto run =
    RunProgram("pemesh", { "metrics", WriteTwoRectangles(folder), "--only", "Area,EdgeRatio" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output,
    StartsWith("Index,Mesh,Elements,Vertices,Edges,Triangles,Polygons,MeshSize,MinAreaRatio,"
               "TotalArea,BoundaryLength,UndefinedElements,Area_min,"));
  EXPECT_THAT(run.Output, testing::Not(HasSubstr("KernelArea")));
  const auto wrong = RunProgram("pemesh", { "metrics", folder / "two.off", "--only", "Aera" });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("Area"));
  const auto missing = RunProgram("pemesh", { "metrics", folder / "two.off", folder / "no.off" });
  EXPECT_EQ(missing.ExitCode, 1);
  EXPECT_THAT(missing.Errors, HasSubstr("no.off"));
  EXPECT_THAT(missing.Output, HasSubstr("0,two"));
}

TEST(Commands, MetricsGivesOtherStatisticsOfGroups)
{
  const fs::path folder = TestFolder("metrics-statistics");
  const std::string mesh = WriteTwoRectangles(folder);
  const auto run = RunProgram("pemesh",
    { "metrics", mesh, mesh, "-o", folder / "summary.csv", "--only", "Area,jumps,solver",
      "--statistics", "standard-deviation,area-mean", "--groups", "all,triangles", "--quantiles",
      "0.5,0.75", "--histogram", "2" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto summary = pemesh::ReadCsvFile(folder / "summary.csv");
  ASSERT_EQ(summary->GetNumberOfRows(), 2);
  const auto Value = [&](const char* column)
  { return summary->GetValueByName(1, column).ToDouble(); };
  EXPECT_EQ(Value("Area_deviation"), 0.25);
  EXPECT_EQ(Value("Area_area_mean"), 0.625);
  EXPECT_EQ(Value("Area_q0.5"), 0.5);
  EXPECT_EQ(Value("Area_q0.75"), 0.625);
  EXPECT_EQ(Value("Area_bin1"), 1.0);
  EXPECT_EQ(Value("Area_bin2"), 1.0);
  EXPECT_EQ(Value("Area_bin1_triangles"), 0.0);
  EXPECT_EQ(Value("AreaJump_q0.5"), 3.0);
  EXPECT_FALSE(summary->GetColumnByName("Area_min"));
  EXPECT_TRUE(summary->GetColumnByName("StabilityRatio_deviation_triangles"));
  for (const auto& [option, value] :
    std::map<std::string, std::string>{ { "--statistics", "median" }, { "--groups", "squares" },
      { "--quantiles", "1.5" }, { "--histogram", "-1" }, { "--only", "Aera" } })
  {
    const auto wrong = RunProgram("pemesh", { "metrics", mesh, option, value });
    EXPECT_EQ(wrong.ExitCode, 2) << option;
    EXPECT_FALSE(wrong.Errors.empty()) << option;
  }
}

TEST(Commands, GenerateMakesMeshesOnly)
{
  const fs::path folder = TestFolder("generate");
  std::ofstream(folder / "s.json") << R"({"pemesh": 1, "polygons": [{"family": "maze"}],
           "sweep": [{"parameter": "t", "from": 0, "to": 0.5, "count": 2}]})";
  const auto run = RunProgram(
    "pemesh", { "generate", folder / "s.json", "-o", folder / "out", "--format", "off,obj" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(FileText(folder / "out" / "000_0.000000.off"), StartsWith("OFF"));
  EXPECT_FALSE(FileText(folder / "out" / "001_0.500000.obj").empty());
  EXPECT_TRUE(fs::exists(folder / "out" / "index.csv"));
  EXPECT_FALSE(fs::exists(folder / "out" / "results.csv"));
}

TEST(Commands, SolveThenCorrelateThenPlot)
{
  const fs::path folder = TestFolder("solve");
  std::vector<std::string> arguments = { "solve" };
  for (const char* name : { "Slices1.off", "Slices2.off", "Slices3.off" })
  {
    arguments.push_back(Meshes / name);
  }
  for (const char* argument : { "--solver", "pemesh-vem", "--option", "problem=trigonometric" })
  {
    arguments.emplace_back(argument);
  }
  arguments.insert(arguments.end(), { "-o", folder / "out" });
  const auto solved = RunProgram("pemesh", arguments);
  ASSERT_EQ(solved.ExitCode, 0) << solved.Errors;
  const std::string results = folder / "out" / "results.csv";
  const auto table = pemesh::ReadCsvFile(results);
  auto* error = vtkDataArray::SafeDownCast(table->GetColumnByName("pemesh-vem_relative-error-l2"));
  ASSERT_NE(error, nullptr);
  EXPECT_GT(error->GetComponent(0, 0), error->GetComponent(1, 0));
  EXPECT_GT(error->GetComponent(1, 0), error->GetComponent(2, 0));

  const auto correlated = RunProgram(
    "pemesh", { "correlate", results, "--x", "MeshSize", "--y", "pemesh-vem_relative-error-l2" });
  ASSERT_EQ(correlated.ExitCode, 0) << correlated.Errors;
  EXPECT_THAT(correlated.Output, HasSubstr("MeshSize,pemesh-vem_relative-error-l2,3,"));
  EXPECT_THAT(correlated.Output, HasSubstr("increasing"));
  const auto orders = RunProgram("pemesh", { "convergence", results, "--format", "markdown" });
  EXPECT_EQ(orders.ExitCode, 0) << orders.Errors;
  EXPECT_THAT(orders.Output, HasSubstr("| pemesh-vem_relative-error-l2 | order |"));
  EXPECT_THAT(orders.Output, HasSubstr("\n| fit |"));
  const auto noSize = RunProgram("pemesh", { "convergence", results, "--size", "MehsSize" });
  EXPECT_EQ(noSize.ExitCode, 2);
  EXPECT_THAT(noSize.Errors, HasSubstr("MeshSize"));
  const auto wrong = RunProgram("pemesh", { "correlate", results, "--x", "MehsSize" });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("\"MeshSize\""));

  for (const char* ending : { "png", "svg", "pdf" })
  {
    const fs::path figure = folder / (std::string("error.") + ending);
    const auto plotted = RunProgram("pemesh",
      { "plot", results, "--x", "MeshSize", "--y", "pemesh-vem_relative-error-l2", "--log", "xy",
        "--kind", "line", "-o", figure });
    EXPECT_EQ(plotted.ExitCode, 0) << plotted.Errors;
    EXPECT_GT(fs::file_size(figure), 1000U);
  }
}

TEST(Commands, RenderDrawsSeveralMeshesSideBySide)
{
  const fs::path folder = TestFolder("render-several");
  const std::string maze = Meshes / "Maze2.obj";
  const auto run = RunProgram("pemesh",
    { "render", maze, maze, maze, "--columns", "3", "--captions", "one,two,three", "--title",
      "Mazes", "-o", folder / "mazes.svg" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const std::string text = FileText(folder / "mazes.svg");
  EXPECT_THAT(text, HasSubstr("<svg"));
  const auto wide = RunProgram(
    "pemesh", { "render", maze, maze, "--captions", "one,two,three", "-o", folder / "x.svg" });
  EXPECT_EQ(wide.ExitCode, 2);
  EXPECT_THAT(wide.Errors, HasSubstr("more captions (3) than meshes (2)"));
}

TEST(Commands, RenderDrawsAMetricThatTheFileDoesNotHold)
{
  const fs::path folder = TestFolder("render");
  const std::string mesh = Meshes / "Maze2.obj";
  const auto run = RunProgram("pemesh",
    { "render", mesh, "--color-by", "KernelAreaRatio", "--highlight", "both", "-o",
      folder / "maze.png" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(FileText(folder / "maze.png"), StartsWith("\x89PNG"));
  const auto wrong =
    RunProgram("pemesh", { "render", mesh, "--color-by", "KernelRatio", "-o", folder / "x.png" });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("KernelRatio"));
  EXPECT_FALSE(fs::exists(folder / "x.png"));
  const auto ending = RunProgram("pemesh", { "render", mesh, "-o", folder / "maze.bmp" });
  EXPECT_NE(ending.ExitCode, 0);
  EXPECT_THAT(ending.Errors, HasSubstr("maze.bmp"));
}

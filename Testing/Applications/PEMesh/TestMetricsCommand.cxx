// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What `pemesh metrics` and `pemesh render` say of chosen elements, and that a study says the same.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <vtkTable.h>
#include <vtkVariant.h>

#include <sys/resource.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

/** Unit square of two rectangles, 1/4 and 3/4 wide. */
const std::string TwoRectangles = "OFF\n6 2 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n"
                                  "4 0 1 4 5\n4 1 2 3 4\n";
/** The same with a right triangle of legs 1 at its side. */
const std::string WithTriangle = "OFF\n7 3 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n"
                                 "2 0 0\n4 0 1 4 5\n4 1 2 3 4\n3 2 6 3\n";
/** A square and an element without area. */
const std::string WithFlat =
  "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 0 0\n4 0 1 2 3\n3 1 4 5\n";

std::string WriteMesh(const fs::path& folder, const std::string& name, const std::string& text)
{
  std::ofstream(folder / name) << text;
  return folder / name;
}

double Value(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

} // namespace

TEST(MetricsCommand, SaysTheSameAsAStudy)
{
  const fs::path folder = TestFolder("metrics-as-study");
  const std::string a = WriteMesh(folder, "a.off", TwoRectangles);
  const std::string b = WriteMesh(folder, "b.off", WithTriangle);
  std::ofstream(folder / "study.json") << R"({"pemesh": 1, "meshes": "*.off", "metrics": {
    "names": ["Area", "MinAngle", "AreaJump"], "mesh": ["MeshRho", "Elements"],
    "statistics": ["min", "area-mean", "standard-deviation", "undefined"],
    "groups": ["all", "triangles", "polygons", "placed", "selected"], "quantiles": [0.05, 0.5],
    "histogram": 3, "selection": "MinAngle::1"}})";
  const auto study = RunProgram("pemesh", { "run", folder / "study.json", "-o", folder / "out" });
  ASSERT_EQ(study.ExitCode, 0) << study.Errors;
  const auto run = RunProgram("pemesh",
    { "metrics", a, b, "-o", folder / "metrics.csv", "--only", "Area,MinAngle,AreaJump", "--mesh",
      "MeshRho,Elements", "--statistics", "min,area-mean,standard-deviation,undefined", "--groups",
      "all,triangles,polygons,placed,selected", "--quantiles", "0.05,0.5", "--histogram", "3",
      "--selection", "MinAngle::1" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const std::string text = FileText(folder / "metrics.csv");
  EXPECT_TRUE(text == FileText(folder / "out" / "results.csv"));
  EXPECT_THAT(text, testing::StartsWith("Index,Mesh,MeshRho,Elements,Area_min,Area_area_mean,"));
  const auto table = pemesh::ReadCsvFile(folder / "metrics.csv");
  EXPECT_EQ(Value(table, 1, "Area_min_triangles"), 0.5);
  EXPECT_EQ(Value(table, 1, "Area_min_element_selected"), 2);
  EXPECT_EQ(Value(table, 0, "Area_min_element_selected"), -1);
  EXPECT_EQ(Value(table, 1, "MinAngle_bin1"), 1);
  // Run again from what the first run wrote.
  const auto again =
    RunProgram("pemesh", { "run", folder / "out" / "study.json", "-o", folder / "again" });
  ASSERT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_TRUE(text == FileText(folder / "again" / "results.csv"));
}

TEST(MetricsCommand, ASettingIsAKeyOfMetrics)
{
  const fs::path folder = TestFolder("metrics-set");
  WriteMesh(folder, "a.off", TwoRectangles);
  std::ofstream(folder / "study.json") << R"({"pemesh": 1, "meshes": "*.off", "metrics": "all"})";
  const auto run = RunProgram("pemesh",
    { "run", folder / "study.json", "-o", folder / "out", "--set", "metrics.quantiles=[0.25]",
      "--set", "metrics.statistics=mean" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto table = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  EXPECT_EQ(Value(table, 0, "Area_q0.25"), 0.375);
  EXPECT_FALSE(table->GetColumnByName("Area_min"));
}

TEST(MetricsCommand, WrongChoicesAreRefusedInASentence)
{
  const fs::path folder = TestFolder("metrics-wrong");
  const std::string mesh = WriteMesh(folder, "a.off", TwoRectangles);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
    { { "--mesh", "Elemnts" }, "nearest is \"Elements\"" },
    { { "--only", "solvers" }, "nearest is \"solver\"" },
    { { "--statistics", "meen" }, "nearest is \"mean\"" },
    { { "--groups", "poligons" }, "nearest is \"polygons\"" },
    { { "--groups", "all,selected" }, "needs --selection" },
    { { "--selection", "MinAngle:0:1" }, "--groups all,selected" },
    { { "--groups", "selected", "--selection", "MinAngle<1:" }, "METRIC:FROM:TO" },
    { { "--groups", "selected", "--selection", "MinAngle<0.5" }, "METRIC:FROM:TO" },
    { { "--mesh", "rho" }, "nearest is \"MeshRho\"" },
    { { "--groups", "selected", "--selection", "MinAngle:2:1" }, "begins at 2 and ends at 1" },
  };
  for (const auto& [options, sentence] : cases)
  {
    std::vector<std::string> arguments = { "metrics", mesh };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = RunProgram("pemesh", arguments);
    EXPECT_EQ(run.ExitCode, 2) << options.back();
    EXPECT_THAT(run.Errors, HasSubstr(sentence));
    EXPECT_EQ(run.Output, "");
  }
  const auto missing = RunProgram(
    "pemesh", { "metrics", mesh, "--groups", "selected", "--selection", "MinAngel:0:1" });
  EXPECT_EQ(missing.ExitCode, 1);
  EXPECT_THAT(missing.Errors, HasSubstr("nearest metric is \"MinAngle\""));
  EXPECT_THAT(missing.Output, HasSubstr("no-such-array"));
}

TEST(MetricsCommand, UndefinedIsNaNAndCounted)
{
  const fs::path folder = TestFolder("metrics-undefined");
  const std::string mesh = WriteMesh(folder, "flat.off", WithFlat);
  const auto run = RunProgram("pemesh",
    { "metrics", mesh, "-o", folder / "m.csv", "--cells", folder / "cells", "--only",
      "MinAngle,KernelArea", "--statistics", "min,mean,undefined", "--groups", "all,triangles",
      "--quantiles", "0.5" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto table = pemesh::ReadCsvFile(folder / "m.csv");
  EXPECT_EQ(run.Errors.find("pemesh: "), 0U) << "the warning is said in our words,";
  EXPECT_EQ(std::ranges::count(run.Errors, '\n'), 1) << "and once";
  EXPECT_EQ(Value(table, 0, "UndefinedElements"), 1);
  EXPECT_EQ(Value(table, 0, "MinAngle_undefined"), 1);
  EXPECT_EQ(Value(table, 0, "KernelArea_mean"), 1.0) << "of the square alone";
  EXPECT_TRUE(std::isnan(Value(table, 0, "MinAngle_min_triangles")));
  EXPECT_TRUE(std::isnan(Value(table, 0, "MinAngle_q0.5_triangles")));
  EXPECT_THAT(FileText(folder / "cells" / "flat.csv"), HasSubstr("nan"));
  const auto picture =
    RunProgram("pemesh", { "render", mesh, "--color-by", "MinAngle", "-o", folder / "flat.svg" });
  EXPECT_EQ(picture.ExitCode, 0) << picture.Errors;
}

/** n x n squares as OFF. */
std::string Squares(int n)
{
  std::string text =
    "OFF\n" + std::to_string((n + 1) * (n + 1)) + " " + std::to_string(n * n) + " 0\n";
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      text += std::to_string(j) + " " + std::to_string(i) + " 0\n";
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int corner = i * (n + 1) + j;
      text += "4 " + std::to_string(corner) + " " + std::to_string(corner + 1) + " " +
        std::to_string(corner + n + 2) + " " + std::to_string(corner + n + 1) + "\n";
    }
  }
  return text;
}

/** The most memory that a program started so far took, in kilobytes. */
long PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss;
}

TEST(MetricsCommand, ManyFilesTakeTheMemoryOfOne)
{
  const fs::path folder = TestFolder();
  std::vector<std::string> arguments = { "metrics", WriteMesh(folder, "0.off", Squares(200)), "-o",
    folder / "m.csv" };
  ASSERT_EQ(RunProgram("pemesh", arguments).ExitCode, 0);
  const long one = PeakMemory();
  for (int i = 1; i < 12; ++i)
  {
    const fs::path copy = folder / (std::to_string(i) + ".off");
    fs::copy_file(folder / "0.off", copy);
    arguments.insert(arguments.begin() + 1, copy.string());
  }
  ASSERT_EQ(RunProgram("pemesh", arguments).ExitCode, 0);
  EXPECT_EQ(pemesh::ReadCsvFile(folder / "m.csv")->GetNumberOfRows(), 12);
  // A mesh and its metrics are 15 MB: eleven more would be twice the program.
  EXPECT_LT(PeakMemory(), one + 15000);
}

/** As a program that moves points and keeps arrays would leave it. */
TEST(MetricsCommand, MetricsThatAFileHoldsAreMeasuredAnew)
{
  const fs::path folder = TestFolder();
  const std::string plain = WriteMesh(folder, "a.off", TwoRectangles);
  std::ofstream(folder / "stale.vtk") << R"(# vtk DataFile Version 3.0
two rectangles, once measured at half the size
ASCII
DATASET POLYDATA
POINTS 6 double
0 0 0 0.25 0 0 1 0 0 1 1 0 0.25 1 0 0 1 0
POLYGONS 2 10
4 0 1 4 5
4 1 2 3 4
CELL_DATA 2
SCALARS Diameter double 1
LOOKUP_TABLE default
0.1 0.2
SCALARS Area double 1
LOOKUP_TABLE default
0.1 0.2
)";
  const auto run = RunProgram("pemesh",
    { "metrics", plain, folder / "stale.vtk", "-o", folder / "m.csv", "--only", "MinAngle",
      "--mesh", "MeshSize,TotalArea", "--statistics", "mean,area-mean" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto table = pemesh::ReadCsvFile(folder / "m.csv");
  for (const char* column : { "MeshSize", "TotalArea", "MinAngle_mean", "MinAngle_area_mean" })
  {
    EXPECT_EQ(Value(table, 1, column), Value(table, 0, column)) << column;
  }
  EXPECT_EQ(Value(table, 1, "TotalArea"), 1.0);
}

TEST(MetricsCommand, AnInterruptKeepsTheRowsDone)
{
  const fs::path folder = TestFolder("metrics-interrupted");
  WriteMesh(folder, "a.off", TwoRectangles);
  // The second mesh is a pipe: the program waits for it, and is interrupted there.
  const fs::path pemesh = fs::path(PEMESH_BINARY_DIR) / "bin" / "pemesh";
  const auto run = RunProgram("/bin/sh",
    { "-c",
      "mkfifo b.off; " + pemesh.string() +
        " metrics a.off b.off a.off -o m.csv & child=$!; exec 3>b.off; kill -INT $child; "
        "exec 3>&-; wait $child" },
    folder);
  EXPECT_EQ(run.ExitCode, 1) << run.Errors;
  EXPECT_THAT(run.Errors, HasSubstr("1 of 3 meshes were measured"));
  const auto table = pemesh::ReadCsvFile(folder / "m.csv");
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "Mesh").ToString(), "a");
}

TEST(RenderCommand, FramesAndCountsASelection)
{
  const fs::path folder = TestFolder("render-selection");
  const std::string mesh = WriteMesh(folder, "b.off", WithTriangle);
  const auto run = RunProgram("pemesh",
    { "render", mesh, "--color-by", "Area", "--selection", "MinAngle::1", "--highlight", "both",
      "-o", folder / "b.png" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto plain =
    RunProgram("pemesh", { "render", mesh, "--selection", "MinAngle:3:", "-o", folder / "p.png" });
  EXPECT_EQ(plain.ExitCode, 0) << plain.Errors;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
    { { "--selection", "MinAngel::1" }, "nearest metric is \"MinAngle\"" },
    { { "--selection", "MinAngle<1:" }, "METRIC:FROM:TO" },
    { { "--highlight", "min" }, "needs --color-by" },
    { { "--highlight", "worst" }, "worst" },
  };
  for (const auto& [options, sentence] : cases)
  {
    std::vector<std::string> arguments = { "render", mesh, "-o", folder / "x.png" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto wrong = RunProgram("pemesh", arguments);
    EXPECT_EQ(wrong.ExitCode, 2) << options.back();
    EXPECT_THAT(wrong.Errors, HasSubstr(sentence));
  }
  EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(ListCommand, TellsAllOfOneMetric)
{
  const auto one = RunProgram("pemesh", { "list", "metrics", "KernelAreaRatio" });
  ASSERT_EQ(one.ExitCode, 0) << one.Errors;
  for (const char* line : { "name: KernelAreaRatio\n", "symbol: KAR\n", "formula: A_K / A\n",
         "tex: \\frac{A_K}{A}\n", "range: [0, 1]\n", "good: up\n", "scale-invariant: true\n",
         "rotation-invariant: true\n", "reference: ", "unit: 1\n",
         "test: FiltersMetrics.Metrics/KnownValues.Agree/KernelAreaRatio\n" })
  {
    EXPECT_THAT(one.Output, HasSubstr(line));
  }
  const auto wrong = RunProgram("pemesh", { "list", "metrics", "KernelRatio" });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("nearest is \"KernelAreaRatio\""));
  for (const auto& [what, word] : std::vector<std::pair<std::string, std::string>>{
         { "mesh-metrics", "MeshRho" }, { "statistics", "deviation" }, { "groups", "_filler" } })
  {
    EXPECT_THAT(RunProgram("pemesh", { "list", what }).Output, HasSubstr(word));
    EXPECT_EQ(RunProgram("pemesh", { "list", what, "--json" }).ExitCode, 0);
  }
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * pemesh plot, run as a user runs it, and the charts of a study.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

fs::path WriteTable(const fs::path& folder, const std::string& name, double shift)
{
  std::ofstream table(folder / name);
  table << "h,error,other,family\n";
  for (int i = 0; i < 12; ++i)
  {
    const double h = 1.0 / (1 << (i / 2)) + shift;
    table << h << "," << 2.0 * h * h << "," << (i * 7) % 5 + 1 << "," << (i % 2 ? "comb" : "star")
          << "\n";
  }
  return folder / name;
}

} // namespace

TEST(Plot, DrawsEveryKindThatIsListed)
{
  const fs::path folder = TestFolder("plot-kinds");
  const std::string table = WriteTable(folder, "table.csv", 0.0);
  const auto list = RunProgram("pemesh", { "list", "charts" });
  ASSERT_EQ(list.ExitCode, 0);
  for (const std::string kind : { "line", "scatter", "small-multiples", "scatter-matrix",
         "correlation-matrix", "histogram", "box", "violin", "convergence", "element-scatter" })
  {
    EXPECT_THAT(list.Output, testing::AnyOf(HasSubstr("\n" + kind), testing::StartsWith(kind)));
    const fs::path figure = folder / (kind + ".svg");
    std::vector<std::string> arguments = { "plot", table, "--kind", kind, "--y", "error,other",
      "-o", figure };
    const bool usesX = kind != "histogram" && kind != "box" && kind != "violin" &&
      kind != "scatter-matrix" && kind != "correlation-matrix";
    if (usesX)
    {
      arguments.insert(arguments.end(), { "--x", "h" });
    }
    const auto run = RunProgram("pemesh", arguments);
    EXPECT_EQ(run.ExitCode, 0) << kind << run.Errors;
    EXPECT_THAT(FileText(figure), HasSubstr("</svg>"));
  }
}

TEST(Plot, FitsAndStylesAreInTheFigure)
{
  const fs::path folder = TestFolder("plot-style");
  const std::string table = WriteTable(folder, "table.csv", 0.0);
  std::ofstream(folder / "paper.json") << R"({"palette": "muted", "font-size": 10})";
  const fs::path figure = folder / "fit.svg";
  const auto run = RunProgram("pemesh",
    { "plot", table, "--x", "h", "--y", "error", "--fit", "power", "--style", folder / "paper.json",
      "--set", "ink=#102030", "--set", "frame=true", "--data", "-o", figure });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const std::string text = FileText(figure);
  EXPECT_THAT(text, HasSubstr("fit: y = 2 x^2, R² = 1"));
  EXPECT_THAT(text, HasSubstr("font-size=\"10\""));
  EXPECT_THAT(text, HasSubstr("#102030")); // the ink
  const auto data = pemesh::ReadCsvFile(folder / "fit.csv");
  EXPECT_EQ(data->GetValueByName(3, "X").ToDouble(), 0.5);
  EXPECT_EQ(data->GetValueByName(3, "Y").ToDouble(), 0.5);
}

TEST(Plot, TablesOfSeveralMeshesAreToldApart)
{
  const fs::path folder = TestFolder("plot-several");
  const std::string first = WriteTable(folder, "first.csv", 0.0);
  const std::string second = WriteTable(folder, "second.csv", 1.0);
  const auto run = RunProgram("pemesh",
    { "plot", first, second, "--kind", "violin", "--y", "error", "--group-by", "Mesh", "-o",
      folder / "violins.svg" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(FileText(folder / "violins.svg"), HasSubstr(">second</text>"));
}

TEST(Plot, WhatIsWrongIsSaidInOneSentence)
{
  const fs::path folder = TestFolder("plot-wrong");
  const std::string table = WriteTable(folder, "table.csv", 0.0);
  const auto errors = [&](std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), { "plot", table, "-o", folder / "x.png" });
    const auto run = RunProgram("pemesh", arguments);
    EXPECT_EQ(run.ExitCode, 2);
    return run.Errors;
  };
  EXPECT_THAT(errors({ "--kind", "histogram", "--y", "error", "--x", "h" }),
    HasSubstr("The kind histogram has no --x."));
  EXPECT_THAT(errors({ "--y", "error" }), HasSubstr("The kind scatter needs --x"));
  EXPECT_THAT(errors({ "--x", "h", "--y", "error", "--fit", "cubic" }), HasSubstr("\"none\""));
  EXPECT_THAT(errors({ "--x", "h", "--y", "error", "--bins", "3" }), HasSubstr("has no --bins"));
  EXPECT_THAT(
    errors({ "--x", "h", "--y", "error", "--set", "pallete=ibm" }), HasSubstr("\"palette\""));
  EXPECT_THAT(errors({ "--x", "h", "--y", "error", "--set", "grid" }), HasSubstr("NAME=VALUE"));
  EXPECT_THAT(errors({ "--x", "h", "--y", "eror" }), HasSubstr("nearest is \"error\""));
  EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(Plot, StudiesDrawElementsOfSeveralMeshes)
{
  const fs::path folder = TestFolder("plot-study");
  std::ofstream(folder / "study.json") << R"({"pemesh": 1, "name": "charts",
    "polygons": [{"family": "star", "center": [0.5, 0.5]}],
    "sweep": [{"parameter": "t", "from": 0, "to": 0.6, "count": 3}],
    "mesh": {"max-area": {"rule": "constant", "value": 0.02}},
    "style": {"palette": "vibrant"},
    "plots": [
      {"kind": "violin", "y": "MinAngle", "cases": [0, -1], "file": "violin.svg",
       "style": {"palette": "ibm"}, "data": true},
      {"kind": "element-scatter", "x": "Area", "y": "MinAngle", "file": "elements.svg"},
      {"kind": "small-multiples", "y": ["MinAngle", "Area"], "file": "multiples.svg"}]})";
  const auto run = RunProgram("pemesh", { "run", folder / "study.json", "-o", folder / "out" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors << run.Output;
  const fs::path plots = folder / "out" / "plots";
  EXPECT_THAT(FileText(plots / "violin.svg"), HasSubstr(">000_0.000000</text>"));
  const auto data = pemesh::ReadCsvFile(plots / "violin.csv");
  EXPECT_GT(data->GetNumberOfRows(), 300);
  // The style of the study, and of one plot its own on top.
  EXPECT_THAT(FileText(plots / "elements.svg"), HasSubstr("#0077bb"));
  EXPECT_THAT(FileText(plots / "multiples.svg"), HasSubstr("#0077bb"));
  EXPECT_THAT(FileText(plots / "violin.svg"), HasSubstr("#648fff"));
}

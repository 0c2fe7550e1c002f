// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * correlate and report, as a user runs them.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** Tables of four families of five meshes: the error is the area to the power -1.9. */
std::vector<std::string> WriteFamilies(const fs::path& folder)
{
  std::vector<std::string> files;
  for (int family = 0; family < 4; ++family)
  {
    files.push_back(folder / ("family" + std::to_string(family) + ".csv"));
    std::ofstream file(files.back());
    file << "Index,Mesh,MeshSize,Area_min,Noise_min,run_error\n";
    for (int i = 0; i < 5; ++i)
    {
      const double area = 1.0 + i + 2.0 * family;
      file << i << ",m" << i << "," << 0.1 + 0.01 * ((3 * i + family) % 5) << "," << area << ","
           << (7 * i + 3 * family) % 11 << "," << 100.0 * std::pow(area, -1.9) << "\n";
    }
  }
  return files;
}

std::vector<std::string> Arguments(
  const std::vector<std::string>& files, const std::vector<std::string>& options)
{
  std::vector<std::string> arguments{ "correlate" };
  arguments.insert(arguments.end(), files.begin(), files.end());
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

} // namespace

TEST(Findings, OfSeveralStudiesAreSentencesAndATable)
{
  const fs::path folder = TestFolder("findings");
  const auto files = WriteFamilies(folder);
  const auto run = RunProgram("pemesh",
    Arguments(files,
      { "-o", folder / "pairs.csv", "--findings", folder / "findings.csv", "--bootstrap", "100",
        "--seed", "7" }));
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("run_error (20 rows of 4 families)"));
  EXPECT_THAT(
    run.Output, HasSubstr("1. Area_min: strong negative, a power law with exponent -1.9"));
  EXPECT_THAT(run.Output, HasSubstr("Jointly, 2 metrics predict"));
  EXPECT_THAT(run.Output, HasSubstr("all 24 arrangements"));
  EXPECT_EQ(run.Errors, "");
  const auto pairs = pemesh::ReadCsvFile(folder / "pairs.csv");
  ASSERT_EQ(pairs->GetNumberOfRows(), 3);
  EXPECT_EQ(pairs->GetValueByName(0, "Families").ToInt(), 4);
  const auto findings = pemesh::ReadCsvFile(folder / "findings.csv");
  EXPECT_EQ(findings->GetValueByName(0, "Metric").ToString(), "Area_min");
  const std::string first = FileText(folder / "pairs.csv");
  ASSERT_EQ(RunProgram("pemesh",
              Arguments(files, { "-o", folder / "pairs.csv", "--bootstrap", "100", "--seed", "7" }))
              .ExitCode,
    0);
  EXPECT_EQ(first, FileText(folder / "pairs.csv")) << "the same seed, the same bytes";
}

TEST(Findings, OfPooledStudiesCanBePlottedByStudy)
{
  const fs::path folder = TestFolder("pooled");
  const auto run = RunProgram("pemesh",
    Arguments(
      WriteFamilies(folder), { "-o", folder / "pairs.csv", "--pooled", folder / "all.csv" }));
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto all = pemesh::ReadCsvFile(folder / "all.csv");
  EXPECT_EQ(all->GetNumberOfRows(), 20);
  EXPECT_STREQ(all->GetColumnName(0), "Study");
  EXPECT_EQ(all->GetValueByName(19, "Study").ToString(), "family3");
  const auto plot = RunProgram("pemesh",
    { "plot", folder / "all.csv", "--x", "Area_min", "--y", "run_error", "--log", "xy",
      "--color-by", "Study", "-o", folder / "all.png" });
  EXPECT_EQ(plot.ExitCode, 0) << plot.Errors;
}

TEST(Findings, OfOneFamilyHaveNoPValues)
{
  const fs::path folder = TestFolder("one-family");
  const auto run = RunProgram(
    "pemesh", Arguments({ WriteFamilies(folder).front() }, { "-o", folder / "pairs.csv" }));
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("they are no sample"));
  EXPECT_THAT(run.Output, HasSubstr("No joint model"));
  EXPECT_THAT(FileText(folder / "pairs.csv"), HasSubstr(",nan,nan,nan,nan,nan,decreasing,"));
}

TEST(Findings, TakePerformancesOfTheUsersOwn)
{
  const fs::path folder = TestFolder("join");
  const auto files = WriteFamilies(folder);
  std::ofstream(folder / "mine.csv") << "Mesh,iterations\nm0,10\nm1,11\nm2,13\nm3,17\nm4,20\n";
  const auto run = RunProgram("pemesh",
    Arguments({ files.front() }, { "--join", folder / "mine.csv", "-o", folder / "pairs.csv" }));
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("iterations (5 rows)"));
  const auto pooled = RunProgram("pemesh", Arguments(files, { "--join", folder / "mine.csv" }));
  EXPECT_EQ(pooled.ExitCode, 2);
  EXPECT_THAT(pooled.Errors, HasSubstr("add a column \"Study\""));
  std::ofstream(folder / "wrong.csv") << "Mesh,iterations\nm7,10\n";
  const auto wrong =
    RunProgram("pemesh", Arguments({ files.front() }, { "--join", folder / "wrong.csv" }));
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("\"m7\""));
}

TEST(Findings, OptionsThatDoNotFitAreOneSentence)
{
  const fs::path folder = TestFolder("wrong-options");
  const auto files = WriteFamilies(folder);
  for (const auto& [option, value, sentence] : std::vector<std::array<std::string, 3>>{
         { "--given", "MehsSize", "\"MeshSize\"" }, { "--family", "Stduy", "\"Study\"" },
         { "--coefficient", "pearsn", "pearson" }, { "--x", "Mesh", "holds text" } })
  {
    const auto run = RunProgram("pemesh", Arguments(files, { option, value }));
    EXPECT_EQ(run.ExitCode, 2) << option;
    EXPECT_THAT(run.Errors, HasSubstr(sentence));
    EXPECT_EQ(run.Output, "") << option;
  }
  const auto given =
    RunProgram("pemesh", Arguments(files, { "--given", "MeshSize", "-o", folder / "partial.csv" }));
  EXPECT_EQ(given.ExitCode, 0) << given.Errors;
  EXPECT_THAT(FileText(folder / "partial.csv"), HasSubstr("Spearman given MeshSize"));
}

TEST(Findings, OfAStudyComeWithItsResultsAndItsPage)
{
  const fs::path folder = TestFolder("study-findings");
  std::ofstream(folder / "s.json") << R"({"pemesh": 1, "name": "two-families",
    "polygons": [{"family": "zeta"}],
    "sweep": [{"parameter": "polygons[0].family", "name": "family", "values": ["zeta", "u-like"]},
              {"parameter": "t", "from": 0, "to": 0.6, "count": 3}],
    "metrics": ["Area", "MinAngle"],
    "solvers": [{"solver": "pemesh-vem", "problem": "linear"}],
    "statistics": {"family": "family", "given": "Elements", "seed": 3}})";
  const auto run =
    RunProgram("pemesh", { "run", folder / "s.json", "-o", folder / "out", "--report" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(FileText(folder / "out" / "findings.txt"), HasSubstr("of 2 families"));
  EXPECT_THAT(FileText(folder / "out" / "correlation.csv"), HasSubstr("Spearman given Elements"));
  EXPECT_THAT(FileText(folder / "out" / "findings.csv"), HasSubstr("Performance,Metric,Rank"));
  EXPECT_THAT(FileText(folder / "out" / "report.html"), HasSubstr("two-families"));
  const auto again = RunProgram("pemesh", { "report", folder / "out", "-o", folder / "page.html" });
  EXPECT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_EQ(FileText(folder / "page.html"), FileText(folder / "out" / "report.html"));
  const auto wrong = RunProgram("pemesh", { "report", folder });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("pemesh run"));
  const auto unknown = RunProgram("pemesh",
    { "run", folder / "s.json", "-o", folder / "out", "--set", "statistics.given=Elemnts" });
  EXPECT_EQ(unknown.ExitCode, 1);
  EXPECT_THAT(unknown.Errors, HasSubstr("did you mean \"Elements\"?"));
}

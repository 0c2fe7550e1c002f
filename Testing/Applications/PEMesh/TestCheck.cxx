// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `pemesh check`, run as a user runs it.
 */
#include "CsvTable.h"
#include "MeshFormats.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** Unit square of two rectangles. */
const std::string Good = "OFF\n6 2 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n"
                         "4 0 1 4 5\n4 1 2 3 4\n";
/** The same with the second one clockwise and a vertex that no element uses. */
const std::string Mendable = "OFF\n7 2 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n7 7 0\n"
                             "4 0 1 4 5\n4 1 4 3 2\n";
/** The first one crosses itself. */
const std::string Crossing = "OFF\n6 2 0\n0 0 0\n0.25 0 0\n1 0 0\n1 1 0\n0.25 1 0\n0 1 0\n"
                             "4 0 4 1 5\n4 1 2 3 4\n";

std::string Write(const fs::path& path, const std::string& text)
{
  std::ofstream(path) << text;
  return path;
}

} // namespace

TEST(Check, SaysOkOrWhatIsWrong)
{
  const fs::path folder = TestFolder("check");
  const std::string good = Write(folder / "good.off", Good);
  const std::string bad = Write(folder / "bad.off", Mendable);
  const auto fine = RunProgram("pemesh", { "check", good });
  EXPECT_EQ(fine.ExitCode, 0);
  EXPECT_EQ(fine.Output, good + ": OK (2 elements, 6 vertices)\n");
  EXPECT_EQ(fine.Errors, "");
  const auto both = RunProgram("pemesh", { "check", bad, good });
  EXPECT_EQ(both.ExitCode, 1);
  EXPECT_EQ(both.Output,
    bad + ": 1 error, 1 warning (2 elements, 7 vertices)\n" +
      "  error orientation: 1\n    Element 1 is clockwise. (0.625, 0.5)\n" +
      "  warning unused-points: 1\n    Point 6 is in no element. (7, 7)\n" + good +
      ": OK (2 elements, 6 vertices)\n");
}

TEST(Check, WarningsAreNoErrors)
{
  const fs::path folder = TestFolder("check-warnings");
  const std::string bad = Write(folder / "bad.off", Mendable);
  const auto run = RunProgram("pemesh", { "check", bad, "--only", "unused-points,slivers" });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_THAT(run.Output, HasSubstr("OK, 1 warning"));
}

TEST(Check, WritesFindingsAndFaultyElements)
{
  const fs::path folder = TestFolder("check-output");
  const std::string bad = Write(folder / "bad.off", Crossing);
  const auto run = RunProgram("pemesh", { "check", bad, "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 1);
  const auto table = pemesh::ReadCsvFile(folder / "out" / "bad-findings.csv");
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "Check").ToString(), "simple");
  EXPECT_EQ(table->GetValueByName(0, "Severity").ToString(), "error");
  EXPECT_EQ(table->GetValueByName(0, "Element").ToInt(), 0);
  const auto faults = pemesh::ReadMesh(folder / "out" / "bad-faults.vtp");
  EXPECT_EQ(faults->GetNumberOfCells(), 1);
  EXPECT_FALSE(fs::exists(folder / "out" / "bad.off"));
  Write(bad, Good);
  EXPECT_EQ(RunProgram("pemesh", { "check", bad, "-o", folder / "out" }).ExitCode, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "bad-faults.vtp")) << "of the run before";
}

TEST(Check, RepairsIntoAnotherFolder)
{
  const fs::path folder = TestFolder("check-repair");
  const std::string bad = Write(folder / "bad.off", Mendable);
  const auto run = RunProgram("pemesh", { "check", bad, "--repair", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 0) << run.Output << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("OK, 2 repairs (2 elements, 6 vertices)"));
  EXPECT_THAT(run.Output, HasSubstr("Element 1 was clockwise and is turned round."));
  EXPECT_EQ(FileText(folder / "out" / "bad.off"), Good);
  EXPECT_EQ(FileText(bad), Mendable) << "the mesh read is never touched";
  const auto again = RunProgram("pemesh", { "check", folder / "out" / "bad.off" });
  EXPECT_EQ(again.ExitCode, 0);
}

TEST(Check, NeverWritesOverItsInput)
{
  const fs::path folder = TestFolder("check-over");
  const std::string bad = Write(folder / "bad.off", Mendable);
  fs::create_directories(folder / "other");
  for (const fs::path& same : { folder, folder / "other" / ".." })
  {
    const auto run = RunProgram("pemesh", { "check", bad, "--repair", "-o", same });
    EXPECT_EQ(run.ExitCode, 2);
    EXPECT_THAT(run.Errors, HasSubstr("written over"));
    EXPECT_EQ(FileText(bad), Mendable);
  }
  const auto here = RunProgram("pemesh", { "check", "bad.off", "--repair", "-o", "." }, folder);
  EXPECT_EQ(here.ExitCode, 2);
  const auto none = RunProgram("pemesh", { "check", bad, "--repair" });
  EXPECT_EQ(none.ExitCode, 2);
  EXPECT_THAT(none.Errors, HasSubstr("-o DIR"));
}

TEST(Check, PrintsJson)
{
  const fs::path folder = TestFolder("check-json");
  const std::string bad = Write(folder / "bad.off", Mendable);
  const auto run = RunProgram("pemesh", { "check", bad, folder / "no.off", "--json" });
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_THAT(run.Output, HasSubstr("\"orientation\": 1"));
  EXPECT_THAT(run.Output, HasSubstr("\"message\": \"Element 1 is clockwise.\""));
  EXPECT_THAT(run.Output, HasSubstr("\"ok\": false"));
  EXPECT_THAT(run.Output, Not(HasSubstr("error orientation")));
  EXPECT_THAT(run.Errors, HasSubstr("no.off"));
}

TEST(Check, ComparesWithADomain)
{
  const fs::path folder = TestFolder("check-domain");
  const std::string good = Write(folder / "good.off", Good);
  const std::string square =
    Write(folder / "square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const std::string wide =
    Write(folder / "wide.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n");
  EXPECT_EQ(RunProgram("pemesh", { "check", good, "--domain", square }).ExitCode, 0);
  const auto run = RunProgram("pemesh", { "check", good, "--domain", wide });
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_THAT(run.Output, HasSubstr("error coverage"));
  const std::string crossing = Write(folder / "crossing.off", Crossing);
  EXPECT_EQ(RunProgram("pemesh", { "check", good, "--domain", crossing }).ExitCode, 2);
}

TEST(Check, WrongUsage)
{
  const fs::path folder = TestFolder("check-usage");
  const std::string good = Write(folder / "good.off", Good);
  EXPECT_EQ(RunProgram("pemesh", { "check" }).ExitCode, 2);
  const auto run = RunProgram("pemesh", { "check", good, "--only", "simpel" });
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_THAT(run.Errors, HasSubstr("\"simple\""));
  EXPECT_EQ(RunProgram("pemesh", { "check", good, "--tolerance", "2" }).ExitCode, 2);
  const auto missing = RunProgram("pemesh", { "check", folder / "no.off", good });
  EXPECT_EQ(missing.ExitCode, 1);
  EXPECT_THAT(missing.Output, HasSubstr("OK"));
}

TEST(Check, TheMeshesOfTheQuickstartAreGood)
{
  const fs::path folder = TestFolder("check-quickstart");
  const auto made = RunProgram("pemesh",
    { "generate", PEMESH_SOURCE_DIR "/Data/Studies/quickstart.json", "-o", folder / "meshes",
      "--format", "off" });
  ASSERT_EQ(made.ExitCode, 0) << made.Errors;
  std::vector<std::string> arguments = { "check", "--domain",
    Write(folder / "square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n") };
  for (const auto& entry : fs::directory_iterator(folder / "meshes"))
  {
    if (entry.path().extension() == ".off")
    {
      arguments.push_back(entry.path());
    }
  }
  ASSERT_EQ(arguments.size(), 23U);
  const auto run = RunProgram("pemesh", arguments);
  EXPECT_EQ(run.ExitCode, 0) << run.Output;
}

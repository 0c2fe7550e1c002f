// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverCommand.h"

#include "SolverDescription.h"
#include "TestMeshes.h"

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

std::filesystem::path SolverFolder()
{
  return std::filesystem::path(PEMESH_SOURCE_DIR) / "Testing" / "Support" / "solvers";
}

} // namespace

TEST(SolverCommand, PlaceholdersAreReplaced)
{
  const std::map<std::string, std::string> values{ { "mesh", "/a b/{x}.off" }, { "order", "2" },
    { "empty", "" } };
  EXPECT_THAT(ExpandCommand({ "solve", "{mesh}", "-k{order}", "{empty}", "{order}{order}",
                              "{{order}}", "a}b", "{{\"k\": {order}}}" },
                values),
    testing::ElementsAre("solve", "/a b/{x}.off", "-k2", "", "22", "{order}", "a}b", "{\"k\": 2}"));
}

TEST(SolverCommand, UnknownPlaceholdersAreNamed)
{
  EXPECT_THAT(
    [] {
      ExpandCommand({ "solve", "--k={ordre}" }, { { "order", "2" } });
    },
    testing::ThrowsMessage<std::runtime_error>(
      testing::AllOf(testing::HasSubstr("{ordre}"), testing::HasSubstr("known are {order}"))));
  EXPECT_THAT(
    [] {
      ExpandCommand({ "solve", "{order" }, { { "order", "2" } });
    },
    testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("never closed")));
}

TEST(SolverCommand, ProgramsAreFound)
{
  const std::filesystem::path folder = TestFolder();
  WriteBytes(folder / "bin", "x");
  EXPECT_EQ(FindSolverProgram("/bin/sh", folder), "/bin/sh");
  EXPECT_EQ(FindSolverProgram("./bin", folder), folder / "bin");
  EXPECT_EQ(FindSolverProgram("solvers/fake-solver.sh", SolverFolder().parent_path()),
    SolverFolder() / "fake-solver.sh");
  EXPECT_EQ(FindSolverProgram("./missing", folder), "");
  EXPECT_EQ(FindSolverProgram("/missing", folder), "");
  EXPECT_EQ(FindSolverProgram("../" + folder.filename().string(), folder), ""); // a folder
  EXPECT_EQ(FindSolverProgram("sh", folder).filename(), "sh");
  EXPECT_EQ(FindSolverProgram("bin", folder), ""); // no slash: not looked for in the folder
  EXPECT_EQ(FindSolverProgram("no-such-program-anywhere", folder), "");
  EXPECT_EQ(FindSolverProgram("", folder), "");
  // Beside the running program, although that folder is not in PATH.
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(FindSolverProgram(self.filename().string(), folder), self);
}

// An answer for other arrays, or of an edited script, is not taken again.
TEST(SolverCommand, TheFingerprintChangesWithArraysAndScripts)
{
  const std::filesystem::path script = TestFolder() / "s.py";
  WriteBytes(script, "print(1)");
  SolverDescription description;
  description.Command = { "python3", script.string(), "{mesh}" };
  const std::string first = SolverFingerprint(description);
  EXPECT_EQ(SolverFingerprint(description), first);
  WriteBytes(script, "print(12)");
  const std::string second = SolverFingerprint(description);
  EXPECT_NE(second, first);
  description.Elements.push_back({ "ErrorL2", "Error" });
  EXPECT_NE(SolverFingerprint(description), second);
}

TEST(SolverCommand, AsksForTheVersion)
{
  SolverDescription description;
  EXPECT_EQ(AskSolverVersion(description), "");
  description.VersionCommand = { "sh", "-c", "echo 'solver 1.2'; echo more" };
  EXPECT_EQ(AskSolverVersion(description), "solver 1.2");
  description.VersionCommand = { "sh", "-c", "echo 'no such option'; exit 1" };
  EXPECT_EQ(AskSolverVersion(description), "");
  description.VersionCommand = { "no-such-program-anywhere" };
  EXPECT_EQ(AskSolverVersion(description), "");
}

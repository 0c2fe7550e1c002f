// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
using pemesh::ProgramRun;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::AllOf;
using testing::HasSubstr;

namespace
{

/** x of every vertex as the solution. */
const std::string Good = "sed -n '3,13p' \"$1\" | cut -d' ' -f1 > \"$2-solution.txt\"\n"
                         "echo 1 > \"$2-error.txt\"\n";

class SolversCheck : public testing::Test
{
protected:
  void SetUp() override { this->Folder = TestFolder(); }

  ProgramRun CheckScript(const std::string& script, const std::string& more = "")
  {
    std::ofstream(this->Folder / "s.sh") << "#!/bin/sh\n" << script;
    fs::permissions(this->Folder / "s.sh", fs::perms::owner_all);
    return this->CheckText(R"({"name": "s", "command": ["./s.sh", "{mesh}", "{stem}"],)" + more +
      R"("performances": [{"name": "error"}], "version-command": ["echo", "1"]})");
  }

  ProgramRun CheckText(const std::string& description)
  {
    std::ofstream(this->Folder / "s.json") << description;
    return RunProgram("pemesh", { "solvers", "check", this->Folder / "s.json" });
  }

  fs::path Folder;
};

} // namespace

TEST_F(SolversCheck, AGoodOne)
{
  const ProgramRun run = this->CheckScript(Good);
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Output, "s: OK\n");
}

TEST_F(SolversCheck, EveryFaultIsASentence)
{
  struct Fault
  {
    std::string Script;
    const char* Says;
  };
  const Fault faults[] = {
    { "exit 3", "s ended with exit status 3" },
    { "kill -SEGV $$", "SIGSEGV" },
    { "sleep 60", "time limit of 1 s" },
    { "", "has not written the file \"check-solution.txt\"" },
    { "sed -i 's/x/x/' \"$1\"; echo 1 > \"$2-solution.txt\"", "has 1 number and should have 11" },
    { Good + "echo 2 > \"$2-errors.txt\"; rm \"$2-error.txt\"",
      "It has written \"check-errors.txt\", which nobody asked for" },
    { Good + "echo nan > \"$2-error.txt\"", "\"nan\" in line 1" },
    { Good + "sort -n \"$2-solution.txt\" > t; mv t \"$2-solution.txt\"",
      "must be written in the order of the vertices" },
  };
  for (const Fault& fault : faults)
  {
    SCOPED_TRACE(fault.Script);
    const ProgramRun run = this->CheckScript(fault.Script, R"("time-limit": 1,)");
    EXPECT_EQ(run.ExitCode, 1);
    EXPECT_THAT(run.Output, AllOf(HasSubstr("  error: "), HasSubstr(fault.Says)));
  }
}

TEST_F(SolversCheck, WhatIsNoFaultIsANote)
{
  ProgramRun run = this->CheckScript(Good + "echo 2 > \"$2-time.txt\"\n");
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(
    run.Output, "s: OK\n  note: It has written \"check-time.txt\", which nobody asked for.\n");
  run = this->CheckText(R"({"name": "s", "command": ["./s.sh"]})");
  EXPECT_THAT(run.Output,
    AllOf(HasSubstr("neither {mesh} nor {stem}"), HasSubstr("no performances"),
      HasSubstr("no version-command")));
}

TEST_F(SolversCheck, AMistakeOfTheDescriptionIsNamedByItsKey)
{
  ProgramRun run = this->CheckText(R"({"name": "s", "comand": ["./s.sh"]})");
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_THAT(run.Errors, HasSubstr("comand is not a key; did you mean command?"));
  run = this->CheckText(R"({"name": "s", "command": ["./s.sh", "{mehs}"]})");
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_THAT(run.Errors, AllOf(HasSubstr("command[1]"), HasSubstr("did you mean {mesh}?")));
  run = this->CheckText("{\"name\": \"s\",\n \"command\" [\"a\"]}");
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_THAT(run.Errors, HasSubstr("line 2"));
  run = this->CheckText(R"({"name": "s", "command": ["no-such-program-anywhere", "{mesh}"]})");
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_THAT(run.Output, HasSubstr("The program \"no-such-program-anywhere\" is not there"));
  run = RunProgram("pemesh", { "solvers", "check", "pemesh-wem" });
  EXPECT_EQ(run.ExitCode, 2);
  EXPECT_THAT(run.Errors, HasSubstr("did you mean \"pemesh-vem\"?"));
}

TEST_F(SolversCheck, LeavesNothingButWhereItIsAskedTo)
{
  this->CheckScript(Good);
  EXPECT_EQ(std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()), 2);
  RunProgram(
    "pemesh", { "solvers", "check", this->Folder / "s.json", "-o", this->Folder / "files" });
  EXPECT_TRUE(fs::exists(this->Folder / "files" / "check" / "check-solution.txt"));
}

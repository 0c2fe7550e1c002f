// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

/** How often a study is killed; many times in the nightly build of this test. */
#ifndef PEMESH_KILLS
#define PEMESH_KILLS 4
#endif

long LineCount(const std::string& text)
{
  return std::count(text.begin(), text.end(), '\n');
}

void WriteFile(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/** A study whose solver notes every call in the file `calls` and fails as the folder asks it to. */
class ResumeTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = TestFolder();
    WriteFile(this->Folder / "solver.sh",
      "#!/bin/sh\n"
      "echo \"$2\" >> '" +
        (this->Folder / "calls").string() +
        "'\n"
        "[ ! -e '" +
        (this->Folder / "broken").string() +
        "' ] || exit 7\n"
        "sed -n '3,$p' \"$1\" | while read -r x y z w; do [ -n \"$w\" ] || echo \"$x\"; done"
        " > \"$2-solution.txt\"\n"
        "wc -c < \"$1\" > \"$2-bytes.txt\"\n");
    fs::permissions(this->Folder / "solver.sh", fs::perms::owner_all);
    this->WriteDescription(1);
  }

  void WriteDescription(int factor)
  {
    WriteFile(this->Folder / "solver.json",
      R"({"name": "toy", "command": ["./solver.sh", "{mesh}", "{stem}", "{factor}"],
          "options": [{"name": "factor", "type": "integer", "default": )" +
        std::to_string(factor) + R"(}], "performances": [{"name": "bytes"}]})");
  }

  void WriteStudy(int count, const std::string& more = "")
  {
    WriteFile(this->Folder / "s.json",
      R"({"pemesh": 1, "name": "s", "polygons": [{"family": "zeta"}], "metrics": ["Area"],
          "solvers": [{"solver": "solver.json"}], "output": {"formats": ["vtp", "off"]},)" +
        more + R"( "sweep": [{"parameter": "t", "values": [0)" + this->Values(count) + "]}]}");
  }

  std::string Values(int count) const
  {
    std::string text;
    for (int i = 1; i < count; ++i)
    {
      text += ", " + std::to_string(0.8 * i / count);
    }
    return text;
  }

  pemesh::ProgramRun Run(std::vector<std::string> more, const std::string& output = "out") const
  {
    std::vector<std::string> arguments{ "run", this->Folder / "s.json", "-o", this->Folder / output,
      "-j", "2" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("pemesh", arguments, this->Folder);
  }

  /** Since the last time that this was asked. */
  long NewCalls()
  {
    const std::string text = FileText(this->Folder / "calls");
    const long calls = std::count(text.begin(), text.end(), '\n');
    const long before = std::exchange(this->Calls, calls);
    return calls - before;
  }

  void ExpectSameResults(const std::string& a, const std::string& b) const
  {
    for (const char* name : { "results.csv", "correlation.csv", "index.csv", "series.pvd" })
    {
      EXPECT_EQ(FileText(this->Folder / a / name), FileText(this->Folder / b / name)) << name;
      EXPECT_FALSE(FileText(this->Folder / a / name).empty()) << name;
    }
    for (const auto& entry : fs::directory_iterator(this->Folder / a / "meshes"))
    {
      const fs::path name = entry.path().filename();
      EXPECT_EQ(FileText(entry.path()), FileText(this->Folder / b / "meshes" / name)) << name;
    }
  }

  /**
   * Resumes the study and kills it when the journal has so many rows more, and so many milliseconds
   * later; whether it was still alive.
   */
  int KillAfter(long rows, unsigned milliseconds) const
  {
    const pid_t process = fork();
    if (process == 0)
    {
      const std::string program = PEMESH_BINARY_DIR "/bin/pemesh";
      const std::string study = this->Folder / "s.json";
      const std::string output = this->Folder / "out";
      execl(program.c_str(), "pemesh", "run", study.c_str(), "-o", output.c_str(), "-j", "2",
        "--resume", nullptr);
      _exit(127);
    }
    const fs::path journal = this->Folder / "out" / "journal.tsv";
    const long wanted = rows + LineCount(FileText(journal));
    siginfo_t ended{};
    while (LineCount(FileText(journal)) < wanted && ended.si_pid == 0)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    kill(process, SIGKILL);
    int status = 0;
    waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? 1 : 0;
  }

  fs::path Folder;
  long Calls = 0;
};

} // namespace

TEST_F(ResumeTest, NothingIsDoneTwice)
{
  this->WriteStudy(4);
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 4);
  const std::string results = FileText(this->Folder / "out" / "results.csv");
  const auto again = this->Run({ "--resume" });
  EXPECT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_THAT(again.Output, HasSubstr("4 meshes (4 as they were), 0 failures"));
  EXPECT_EQ(this->NewCalls(), 0);
  EXPECT_EQ(FileText(this->Folder / "out" / "results.csv"), results);
  const auto anew = this->Run({}); // without --resume all is done anew
  ASSERT_EQ(anew.ExitCode, 0) << anew.Errors;
  EXPECT_EQ(this->NewCalls(), 4);
}

TEST_F(ResumeTest, WhatHasChangedIsDoneAgain)
{
  this->WriteStudy(4);
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  this->NewCalls();
  this->WriteDescription(2); // an option
  ASSERT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 4);
  std::ofstream(this->Folder / "solver.sh", std::ios::app) << "# a new version\n";
  ASSERT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 4);
  // Other metrics: the rows are new, and the answers of the solver as they were.
  ASSERT_EQ(this->Run({ "--resume", "--set", "metrics=[\"Area\", \"MinAngle\"]" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 0);
  EXPECT_THAT(FileText(this->Folder / "out" / "results.csv"), HasSubstr("MinAngle_min"));
  // A mesh that is gone is made again.
  fs::remove(this->Folder / "out" / "meshes" / "001_0.200000.off");
  ASSERT_EQ(this->Run({ "--resume", "--set", "metrics=[\"Area\", \"MinAngle\"]" }).ExitCode, 0);
  EXPECT_TRUE(fs::exists(this->Folder / "out" / "meshes" / "001_0.200000.off"));
  // An answer that somebody has changed is no answer to the question.
  WriteFile(
    this->Folder / "out" / "solvers" / "solver" / "001_0.200000" / "001_0.200000-bytes.txt", "1");
  fs::remove(this->Folder / "out" / "meshes" / "001_0.200000.off");
  ASSERT_EQ(this->Run({ "--resume", "--set", "metrics=[\"Area\", \"MinAngle\"]" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 1);
}

TEST_F(ResumeTest, AMeshFileThatHasChangedIsSolvedAgain)
{
  const std::string square = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  const std::string larger = "OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n";
  for (const char* name : { "a.off", "b.off", "c.off" })
  {
    WriteFile(this->Folder / name, square);
  }
  WriteFile(this->Folder / "s.json",
    R"({"pemesh": 1, "meshes": "*.off", "metrics": ["Area"], "solvers": [{"solver": "solver.json"}]})");
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 3);
  WriteFile(this->Folder / "b.off", larger);
  ASSERT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 1);
  EXPECT_THAT(FileText(this->Folder / "out" / "results.csv"), HasSubstr("b,1,4,"));
  ASSERT_EQ(this->Run({}, "fresh").ExitCode, 0);
  this->ExpectSameResults("out", "fresh");
}

TEST_F(ResumeTest, FailuresAreTriedAgain)
{
  this->WriteStudy(3);
  WriteFile(this->Folder / "broken", "");
  const auto broken = this->Run({ "--retry", "2" });
  EXPECT_EQ(broken.ExitCode, 1);
  EXPECT_THAT(broken.Errors, HasSubstr("It was tried 3 times."));
  EXPECT_EQ(this->NewCalls(), 9);
  fs::remove(this->Folder / "broken");
  EXPECT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 3);
  EXPECT_FALSE(fs::exists(this->Folder / "out" / "failures.csv"));
  ASSERT_EQ(this->Run({}, "fresh").ExitCode, 0);
  this->ExpectSameResults("out", "fresh");
}

TEST_F(ResumeTest, NothingOfALongerStudyStays)
{
  this->WriteStudy(6, R"("plots": [{"kind": "line", "y": "Area_min", "file": "old.svg"}],)");
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  WriteFile(this->Folder / "out" / "notes.txt", "mine");
  WriteFile(this->Folder / "out" / "meshes" / "mine.off", "mine");
  const std::string part = ".part999999999-0"; // of a process that was killed
  WriteFile(this->Folder / "out" / ("results.csv" + part), "");
  const fs::path solved = this->Folder / "out" / "solvers" / "solver" / "000_0.000000";
  WriteFile(solved / ("000_0.000000.off" + part), "");
  this->WriteStudy(2);
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  std::set<std::string> meshes;
  for (const auto& entry : fs::directory_iterator(this->Folder / "out" / "meshes"))
  {
    meshes.insert(entry.path().filename());
  }
  EXPECT_THAT(meshes,
    testing::ElementsAre(
      "000_0.000000.off", "000_0.000000.vtp", "001_0.400000.off", "001_0.400000.vtp", "mine.off"));
  EXPECT_FALSE(fs::exists(this->Folder / "out" / "solvers" / "solver" / "005_0.666667"));
  EXPECT_FALSE(fs::exists(this->Folder / "out" / "plots" / "old.svg"));
  EXPECT_FALSE(fs::exists(this->Folder / "out" / ("results.csv" + part)));
  EXPECT_FALSE(fs::exists(solved / ("000_0.000000.off" + part)));
  EXPECT_EQ(FileText(this->Folder / "out" / "notes.txt"), "mine");
}

TEST_F(ResumeTest, HalfAJournalIsAsGoodAsItsWholeLines)
{
  this->WriteStudy(4);
  ASSERT_EQ(this->Run({}).ExitCode, 0);
  this->NewCalls();
  const fs::path journal = this->Folder / "out" / "journal.tsv";
  const std::string whole = FileText(journal);
  const std::string results = FileText(this->Folder / "out" / "results.csv");
  for (const std::size_t length : { std::size_t{ 0 }, whole.size() / 3, whole.size() - 1 })
  {
    WriteFile(journal, whole.substr(0, length));
    fs::remove_all(this->Folder / "out" / "solvers");
    fs::remove(this->Folder / "out" / "results.csv");
    ASSERT_EQ(this->Run({ "--resume" }).ExitCode, 0);
    const std::string kept = whole.substr(0, length);
    const long lines = std::count(kept.begin(), kept.end(), '\n');
    EXPECT_EQ(this->NewCalls(), 4 - std::max(0L, lines - 1)); // the first has the columns
    EXPECT_EQ(FileText(this->Folder / "out" / "results.csv"), results);
  }
  std::string changed = whole;
  changed[changed.find("row") + 60] ^= 1; // a bit of the disk
  WriteFile(journal, changed);
  fs::remove_all(this->Folder / "out" / "solvers");
  ASSERT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 4);
  EXPECT_EQ(FileText(this->Folder / "out" / "results.csv"), results);
}

TEST_F(ResumeTest, KilledAtAnyInstantItGoesOn)
{
  constexpr int meshesPerKill = 4;
  this->WriteStudy(
    meshesPerKill * PEMESH_KILLS, R"("plots": [{"kind": "mesh", "case": 3, "color-by": "Area"}],)");
  ASSERT_EQ(this->Run({}, "undisturbed").ExitCode, 0);
  std::mt19937 engine(20260101);
  int killed = 0;
  for (int i = 0; i < PEMESH_KILLS; ++i)
  {
    killed += this->KillAfter(static_cast<long>(engine() % (2 * meshesPerKill)), engine() % 50);
  }
  EXPECT_GT(killed, PEMESH_KILLS / 2);
  const auto begin = std::chrono::steady_clock::now();
  const auto last = this->Run({ "--resume" });
  const auto length = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(last.ExitCode, 0) << last.Errors;
  this->ExpectSameResults("out", "undisturbed");
  // Also while it writes the tables and the figures.
  for (int i = 0; i < PEMESH_KILLS; i += 5)
  {
    const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(length).count() + 1;
    this->KillAfter(0, engine() % static_cast<unsigned>(milliseconds));
  }
  EXPECT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  this->ExpectSameResults("out", "undisturbed");
  EXPECT_TRUE(fs::exists(this->Folder / "out" / "plots"));
  for (const auto& entry : fs::recursive_directory_iterator(this->Folder / "out"))
  {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

TEST_F(ResumeTest, TwoRunsDoNotShareAFolder)
{
  this->WriteStudy(2);
  WriteFile(this->Folder / "solver.sh", "#!/bin/sh\nsleep 5\n");
  const pid_t process = fork();
  if (process == 0)
  {
    const std::string program = PEMESH_BINARY_DIR "/bin/pemesh";
    const std::string study = this->Folder / "s.json";
    const std::string output = this->Folder / "out";
    execl(program.c_str(), "pemesh", "run", study.c_str(), "-o", output.c_str(), nullptr);
    _exit(127);
  }
  for (int i = 0; i < 500 && !fs::exists(this->Folder / "out" / "solvers"); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const auto second = this->Run({});
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  EXPECT_EQ(second.ExitCode, 2);
  EXPECT_THAT(second.Errors, HasSubstr("Another run is writing into"));
}

TEST_F(ResumeTest, SolversWaitForMemory)
{
  this->WriteStudy(4);
  // Fails where another one is at work.
  WriteFile(this->Folder / "solver.sh",
    "#!/bin/sh\n"
    "mkdir '" +
      (this->Folder / "lock").string() + "' || exit 9\nsleep 0.2\nrmdir '" +
      (this->Folder / "lock").string() +
      "'\n"
      "sed -n '3,$p' \"$1\" | while read -r x y z w; do [ -n \"$w\" ] || echo \"$x\"; done"
      " > \"$2-solution.txt\"\necho 1 > \"$2-bytes.txt\"\n");
  const std::string limit = "solvers[0].memory-limit=100";
  EXPECT_EQ(this->Run({ "--set", limit, "--memory", "150" }).ExitCode, 0);
  EXPECT_EQ(this->Run({ "--set", limit, "--memory", "200" }).ExitCode, 1) << "two at a time";
}

TEST_F(ResumeTest, SolversThatTakeListsResumeMeshByMesh)
{
  WriteFile(this->Folder / "list.sh",
    "#!/bin/sh\n"
    "cat \"$1\" >> '" +
      (this->Folder / "calls").string() +
      "'\n"
      "while IFS= read -r mesh; do\n"
      "  case $mesh in 002_*) [ ! -e '" +
      (this->Folder / "broken").string() +
      "' ] || exit 7 ;; esac\n"
      "  sed -n '3,$p' \"$mesh\" | while read -r x y z w; do [ -n \"$w\" ] || echo \"$x\"; done"
      " > \"${mesh%.off}-solution.txt\"\n"
      "  wc -c < \"$mesh\" > \"${mesh%.off}-bytes.txt\"\n"
      "done < \"$1\"\n");
  fs::permissions(this->Folder / "list.sh", fs::perms::owner_all);
  WriteFile(this->Folder / "solver.json",
    R"({"name": "toy", "command": ["./list.sh", "{list}"], "meshes-per-call": 3,
        "performances": [{"name": "bytes"}]})");
  this->WriteStudy(6);
  EXPECT_EQ(this->Run({}, "whole").ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 6);
  WriteFile(this->Folder / "broken", "");
  EXPECT_EQ(this->Run({}).ExitCode, 1);
  // The three of the call that went wrong were solved once more, alone.
  EXPECT_EQ(this->NewCalls(), 9);
  EXPECT_EQ(LineCount(FileText(this->Folder / "out" / "failures.csv")), 2); // header and one mesh
  fs::remove(this->Folder / "broken");
  EXPECT_EQ(this->Run({ "--resume" }).ExitCode, 0);
  EXPECT_EQ(this->NewCalls(), 1);
  this->ExpectSameResults("whole", "out");
}

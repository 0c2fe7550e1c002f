// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Studies over several processes by mpiexec. They must leave what one process leaves, whatever
 * dies.
 */
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::TestFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

void WriteFile(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/** mpiexec as any user, on this machine alone, with more processes than cores. */
std::vector<std::string> Launch(int processes)
{
  return { "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", PEMESH_MPIEXEC, "-n",
    std::to_string(processes), "--oversubscribe", "--bind-to", "none", "--mca", "btl", "self,vader",
    "--mca", "btl_vader_single_copy_mechanism", "none", "--mca", "oob_tcp_if_include", "lo" };
}

/** A study whose solver notes who has called it, and does as the folder asks it to. */
class RanksTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = TestFolder();
    const std::string folder = "'" + this->Folder.string() + "'";
    WriteFile(this->Folder / "solver.sh",
      "#!/bin/sh\n"
      "mesh=$(basename \"$1\")\n"
      "caller=$PPID\n" // above those that watch over the solver
      "while [ $caller -gt 1 ] && [ \"$(cat /proc/$caller/comm)\" != pemesh ]; do\n"
      "  caller=$(awk '/^PPid/ {print $2}' /proc/$caller/status)\n"
      "done\n"
      "echo \"$mesh\" $caller >> " +
        folder +
        "/calls\n"
        "env | grep -E '^(OMPI_COMM|PMIX|PMI)_' >> " +
        folder +
        "/launcher\n"
        "if [ -e " +
        folder + "/slow ]; then sleep 0.3; fi\n" +
        "case $mesh in\n"
        "  002_*) [ ! -e " +
        folder +
        "/broken ] || exit 7 ;;\n"
        "  004_*) [ ! -e " +
        folder +
        "/broken ] || kill -9 $$ ;;\n"
        "esac\n"
        "sed -n '3,$p' \"$1\" | while read -r x y z w; do [ -n \"$w\" ] || echo \"$x\"; done"
        " > \"$2-solution.txt\"\n"
        "wc -c < \"$1\" > \"$2-bytes.txt\"\n");
    fs::permissions(this->Folder / "solver.sh", fs::perms::owner_all);
    WriteFile(this->Folder / "solver.json",
      R"({"name": "toy", "command": ["./solver.sh", "{mesh}", "{stem}"],
          "performances": [{"name": "bytes"}]})");
    this->WriteStudy(12);
  }

  void WriteStudy(int count, const std::string& more = "")
  {
    WriteFile(this->Folder / "s.json",
      R"({"pemesh": 1, "name": "s", "polygons": [{"family": "zeta"}], "metrics": ["Area"],
          "solvers": [{"solver": "solver.json"}], "output": {"formats": ["off"]},
          "plots": [{"kind": "mesh", "case": -1, "color-by": "Area", "file": "last.svg"},
                    {"kind": "mesh", "case": 1, "color-by": "solver_Solution", "file": "first.svg"}],)" +
        more + R"( "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": )" +
        std::to_string(count) + "}]}");
  }

  std::vector<std::string> Arguments(const std::string& output) const
  {
    return { PEMESH_BINARY_DIR "/bin/pemesh", "run", this->Folder / "s.json", "-o",
      this->Folder / output, "-j", "1" };
  }

  pemesh::ProgramRun Run(
    int processes, const std::string& output, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments = Launch(processes);
    const std::vector<std::string> own = this->Arguments(output);
    arguments.insert(arguments.end(), own.begin(), own.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pemesh::RunProgram("/usr/bin/env", arguments);
  }

  pemesh::ProgramRun RunAlone(
    const std::string& output, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments = this->Arguments(output);
    arguments.erase(arguments.begin());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pemesh::RunProgram("pemesh", arguments);
  }

  /** Starts processes and does not wait for them; answers with the process of mpiexec. */
  pid_t Start(int processes, const std::string& output) const
  {
    std::vector<std::string> arguments = Launch(processes);
    const std::vector<std::string> own = this->Arguments(output);
    arguments.insert(arguments.begin(), "/usr/bin/env");
    arguments.insert(arguments.end(), own.begin(), own.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
    {
      pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    const pid_t process = fork();
    if (process == 0)
    {
      execv("/usr/bin/env", pointers.data());
      _exit(127);
    }
    return process;
  }

  /** Waits until the solver was called so often. */
  void WaitForCalls(long count) const
  {
    const auto calls = [this]
    {
      const std::string text = FileText(this->Folder / "calls");
      return std::count(text.begin(), text.end(), '\n');
    };
    for (int i = 0; i < 1000 && calls() < count; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_GE(calls(), count);
  }

  /** The processes that have called the solver. */
  std::set<std::string> Callers() const
  {
    std::set<std::string> callers;
    std::ifstream stream(this->Folder / "calls");
    for (std::string mesh, caller; stream >> mesh >> caller;)
    {
      callers.insert(caller);
    }
    return callers;
  }

  void ExpectSameResults(const std::string& a, const std::string& b) const
  {
    for (const char* part : { "", "meshes", "plots" })
    {
      for (const auto& entry : fs::directory_iterator(this->Folder / a / part))
      {
        const fs::path name = entry.path().filename();
        if (entry.is_regular_file() && name != "timings.csv" && name != "journal.tsv")
        {
          EXPECT_EQ(FileText(entry.path()), FileText(this->Folder / b / part / name)) << name;
        }
      }
    }
  }

  fs::path Folder;
};

} // namespace

TEST_F(RanksTest, ResultsAreThoseOfOneProcess)
{
  ASSERT_EQ(this->RunAlone("alone").ExitCode, 0);
  for (const int processes : { 2, 4 })
  {
    fs::remove(this->Folder / "calls");
    const std::string output = "over" + std::to_string(processes);
    const auto run = this->Run(processes, output);
    EXPECT_EQ(run.ExitCode, 0) << run.Errors;
    EXPECT_THAT(run.Output, HasSubstr("12 meshes, 0 failures")) << "told once";
    EXPECT_EQ(run.Output.find("12 meshes"), run.Output.rfind("12 meshes"));
    EXPECT_THAT(run.Errors, HasSubstr("run 100 %"));
    EXPECT_GT(this->Callers().size(), 1U) << "only one process has worked";
    this->ExpectSameResults("alone", output);
    EXPECT_FALSE(FileText(this->Folder / output / "plots" / "last.svg").empty());
  }
  EXPECT_EQ(FileText(this->Folder / "launcher"), "") << "a solver that uses MPI would join us";
}

TEST_F(RanksTest, FailuresAndDyingSolversStayAlone)
{
  WriteFile(this->Folder / "broken", "");
  ASSERT_EQ(this->RunAlone("alone").ExitCode, 1);
  const auto run = this->Run(3, "over");
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_THAT(run.Output, HasSubstr("12 meshes, 2 failures"));
  this->ExpectSameResults("alone", "over");
  EXPECT_THAT(FileText(this->Folder / "over" / "failures.csv"), HasSubstr("002_"));
  fs::remove(this->Folder / "broken");
  fs::remove(this->Folder / "calls");
  const auto again = this->Run(3, "over", { "--resume" });
  EXPECT_EQ(again.ExitCode, 0) << again.Errors;
  // Without a .vtp the two meshes of figures are made again too.
  EXPECT_THAT(again.Output, HasSubstr("12 meshes (8 as they were), 0 failures"));
  ASSERT_EQ(this->RunAlone("alone", { "--resume" }).ExitCode, 0);
  this->ExpectSameResults("alone", "over");
}

TEST_F(RanksTest, WhatIsWrongEndsAllProcesses)
{
  const auto unknown = this->Run(3, "out", { "--set", "mesh.no-such-key=1" });
  EXPECT_EQ(unknown.ExitCode, 2);
  EXPECT_THAT(unknown.Errors, HasSubstr("no-such-key"));
  WriteFile(this->Folder / "foreign" / "mine.txt", "mine");
  const auto foreign = this->Run(3, "foreign");
  EXPECT_EQ(foreign.ExitCode, 2);
  EXPECT_THAT(foreign.Errors, HasSubstr("holds something else"));
}

TEST_F(RanksTest, AProcessThatDiesCostsNoMore)
{
  ASSERT_EQ(this->RunAlone("alone").ExitCode, 0);
  fs::remove(this->Folder / "calls");
  WriteFile(this->Folder / "slow", "");
  const pid_t launcher = this->Start(3, "over");
  this->WaitForCalls(5);
  for (const std::string& caller : this->Callers())
  {
    kill(static_cast<pid_t>(std::stol(caller)), SIGKILL);
    break;
  }
  int status = 0;
  waitpid(launcher, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 0);
  fs::remove(this->Folder / "slow");
  const auto again = this->Run(3, "over", { "--resume" });
  EXPECT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_THAT(again.Output, HasSubstr("as they were"));
  this->ExpectSameResults("alone", "over");
}

TEST_F(RanksTest, AnInterruptKeepsWhatIsDone)
{
  ASSERT_EQ(this->RunAlone("alone").ExitCode, 0);
  fs::remove(this->Folder / "calls");
  WriteFile(this->Folder / "slow", "");
  const pid_t launcher = this->Start(2, "over");
  this->WaitForCalls(5);
  kill(launcher, SIGINT);
  int status = 0;
  waitpid(launcher, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 0);
  fs::remove(this->Folder / "slow");
  const auto again = this->Run(2, "over", { "--resume" });
  EXPECT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_THAT(again.Output, HasSubstr("as they were"));
  this->ExpectSameResults("alone", "over");
}

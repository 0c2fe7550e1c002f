// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChildProcess.h"

#include "TestMeshes.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>

using namespace pemesh;
using Ending = ChildProcessResult::Ending;

namespace
{

ChildProcess Shell(const std::filesystem::path& folder, const std::string& script)
{
  ChildProcess child;
  child.Arguments = { "/bin/sh", "-c", script };
  child.WorkingDirectory = folder;
  child.OutputFile = folder / "out";
  child.ErrorFile = folder / "err";
  return child;
}

class StopWatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/** Whether a process is gone, given a moment to go: init has to notice orphans. */
bool IsGone(pid_t process)
{
  for (int i = 0; i < 100; ++i)
  {
    const std::string state = ReadBytes("/proc/" + std::to_string(process) + "/stat");
    if (state.empty() || state.find(") Z ") != std::string::npos)
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/** How many processes a file names, all of which must be gone. */
int CountGone(const std::filesystem::path& path)
{
  std::istringstream pids(ReadBytes(path));
  int count = 0;
  for (pid_t pid = 0; pids >> pid; ++count)
  {
    EXPECT_TRUE(IsGone(pid)) << pid;
  }
  return count;
}

} // namespace

TEST(ChildProcess, GivesOutputAndStatus)
{
  const std::filesystem::path folder = TestFolder();
  const ChildProcessResult result =
    RunChildProcess(Shell(folder, "echo one; echo two >&2; echo ' three ' >&2; echo >&2; exit 7"));
  EXPECT_EQ(result.How, Ending::Exited);
  EXPECT_EQ(result.ExitStatus, 7);
  EXPECT_EQ(ReadBytes(folder / "out"), "one\n");
  EXPECT_EQ(ReadBytes(folder / "err"), "two\n three \n\n");
  EXPECT_EQ(result.LastErrorLine, "three");
}

TEST(ChildProcess, PassesArgumentsUntouched)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child = Shell(folder, "printf '%s|' \"$@\"");
  const std::vector<std::string> arguments{ "a b", "", "\"q\"", "'s'", "$HOME", "`ls`", "a;b|c&",
    "*", "\\", "größe 网格", "new\nline", "-x" };
  child.Arguments.push_back("sh");
  child.Arguments.insert(child.Arguments.end(), arguments.begin(), arguments.end());
  RunChildProcess(child);
  std::string expected;
  for (const std::string& argument : arguments)
  {
    expected += argument + '|';
  }
  EXPECT_EQ(ReadBytes(folder / "out"), expected);
}

TEST(ChildProcess, RunsInItsFolderWithItsEnvironmentAndNoInput)
{
  const std::filesystem::path folder = TestFolder() / "a folder";
  std::filesystem::create_directories(folder);
  setenv("LC_ALL", "C.UTF-8", 1);
  ChildProcess child = Shell(folder, "pwd; echo $X; echo [$LC_ALL] $LC_NUMERIC $LC_CTYPE; cat");
  child.Environment = { { "X", "y = z" } };
  RunChildProcess(child);
  unsetenv("LC_ALL");
  EXPECT_EQ(ReadBytes(folder / "out"), folder.string() + "\ny = z\n[] C C.UTF-8\n");
}

TEST(ChildProcess, ADefaultActionForEverySignal)
{
  const std::filesystem::path folder = TestFolder();
  const auto before = std::signal(SIGPIPE, SIG_IGN); // as Python does
  const ChildProcessResult result = RunChildProcess(Shell(folder, "kill -PIPE $$; echo alive"));
  std::signal(SIGPIPE, before);
  EXPECT_EQ(result.How, Ending::Signal);
  EXPECT_THAT(result.Reason, testing::HasSubstr("SIGPIPE"));
}

TEST(ChildProcess, TellsSignals)
{
  const ChildProcessResult result = RunChildProcess(Shell(TestFolder(), "kill -ABRT $$"));
  EXPECT_EQ(result.How, Ending::Signal);
  EXPECT_EQ(result.Reason, "SIGABRT, Aborted");
}

TEST(ChildProcess, TellsWhyItDidNotStart)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child = Shell(folder, "");
  child.Arguments = { (folder / "missing").string() };
  ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::NotStarted);
  EXPECT_TRUE(result.IsMissing);

  WriteBytes(folder / "text", "no program");
  child.Arguments = { (folder / "text").string() };
  result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::NotStarted);
  EXPECT_FALSE(result.IsMissing);
  EXPECT_EQ(result.Reason, "Permission denied");

  child = Shell(folder, "true");
  child.WorkingDirectory = folder / "nowhere";
  result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::NotStarted);
  EXPECT_THAT(result.Reason, testing::HasSubstr("nowhere"));

  EXPECT_EQ(RunChildProcess({}).How, Ending::NotStarted);
}

TEST(ChildProcess, SaysWhichLogCannotBeWritten)
{
  ChildProcess child = Shell(TestFolder(), "true");
  child.ErrorFile = "/nowhere/err";
  EXPECT_THAT([&] { RunChildProcess(child); },
    testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("/nowhere/err")));
}

TEST(ChildProcess, EndsAtTheTimeLimitWithAllItsChildren)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child = Shell(folder, "sleep 60 & echo $!; sleep 60 & echo $!; echo late >&2; wait");
  child.TimeLimit = 1.0;
  const StopWatch watch;
  const ChildProcessResult result = RunChildProcess(child);
  EXPECT_LT(watch.Seconds(), 40.0); // a sleeper sleeps for 60
  EXPECT_GE(watch.Seconds(), 1.0);
  EXPECT_EQ(result.How, Ending::TimeLimit);
  EXPECT_EQ(result.LastErrorLine, "late");
  EXPECT_EQ(CountGone(folder / "out"), 2);
}

TEST(ChildProcess, EndsEvenIfItDoesNotListen)
{
  ChildProcess child = Shell(TestFolder(), "trap '' TERM; while :; do sleep 0.1; done");
  child.TimeLimit = 0.7;
  const StopWatch watch;
  EXPECT_EQ(RunChildProcess(child).How, Ending::TimeLimit);
  EXPECT_LT(watch.Seconds(), 40.0); // a sleeper sleeps for 60
}

TEST(ChildProcess, MayCleanUpWhenItIsEnded)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child =
    Shell(folder, "trap 'echo cleaned; exit 1' TERM; while :; do sleep 0.05; done");
  child.TimeLimit = 1.0;
  EXPECT_EQ(RunChildProcess(child).How, Ending::TimeLimit);
  EXPECT_EQ(ReadBytes(folder / "out"), "cleaned\n");
}

TEST(ChildProcess, IsCancelledWhileItSleeps)
{
  ChildProcess child = Shell(TestFolder(), "sleep 60 & wait");
  double last = -1.0;
  int calls = 0;
  child.GoOn = [&](double seconds)
  {
    EXPECT_GE(seconds, last);
    last = seconds;
    return ++calls < 4;
  };
  const StopWatch watch;
  EXPECT_EQ(RunChildProcess(child).How, Ending::Cancelled);
  EXPECT_EQ(calls, 4);                     // not asked again
  EXPECT_LT(watch.Seconds(), last + 20.0); // the sleeper sleeps for 60
}

TEST(ChildProcess, LeavesNobodyBehindAfterAGoodEnd)
{
  const std::filesystem::path folder = TestFolder();
  const StopWatch watch;
  // The child that stays holds the pipes open: the end of the leader counts.
  const ChildProcessResult result = RunChildProcess(Shell(folder, "sleep 60 & echo $!; exit 0"));
  EXPECT_LT(watch.Seconds(), 40.0); // a sleeper sleeps for 60
  EXPECT_EQ(result.How, Ending::Exited);
  EXPECT_TRUE(IsGone(std::stoi(ReadBytes(folder / "out"))));
}

TEST(ChildProcess, CutsLongLogsAndKeepsTheLastLine)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child =
    Shell(folder, "i=0; while [ $i -lt 2000 ]; do echo line $i; echo e $i >&2; i=$((i+1)); done");
  child.OutputLimit = 1000;
  const ChildProcessResult result = RunChildProcess(child);
  const std::string text = ReadBytes(folder / "out");
  EXPECT_THAT(text, testing::StartsWith("line 0\nline 1\n"));
  EXPECT_THAT(text, testing::EndsWith("only its beginning is kept.]\n"));
  EXPECT_LT(text.size(), 1100U);
  EXPECT_EQ(result.LastErrorLine, "e 1999");
}

TEST(ChildProcess, EndsWhatHidesInASessionOfItsOwn)
{
  const std::filesystem::path folder = TestFolder();
  // The first is deaf to SIGTERM, the second has lost its parent, the third is of the group.
  const std::string deaf = "trap \"\" TERM HUP; echo $$; while :; do sleep 0.1; done";
  ChildProcess child = Shell(folder,
    "setsid sh -c '" + deaf + "' & (setsid sh -c 'echo $$; sleep 60' &); sleep 60 & echo $!; wait");
  child.TimeLimit = 1.0;
  EXPECT_EQ(RunChildProcess(child).How, Ending::TimeLimit);
  EXPECT_EQ(CountGone(folder / "out"), 3);
  child = Shell(folder, "setsid sh -c '" + deaf + "' & sleep 0.5; exit 0");
  const ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::Exited);
  EXPECT_GE(result.ProcessesLeft, 1);
  EXPECT_EQ(CountGone(folder / "out"), 1);
}

TEST(ChildProcess, NothingGoesOnWhenThisProgramIsKilled)
{
  const std::filesystem::path folder = TestFolder();
  const pid_t user = fork();
  if (user == 0)
  {
    RunChildProcess(Shell(folder,
      "setsid sleep 60 & echo $!; echo $$; trap '' TERM; "
      "while :; do sleep 0.1; done"));
    _exit(0);
  }
  const auto hasStarted = [&]
  {
    const std::string pids = ReadBytes(folder / "out");
    return std::count(pids.begin(), pids.end(), '\n') == 2;
  };
  for (int i = 0; i < 500 && !hasStarted(); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(user, SIGKILL);
  waitpid(user, nullptr, 0);
  EXPECT_EQ(CountGone(folder / "out"), 2);
}

TEST(ChildProcess, ASolverThatKillsItsSupervisorEndsToo)
{
  const std::filesystem::path folder = TestFolder();
  const ChildProcessResult result =
    RunChildProcess(Shell(folder, "sleep 60 & echo $!; echo $$; kill -KILL $PPID; sleep 60"));
  EXPECT_EQ(result.How, Ending::Signal);
  EXPECT_THAT(result.Reason, testing::HasSubstr("supervisor"));
  EXPECT_EQ(CountGone(folder / "out"), 2);
}

// In a session of its own, without the environment, and deaf.
TEST(ChildProcess, WhatHidesEndsEvenIfTheSupervisorIsKilled)
{
  const std::filesystem::path folder = TestFolder();
  const ChildProcessResult result = RunChildProcess(Shell(folder,
    "setsid sleep 60 & echo $!; (env -i setsid sh -c 'trap \"\" TERM HUP; echo $$; sleep 60' &); "
    "sleep 0.3; kill -KILL $PPID; sleep 60"));
  EXPECT_EQ(result.How, Ending::Signal);
  EXPECT_THAT(result.Reason, testing::HasSubstr("supervisor"));
  EXPECT_EQ(CountGone(folder / "out"), 2);
}

TEST(ChildProcess, KeepsTheLimitOfProcessorTime)
{
  // Two at a time: of all processes together.
  ChildProcess child = Shell(TestFolder(), "(while :; do :; done) & while :; do :; done");
  child.ProcessorLimit = 0.5;
  child.TimeLimit = 60.0;
  const ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::ProcessorLimit);
  EXPECT_GE(result.ProcessorSeconds, 0.5);
  EXPECT_LT(result.ProcessorSeconds, 20.0);
}

TEST(ChildProcess, KeepsTheLimitOfMemory)
{
  constexpr double mebi = 1 << 20;
  // tail keeps the last line, which has no end, in memory.
  ChildProcess child = Shell(TestFolder(), "head -c 3000000000 /dev/zero | tail -n 1 | wc -c");
  child.MemoryLimit = 100.0 * mebi;
  child.TimeLimit = 60.0;
  ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::MemoryLimit);
  EXPECT_GE(result.PeakMemory, 100.0 * mebi);
  child = Shell(TestFolder(), "head -c 50000000 /dev/zero | tail -n 1 | wc -c");
  child.MemoryLimit = 500.0 * mebi;
  result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::Exited);
  EXPECT_GE(result.PeakMemory, 50000000.0);
  EXPECT_LT(result.PeakMemory, 100.0 * mebi);
}

TEST(ChildProcess, KeepsTheLimitOfFiles)
{
  const std::filesystem::path folder = TestFolder();
  ChildProcess child = Shell(folder, "exec head -c 5000000 /dev/zero > large");
  child.FileLimit = 1000000.0;
  const ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::Signal);
  EXPECT_TRUE(result.IsFileTooLarge);
  EXPECT_EQ(std::filesystem::file_size(folder / "large"), 1000000U);
}

TEST(ChildProcess, ManyThreadsAtOnce)
{
  constexpr int threads = 8;
  constexpr int processes = 25;
  const std::filesystem::path root = TestFolder();
  std::atomic<int> wrong{ 0 };
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t)
  {
    workers.emplace_back(
      [&, t]
      {
        const std::filesystem::path folder = root / std::to_string(t);
        std::filesystem::create_directories(folder);
        for (int p = 0; p < processes; ++p)
        {
          // Every other one leaves a child that would hold any pipe it has inherited.
          const int status = (t * processes + p) % 200;
          ChildProcess child = Shell(folder,
            (p % 2 == 0 ? "sleep 100 & " : "") + std::string("echo ") + std::to_string(status) +
              "; exit " + std::to_string(status));
          const ChildProcessResult result = RunChildProcess(child);
          const bool good = result.How == Ending::Exited && result.ExitStatus == status &&
            ReadBytes(folder / "out") == std::to_string(status) + "\n";
          wrong += good ? 0 : 1;
        }
      });
  }
  const StopWatch watch;
  for (std::thread& worker : workers)
  {
    worker.join();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(watch.Seconds(), 75.0); // nobody waited for a sleeper
}

TEST(ChildProcess, ThousandsOfShortChildrenDoNotDisturbTheWatch)
{
  const std::filesystem::path folder = TestFolder();
  // Every subshell is a process that may end while the supervisor looks at it.
  ChildProcess child = Shell(folder,
    "i=0; while [ $i -lt 1000 ]; do (:) & (:); i=$((i + 1)); done; wait; echo done; exit 5");
  child.MemoryLimit = 1e12; // it is measured all the time
  const ChildProcessResult result = RunChildProcess(child);
  EXPECT_EQ(result.How, Ending::Exited) << result.Reason;
  EXPECT_EQ(result.ExitStatus, 5);
  EXPECT_EQ(ReadBytes(folder / "out"), "done\n");
  EXPECT_GT(result.PeakMemory, 0.0);
}

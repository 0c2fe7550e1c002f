// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One study, one mesh, and a solver for every way in which a solver can go wrong, all at the same
 * time, in a folder with an unkind name.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using testing::HasSubstr;

namespace
{

struct FakeSolver
{
  const char* Name;
  const char* Script; // sees $mesh, $output, $stem, $base, and the function answer
  const char* Status; // what becomes of it; words with | between where it depends on the system
  const char* Says = "";
};

const FakeSolver FakeSolvers[] = {
  // Good ones, however odd.
  { "good", "answer", "ok" },
  { "slow", "sleep 0.3; answer", "ok" },
  { "no-truth", "answer; rm \"$base-ground-truth.txt\"", "ok" },
  { "silent", "exec >&- 2>&-; answer", "ok" },
  { "reads-input", "cat; answer", "ok" },
  { "deletes-mesh", "answer; rm \"$mesh\"", "ok" },
  { "changes-mesh", "answer; echo rubbish > \"$mesh\"", "ok" },
  { "noise", "head -c 100000 /dev/urandom; head -c 100000 /dev/urandom >&2; answer", "ok" },
  { "chatty", "yes | head -c 200000000; answer", "ok" },
  { "windows", "answer; printf '1\\r\\n2\\r\\n3\\r\\n4\\r\\n' > \"$base-solution.txt\"", "ok" },
  { "one-line", "answer; printf '1 2 3 4' > \"$base-solution.txt\"", "ok" },
  { "extra-files", "answer; echo 1 > \"$output/notes\"; mkdir \"$output/work\"", "ok" },
  { "leaves-child", "answer; sleep 60 &", "ok" },
  { "leaves-daemon", "answer; (setsid sleep 60 &)", "ok" },
  { "leaves-deaf-daemon", "answer; (setsid sh -c 'trap \"\" TERM HUP; sleep 60; sleep 60' &)",
    "ok" },
  { "elsewhere", "cd /; answer", "ok" },
  // Exit codes and signals.
  { "exit-1", "answer; exit 1", "exit-status", "exit status 1" },
  { "exit-3", "echo 'singular matrix' >&2; exit 3", "exit-status", "singular matrix" },
  { "exit-127", "no-such-program", "exit-status", "127" },
  { "exit-255", "exit 255", "exit-status", "255" },
  { "segv", "kill -SEGV $$", "crashed", "SIGSEGV" },
  { "abrt", "kill -ABRT $$", "crashed", "SIGABRT" },
  { "kill", "kill -KILL $$", "crashed", "SIGKILL" },
  { "term", "kill -TERM $$", "crashed", "SIGTERM" },
  { "fpe", "kill -FPE $$", "crashed", "SIGFPE" },
  { "group", "kill -KILL 0", "crashed", "SIGKILL" },
  { "supervisor", "kill -KILL $PPID; sleep 60", "crashed", "supervisor" },
  { "supervisor-daemon", "setsid sleep 60 & (env -i setsid sleep 60 &); kill -KILL $PPID; sleep 60",
    "crashed", "supervisor" },
  // Endless.
  { "hangs", "sleep 60", "time-out", "time limit of 3 s" },
  { "hangs-child", "sleep 60 & sleep 60 & wait", "time-out" },
  { "hangs-deaf", "trap '' TERM HUP INT; while :; do sleep 0.2; done", "time-out" },
  { "hangs-session", "setsid sh -c 'trap \"\" TERM; sleep 60; sleep 60'", "time-out" },
  { "hangs-orphan", "(setsid sh -c 'trap \"\" TERM; sleep 60; sleep 60' &); sleep 60", "time-out" },
  { "hangs-silent", "exec >&- 2>&- <&-; sleep 60", "time-out" },
  { "stopped", "kill -STOP $$", "time-out" },
  { "busy", "while :; do :; done", "cpu-limit|time-out", "s" },
  { "forks", "i=0; while [ $i -lt 30 ]; do sleep 60 & i=$((i + 1)); done; wait", "time-out" },
  { "endless-output", "exec yes", "cpu-limit|time-out" },
  { "endless-errors", "exec yes >&2", "cpu-limit|time-out", "last wrote: y" },
  // Too much.
  { "memory", "head -c 3000000000 /dev/zero | tail -n 1", "memory-limit", "150 MiB" },
  { "large-file", "head -c 100000000 /dev/zero > \"$base-solution.txt\"",
    "disk-limit|exit-status|bad-output" },
  { "sparse-file", "truncate -s 10G \"$base-solution.txt\"", "disk-limit|exit-status|bad-output" },
  { "many-files",
    "i=0; while [ $i -lt 50 ]; do head -c 2000000 /dev/zero > \"$output/$i\"; sleep 0.05; "
    "i=$((i + 1)); done",
    "disk-limit", "20 MiB" },
  { "long-answer", "answer; head -c 3000000 /dev/zero | tr '\\000' 1 > \"$base-solution.txt\"",
    "partial", "3000000 bytes" },
  // Answers that are none.
  { "no-files", "true", "bad-output", "has not written" },
  { "empty", "answer; : > \"$base-solution.txt\"", "partial", "0 numbers" },
  { "few", "answer; sed -i 1d \"$base-solution.txt\"", "partial", "3 numbers" },
  { "many", "answer; echo 1 >> \"$base-solution.txt\"", "partial", "5 numbers" },
  { "nan", "answer; echo nan > \"$base-number.txt\"", "partial", "\"nan\"" },
  { "infinite", "answer; echo 1e999 > \"$base-number.txt\"", "partial", "1e999" },
  { "comma", "answer; echo 0,5 > \"$base-number.txt\"", "partial", "0,5" },
  { "words", "answer; echo 'error: none' > \"$base-solution.txt\"", "partial", "error:" },
  { "rubbish", "answer; head -c 5000 /dev/urandom > \"$base-solution.txt\"", "partial" },
  { "zeros", "answer; head -c 5000 /dev/zero > \"$base-solution.txt\"", "partial" },
  { "no-number", "answer; rm \"$base-number.txt\"", "partial", "number.txt" },
  { "wrong-mesh", "base=$output/other; answer", "bad-output", "other-number.txt" },
  { "late", "(sleep 2; answer) &", "bad-output", "left running" },
  { "link", "answer; mv \"$base-solution.txt\" \"$output/x\"; ln -s x \"$base-solution.txt\"",
    "partial", "is a link" },
  { "link-to-nowhere", "answer; ln -sf /nowhere \"$base-solution.txt\"", "partial", "is a link" },
  { "endless-link", "answer; ln -sf /dev/zero \"$base-solution.txt\"", "partial", "is a link" },
  { "pipe", "answer; rm \"$base-solution.txt\"; mkfifo \"$base-solution.txt\"", "partial",
    "special file" },
  { "folder", "answer; rm \"$base-solution.txt\"; mkdir -p \"$base-solution.txt/x\"", "partial",
    "is a folder" },
  { "forbidden", "answer; chmod 000 \"$base-solution.txt\"", "ok|partial" }, // root may read it
  { "no-folder", "answer; rm -r \"$output\"", "bad-output", "removed its own folder" },
  { "link-folder", "answer; mv \"$output\" \"$output-moved\"; ln -s \"$precious\" \"$output\"",
    "bad-output", "link in place of its own folder" },
  { "link-logs",
    "answer; for f in stdout.log stderr.log command.txt; do ln -sf "
    "\"$precious/precious\" \"$output/$f\"; done; exit 1",
    "exit-status" },
  { "other-folder", "answer; mv \"$output\" \"$output-moved\"; mkdir \"$output\"", "bad-output" },
};

const char* const SolverScript = R"(#!/bin/sh
mode=$1 mesh=$2 output=$3 stem=$4 precious=${0%/*}/out-of-bounds
base=$output/$stem
answer()
{
  printf '1\n2\n3\n4\n' > "$base-solution.txt"
  printf '1\n2\n3\n4\n' > "$base-ground-truth.txt"
  echo 1.5 > "$base-number.txt"
}
. "${0%/*}/modes/$mode"
)";

void WriteFile(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/** Processes that have inherited the mark of this test, the test itself aside. */
std::vector<std::string> MarkedProcesses(const std::string& mark)
{
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator("/proc"))
  {
    const std::string name = entry.path().filename();
    if (std::isdigit(static_cast<unsigned char>(name[0])) && std::stol(name) != getpid() &&
      FileText(entry.path() / "environ").find(mark) != std::string::npos)
    {
      found.push_back(FileText(entry.path() / "cmdline"));
    }
  }
  return found;
}

/** All files below a folder but for those in its folder "out", with their contents. */
std::map<std::string, std::string> FilesOf(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry)
  {
    if (entry->path() == folder / "out")
    {
      entry.disable_recursion_pending();
    }
    else
    {
      files[entry->path()] = entry->is_regular_file() ? FileText(entry->path()) : "";
    }
  }
  return files;
}

/** Whether the number of a fake solver that ends well is a good one. */
bool HasGoodNumber(const FakeSolver& fake)
{
  return std::string(fake.Script).find("$base-number.txt") == std::string::npos;
}

std::set<std::string> NamesIn(const fs::path& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    names.insert(entry.path().filename());
  }
  return names;
}

std::string MakeStudy(const fs::path& folder, std::span<const FakeSolver> fakes)
{
  WriteFile(folder / "a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  WriteFile(folder / "solver.sh", SolverScript);
  fs::permissions(folder / "solver.sh", fs::perms::owner_all);
  std::string modes;
  for (const FakeSolver& fake : fakes)
  {
    WriteFile(folder / "modes" / fake.Name, fake.Script + std::string("\n"));
    modes += (modes.empty() ? "\"" : ", \"") + std::string(fake.Name) + '"';
  }
  WriteFile(folder / "fake.json",
    R"({"name": "fake", "command": ["./solver.sh", "{mode}", "{mesh}", "{output}", "{stem}"],
        "time-limit": 3, "cpu-limit": 2, "memory-limit": 150, "disk-limit": 20,
        "options": [{"name": "mode"}], "performances": [{"name": "number"}]})");
  WriteFile(folder / "s.json",
    R"({"pemesh": 1, "meshes": "a.off", "metrics": ["Area"], "solvers": [{"solver": "fake.json",
        "mode": "good"}], "sweep": [{"parameter": "solvers[0].mode", "values": [)" +
      modes + "]}]}");
  return folder / "s.json";
}

} // namespace

TEST(Torture, TheStudyEndsAndNamesEveryFailure)
{
  const fs::path root = pemesh::TestFolder("torture");
  const fs::path folder = root / "it's \"odd\";\n ü 网 $(x) {mode} -";
  const std::string study = MakeStudy(folder, FakeSolvers);
  WriteFile(folder / "out-of-bounds" / "precious", "mine");
  const std::map<std::string, std::string> before = FilesOf(folder);
  const std::string mark = "PEMESH_TORTURE=" + std::to_string(getpid());
  setenv("PEMESH_TORTURE", std::to_string(getpid()).c_str(), 1);
  const auto run = pemesh::RunProgram("pemesh", { "run", study, "-o", folder / "out", "-j", "12" });
  unsetenv("PEMESH_TORTURE");
  EXPECT_EQ(run.ExitCode, 1) << run.Errors;

  EXPECT_THAT(MarkedProcesses(mark), testing::IsEmpty());
  EXPECT_EQ(FilesOf(folder), before);
  EXPECT_EQ(NamesIn(folder / "out"),
    (std::set<std::string>{ "correlation.csv", "failures.csv", "findings.csv", "findings.txt",
      "index.csv", "journal.tsv", "meshes", "results.csv", "series.pvd", "solvers", "study.json",
      "timings.csv" }));

  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  const auto failures = pemesh::ReadCsvFile(folder / "out" / "failures.csv");
  std::map<long long, std::string> messages;
  for (vtkIdType i = 0; i < failures->GetNumberOfRows(); ++i)
  {
    messages[failures->GetValueByName(i, "Index").ToLongLong()] =
      failures->GetValueByName(i, "Message").ToString();
  }
  ASSERT_EQ(results->GetNumberOfRows(), static_cast<vtkIdType>(std::size(FakeSolvers)));
  for (vtkIdType i = 0; i < results->GetNumberOfRows(); ++i)
  {
    const FakeSolver& fake = FakeSolvers[i];
    SCOPED_TRACE(fake.Name + (": " + messages[i]));
    const std::string status = results->GetValueByName(i, "fake_Status").ToString();
    EXPECT_THAT('|' + std::string(fake.Status) + '|', HasSubstr('|' + status + '|'));
    EXPECT_EQ(messages[i].empty(), status == "ok");
    EXPECT_THAT(messages[i], HasSubstr(fake.Says));
    EXPECT_EQ(results->GetValueByName(i, "Area_min").ToDouble(), 1.0);
    const double number = results->GetValueByName(i, "fake_number").ToDouble();
    const bool isKept = status == "ok" || (status == "partial" && HasGoodNumber(fake));
    EXPECT_TRUE(isKept ? number == 1.5 : std::isnan(number)) << number;
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder / "out" / "solvers"))
  {
    if (entry.path().extension() == ".log")
    {
      EXPECT_LT(entry.file_size(), 17U << 20) << entry.path();
    }
  }
  fs::remove_all(root); // some of it is large
}

// What they leave is in the way of the next attempt, and of the next run.
const FakeSolver Planters[] = {
  { "good", "answer", "ok" },
  { "pipes",
    "for f in stdout.log stderr.log command.txt solved.txt \"$stem.off\" \"$stem.node\" "
    "\"$stem.ele\" \"$stem-solution.txt\" \"$stem-ground-truth.txt\" \"$stem-number.txt\"; do "
    "rm -f \"$output/$f\"; mkfifo \"$output/$f\"; done; exit 1",
    "exit-status", "tried 2 times" },
  { "endless-links",
    "for f in stdout.log solved.txt \"$stem.off\" \"$stem.node\" \"$stem-number.txt\"; do ln -sf "
    "/dev/zero \"$output/$f\"; done; exit 1",
    "exit-status", "tried 2 times" },
  { "links",
    "for f in stdout.log stderr.log command.txt solved.txt \"$stem.off\" \"$stem-number.txt\"; do "
    "ln -sf \"$precious/precious\" \"$output/$f\"; done; exit 1",
    "exit-status", "tried 2 times" },
  { "folders",
    "for f in stdout.log solved.txt \"$stem.off\" \"$stem-number.txt\"; do rm -rf \"$output/$f\"; "
    "mkdir -p \"$output/$f/x\"; done; exit 1",
    "exit-status", "tried 2 times" },
  { "second-time", "[ -e \"$output/once\" ] && answer || { : > \"$output/once\"; exit 1; }", "ok" },
};

TEST(Torture, NothingPlantedHoldsUpASecondAttemptOrRun)
{
  const fs::path folder = pemesh::TestFolder("planted");
  const std::string study = MakeStudy(folder, Planters);
  WriteFile(folder / "out-of-bounds" / "precious", "mine");
  const std::map<std::string, std::string> before = FilesOf(folder);
  for (const char* how : { "--fresh", "--resume" })
  {
    std::vector<std::string> arguments{ "run", study, "-o", folder / "out", "--retry", "1" };
    if (std::string(how) == "--resume")
    {
      arguments.emplace_back(how);
    }
    const auto run = pemesh::RunProgram("pemesh", arguments);
    EXPECT_EQ(run.ExitCode, 1) << run.Errors;
    EXPECT_EQ(FilesOf(folder), before);
    const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
    ASSERT_EQ(results->GetNumberOfRows(), static_cast<vtkIdType>(std::size(Planters)));
    for (vtkIdType i = 0; i < results->GetNumberOfRows(); ++i)
    {
      SCOPED_TRACE(Planters[i].Name + std::string(" ") + how);
      EXPECT_EQ(results->GetValueByName(i, "fake_Status").ToString(), Planters[i].Status);
      const double number = results->GetValueByName(i, "fake_number").ToDouble();
      EXPECT_TRUE(Planters[i].Status == std::string("ok") ? number == 1.5 : std::isnan(number));
    }
  }
  fs::remove_all(folder);
}

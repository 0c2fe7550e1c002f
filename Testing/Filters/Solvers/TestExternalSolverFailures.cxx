// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FakeSolver.h"

#include <algorithm>

using namespace pemesh;
using testing::HasSubstr;

struct BadRun
{
  const char* Mode;
  const char* Status;
  const char* Message;
};

void PrintTo(const BadRun& run, std::ostream* stream)
{
  *stream << run.Mode;
}

class BadSolver : public testing::TestWithParam<BadRun>
{
};

TEST_P(BadSolver, IsTold)
{
  const auto solver = MakeSolver(GetParam().Mode);
  const std::string status = GetParam().Status;
  status == "partial" ? ExpectTold(solver, status, GetParam().Message)
                      : ExpectFailed(solver, status, GetParam().Message);
  ExpectSameMesh(solver->GetOutput(), MakeHouse());
  EXPECT_EQ(GetCaseStatus(solver->GetOutput()), "ok"); // the mesh is good
}

INSTANTIATE_TEST_SUITE_P(Modes, BadSolver,
  testing::Values(
    BadRun{ "status", "exit-status", "status 3; it last wrote: the matrix is singular." },
    BadRun{ "silent-status", "exit-status", "status 4; it wrote nothing" },
    BadRun{ "signal", "crashed", "SIGSEGV, Segmentation fault; it last wrote: about to fall" },
    BadRun{
      "few", "partial", "\"house-solution.txt\" of the solver has 5 numbers and should have 6" },
    BadRun{ "many", "partial", "has 7 numbers and should have 6" },
    BadRun{ "nan", "partial", "\"nan\" in line 2" },
    BadRun{ "infinite", "partial", "\"house-condition-number.txt\" of the solver has \"inf\"" },
    BadRun{ "word", "partial", "\"house-ground-truth.txt\" of the solver has \"0,5\" in line 3" },
    BadRun{ "rubbish", "partial", "\"????%s\" in line 1" },
    BadRun{ "empty", "partial", "has 0 numbers and should have 6" },
    BadRun{ "folder", "partial", "is a folder" },
    BadRun{ "no-files", "bad-output", "not written the file \"house-solution.txt\"" },
    BadRun{ "no-performance", "partial", "not written the file \"house-condition-number.txt\"" },
    BadRun{ "two-numbers", "partial", "has 2 numbers and should have 1." },
    BadRun{ "no-number", "partial", "has 0 numbers and should have 1." },
    BadRun{ "link", "partial", "\"house-solution.txt\" of the solver is a link" },
    BadRun{ "fifo", "partial", "is a special file" },
    BadRun{ "huge", "partial", "\"house-solution.txt\" of the solver has 3145728 bytes, too many" },
    BadRun{ "wrong-mesh", "bad-output", "It has written \"other-condition-number.txt\"" },
    BadRun{ "late", "bad-output", "that it had left running were stopped" },
    BadRun{ "no-folder", "bad-output", "It has removed its own folder." }),
  [](const auto& test)
  {
    std::string name = test.param.Mode;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(ExternalSolverFailures, WhatIsGoodOfAnAnswerIsKept)
{
  const auto solver = MakeSolver("no-performance");
  ExpectTold(solver, "partial", "The rest of its answer is kept.");
  EXPECT_EQ(PointValues(solver->GetOutput(), "run_Solution").size(), 6U);
  EXPECT_EQ(GetFieldNumber(solver->GetOutput(), "run_solve-seconds"), 0.25);
  EXPECT_TRUE(std::isnan(GetFieldNumber(solver->GetOutput(), "run_condition-number")));
  solver->SetOption("mode", "few");
  ExpectTold(solver, "partial", "5 numbers");
  EXPECT_EQ(PointValues(solver->GetOutput(), "run_GroundTruth").size(), 6U);
  EXPECT_FALSE(solver->GetOutput()->GetPointData()->HasArray("run_Solution"));
  EXPECT_EQ(GetFieldNumber(solver->GetOutput(), "run_condition-number"), 4.5);
}

TEST(ExternalSolverFailures, TheDiskIsNotFilled)
{
  SolverDescription description = FakeSolver("big-file");
  description.DiskLimit = 8.0;
  description.TimeLimit = 60.0;
  const auto solver = MakeSolver("ok");
  solver->SetDescription(description);
  ExpectFailed(solver, "disk-limit", "8 MiB");
  solver->SetOption("mode", "many-files");
  ExpectFailed(solver, "disk-limit", "8 MiB");
}

TEST(ExternalSolverFailures, AFolderThatIsALinkIsNotWrittenInto)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path root = solver->GetWorkDirectory();
  std::filesystem::create_directories(root / "precious");
  WriteBytes(root / "precious" / "house-solution.txt", "mine");
  std::filesystem::create_directory_symlink(root / "precious", root / "house");
  ExpectFailed(solver, "not-written", "is a link");
  EXPECT_EQ(ReadBytes(root / "precious" / "house-solution.txt"), "mine");
}

TEST(ExternalSolverFailures, AMissingProgram)
{
  const auto solver = MakeSolver("ok");
  for (const char* program : { "no-such-program", "./no-such-program", "/no-such-program" })
  {
    solver->SetCommand({ program, "{mesh}" });
    ExpectFailed(solver, "not-found", program);
  }
}

TEST(ExternalSolverFailures, AFileThatIsNoProgram)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path file = std::filesystem::path(solver->GetWorkDirectory()) / "text";
  WriteBytes(file, "hello");
  solver->SetCommand({ file.string() });
  ExpectFailed(solver, "not-found", "Permission denied");
}

TEST(ExternalSolverFailures, TheTimeLimitEndsTheSolverAndItsChildren)
{
  const auto solver = MakeSolver("hang-with-child");
  solver->SetTimeLimit(1.25);
  const auto start = std::chrono::steady_clock::now();
  ExpectFailed(solver, "time-out", "1.25 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 2);
  solver->SetOption("mode", "deaf");
  ExpectFailed(solver, "time-out", "stopped");
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 1);
}

TEST(ExternalSolverFailures, AbortEndsTheSolverInTheMiddleOfItsWork)
{
  const auto solver = MakeSolver("hang-with-child");
  std::chrono::steady_clock::time_point asked;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&asked);
  observer->SetCallback(
    [](vtkObject* filter, unsigned long, void* client, void*)
    {
      auto& time = *static_cast<std::chrono::steady_clock::time_point*>(client);
      auto* algorithm = static_cast<vtkAlgorithm*>(filter);
      if (algorithm->GetProgress() > 0.06 && time == std::chrono::steady_clock::time_point())
      {
        time = std::chrono::steady_clock::now();
        algorithm->SetAbortExecute(1);
      }
    });
  solver->AddObserver(vtkCommand::ProgressEvent, observer);
  ExpectFailed(solver, "cancelled", "cancelled");
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(40));
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 2);
  // The filter can be used again.
  solver->SetOption("mode", "ok");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
}

TEST(ExternalSolverFailures, AnOldAnswerIsNotTakenForANewOne)
{
  const auto solver = MakeSolver("ok");
  solver->Update();
  const std::filesystem::path folder = std::filesystem::path(solver->GetWorkDirectory()) / "house";
  WriteBytes(folder / "notes.txt", "the user's own");
  solver->SetOption("mode", "no-files");
  ExpectFailed(solver, "bad-output", "not written");
  EXPECT_EQ(ReadBytes(folder / "notes.txt"), "the user's own"); // nothing else is touched
  EXPECT_FALSE(std::filesystem::exists(folder / "house-condition-number.txt"));
}

// Pipes that nobody writes to or reads, and links to the endless, in the places of all files that
// are opened before, between and after attempts.
TEST(ExternalSolverFailures, NothingThatASolverLeavesHoldsUpTheNextAttempt)
{
  for (const char* mode : { "pipes", "endless" })
  {
    SCOPED_TRACE(mode);
    const auto solver = MakeSolver(mode);
    solver->SetRetries(1);
    solver->ReuseAnswersOn();
    ExpectFailed(solver, "exit-status", "It was tried 2 times.");
    const auto second = MakeSolver("ok");
    second->ReuseAnswersOn();
    second->SetWorkDirectory(solver->GetWorkDirectory());
    second->Update();
    EXPECT_EQ(GetFieldText(second->GetOutput(), "run_Status"), "ok")
      << GetFieldText(second->GetOutput(), "run_StatusMessage");
    EXPECT_EQ(PointValues(second->GetOutput(), "run_Solution").size(), 6U);
  }
}

TEST(ExternalSolverFailures, AFolderThatTheSolverMakesALinkIsNotWrittenInto)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path root = solver->GetWorkDirectory();
  const std::filesystem::path precious = root / "precious";
  for (const char* status : { "0", "1" })
  {
    std::filesystem::create_directories(precious);
    WriteBytes(precious / "house-solution.txt", "1 2 3 4 5 6");
    WriteBytes(precious / "stdout.log", "mine");
    setenv("PRECIOUS", precious.c_str(), 1);
    SolverDescription description = FakeSolver("link-folder");
    description.Command.emplace_back(status);
    solver->SetWorkDirectory((root / "work" / status).string());
    solver->SetDescription(description);
    solver->SetRetries(1);
    ExpectFailed(solver, "not-written", "is a link");
    solver->SetRetries(0);
    std::filesystem::remove(root / "work" / status / "house");
    ExpectFailed(solver, *status == '0' ? "bad-output" : "exit-status",
      *status == '0' ? "has put a link in place of its own folder" : "status 1");
    unsetenv("PRECIOUS");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(precious), {}), 2);
    EXPECT_EQ(ReadBytes(precious / "stdout.log"), "mine");
  }
}

TEST(ExternalSolverFailures, AnOldArrayIsNotTakenForANewOne)
{
  const auto first = MakeSolver("ok");
  first->Update();
  const auto solver = MakeSolver("no-files");
  solver->SetInputData(first->GetOutput()); // as read from a file of an earlier study
  ExpectFailed(solver, "bad-output", "not written");
  EXPECT_EQ(PointValues(first->GetOutput(), "run_Solution").size(), 6U); // the input is untouched
}

TEST(ExternalSolverFailures, AFailedMeshIsNotSolved)
{
  const auto solver = MakeSolver("ok");
  vtkNew<vtkPolyData> mesh;
  SetCaseFailed(mesh, "meshing-failed", "The polygons cross.");
  solver->SetInputData(mesh);
  ExpectFailed(solver, "no-mesh", "The polygons cross.");
  EXPECT_EQ(GetCaseStatus(solver->GetOutput()), "meshing-failed");
  solver->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectFailed(solver, "no-mesh", "no polygons");
}

TEST(ExternalSolverFailures, AMeshThatTheFormatWouldCutIsNotSolved)
{
  // Gmsh's files hold triangles and quadrilaterals: a pentagon would be another mesh.
  const auto solver = MakeSolver("ok");
  SolverDescription description = FakeSolver("ok");
  description.MeshFormat = "gmsh";
  solver->SetDescription(description);
  solver->SetInputData(
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.5, 2 }, { 0, 1 } }, { { 0, 1, 2, 3, 4 } }));
  ExpectFailed(solver, "no-mesh", "at most 4 vertices");
}

TEST(ExternalSolverFailures, AWorkDirectoryThatCannotBeMade)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path file = std::filesystem::path(solver->GetWorkDirectory()) / "file";
  WriteBytes(file, "in the way");
  solver->SetWorkDirectory((file / "x").string());
  ExpectFailed(solver, "not-written", "file");
}

TEST(ExternalSolverFailures, AWrongConfigurationIsAnError)
{
  const auto expectError = [](const SolverDescription& description, const char* message,
                             const char* option = nullptr, const char* value = nullptr)
  {
    const auto solver = MakeSolver("ok");
    solver->SetDescription(description);
    if (option)
    {
      solver->SetOption(option, value);
    }
    ErrorLog errors(solver);
    EXPECT_EQ(solver->GetExecutive()->Update(), 0);
    EXPECT_THAT(errors.GetText(), HasSubstr(message));
  };
  const SolverDescription good = FakeSolver("ok");
  SolverDescription bad = good;
  bad.Command.clear();
  expectError(bad, "no command");
  bad = good;
  bad.Command.emplace_back("{problme}");
  expectError(bad, "{problme}");
  bad = good;
  bad.Command.emplace_back("{node}"); // of another format
  expectError(bad, "{node}");
  bad = good;
  bad.MeshFormat = "of";
  expectError(bad, "did you mean \"off\"?");
  bad = good;
  bad.MeshFormat = "stl";
  expectError(bad, "order of the vertices");
  bad = good;
  bad.Performances.push_back(bad.Performances[0]);
  expectError(bad, "\"condition-number\"");
  bad = good;
  bad.Performances[0].Name = "a/b";
  expectError(bad, "\"a/b\"");
  expectError(good, "did you mean \"order\"?", "ordre", "2");
  expectError(good, "must be an integer", "order", "2.5");
  expectError(good, "must be a number", "tolerance", "nan");
  expectError(good, "must be a number", "tolerance", "");
}

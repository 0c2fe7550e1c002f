// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMExternalSolver.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshFormats.h"
#include "SolverDescription.h"
#include "TestMeshes.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <gmock/gmock.h>

using namespace pemesh;
using testing::HasSubstr;

namespace
{

const std::filesystem::path SolverFolder =
  std::filesystem::path(PEMESH_SOURCE_DIR) / "Testing" / "Support" / "solvers";

SolverDescription FakeSolver(const std::string& mode)
{
  SolverDescription description;
  description.Name = "fake";
  description.Command = { "./fake-solver.sh", "{mode}", "{mesh}", "{output}", "{stem}" };
  description.Folder = SolverFolder;
  description.Options = { { "mode", "string", mode, "" }, { "order", "integer", "1", "" },
    { "tolerance", "number", "1e-10", "" } };
  description.Performances = { { "condition-number", "Condition number", "log", false },
    { "solve-seconds", "Seconds", "linear", true } };
  return description;
}

vtkSmartPointer<vtkPolyData> NamedHouse(const std::string& name = "house")
{
  auto mesh = MakeHouse();
  SetFieldText(mesh, MeshNameField, name);
  return mesh;
}

vtkSmartPointer<vtkPEMExternalSolver> MakeSolver(const std::string& mode)
{
  auto solver = vtkSmartPointer<vtkPEMExternalSolver>::New();
  solver->SetDescription(FakeSolver(mode));
  solver->SetInputData(NamedHouse());
  solver->SetRunName("run");
  solver->SetWorkDirectory(TestFolder().string());
  return solver;
}

std::vector<double> PointValues(vtkPolyData* mesh, const char* name)
{
  auto* array = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray(name));
  return array ? std::vector<double>(array->Begin(), array->End()) : std::vector<double>();
}

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

void ExpectAllGone(const std::filesystem::path& pids, int expected)
{
  std::istringstream stream(ReadBytes(pids));
  int count = 0;
  for (pid_t pid = 0; stream >> pid; ++count)
  {
    EXPECT_TRUE(IsGone(pid)) << pid;
  }
  EXPECT_EQ(count, expected);
}

/** Everything that must hold after a run that failed, whatever the reason. */
void ExpectFailed(
  vtkPEMExternalSolver* solver, const std::string& status, const std::string& message)
{
  EXPECT_EQ(solver->GetExecutive()->Update(), 1);
  vtkPolyData* output = solver->GetOutput();
  EXPECT_EQ(GetFieldText(output, "run_Status"), status);
  EXPECT_THAT(GetFieldText(output, "run_StatusMessage"), HasSubstr(message));
  EXPECT_THAT(GetFieldText(output, "run_StatusMessage"), testing::EndsWith("."));
  EXPECT_EQ(GetFieldText(output, "run_StatusMessage").find('\n'), std::string::npos);
  EXPECT_TRUE(std::isnan(GetFieldNumber(output, "run_condition-number")));
  EXPECT_TRUE(output->GetFieldData()->HasArray("run_condition-number"));
  EXPECT_TRUE(output->GetFieldData()->HasArray("run_solve-seconds"));
  EXPECT_TRUE(IsInFieldList(output, MeasuredList, "run_solve-seconds"));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
}

} // namespace

TEST(ExternalSolver, AGoodRun)
{
  const auto solver = MakeSolver("ok");
  solver->Update();
  vtkPolyData* output = solver->GetOutput();
  ExpectSameMesh(output, MakeHouse());
  EXPECT_EQ(GetFieldText(output, "run_Status"), "ok");
  EXPECT_EQ(GetFieldText(output, "run_StatusMessage"), "");
  EXPECT_EQ(PointValues(output, "run_Solution"), (std::vector<double>{ 0, .5, .5, 0, 1, 1 }));
  EXPECT_EQ(PointValues(output, "run_GroundTruth"), (std::vector<double>{ 0, 0, 1, 1, 0, 1 }));
  EXPECT_EQ(PointValues(output, "run_Error"), (std::vector<double>{ 0, .5, -.5, -1, 1, 0 }));
  EXPECT_EQ(GetFieldNumber(output, "run_condition-number"), 4.5);
  EXPECT_EQ(GetFieldNumber(output, "run_solve-seconds"), 0.25);
  EXPECT_TRUE(IsInFieldList(output, MeasuredList, "run_solve-seconds"));
  EXPECT_FALSE(IsInFieldList(output, MeasuredList, "run_condition-number"));
  EXPECT_EQ(GetCaseStatus(output), "ok");

  const std::filesystem::path folder = std::filesystem::path(solver->GetWorkDirectory()) / "house";
  ExpectSameMesh(ReadMesh(folder / "house.off"), MakeHouse());
  EXPECT_EQ(ReadBytes(folder / "stdout.log"), "all is well\n");
  EXPECT_EQ(ReadBytes(folder / "stderr.log"), "");
  EXPECT_THAT(ReadBytes(folder / "command.txt"),
    testing::AllOf(HasSubstr("fake-solver.sh' 'ok' '"), HasSubstr("house.off'")));
}

TEST(ExternalSolver, TheGroundTruthIsOptional)
{
  const auto solver = MakeSolver("no-truth");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
  EXPECT_EQ(PointValues(solver->GetOutput(), "run_Solution").size(), 6U);
  EXPECT_FALSE(solver->GetOutput()->GetPointData()->HasArray("run_GroundTruth"));
  EXPECT_FALSE(solver->GetOutput()->GetPointData()->HasArray("run_Error"));
}

TEST(ExternalSolver, WithoutARunNameThereIsNoPrefix)
{
  const auto solver = MakeSolver("ok");
  solver->SetRunName("");
  solver->Update();
  EXPECT_EQ(PointValues(solver->GetOutput(), "Solution").size(), 6U);
  EXPECT_EQ(GetFieldNumber(solver->GetOutput(), "condition-number"), 4.5);
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "SolverStatus"), "ok");
  solver->SetOption("mode", "status");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "SolverStatus"), "exit-status");
  EXPECT_EQ(GetCaseStatus(solver->GetOutput()), "ok"); // of the mesh
}

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
  ExpectFailed(solver, GetParam().Status, GetParam().Message);
  ExpectSameMesh(solver->GetOutput(), MakeHouse());
  EXPECT_EQ(GetCaseStatus(solver->GetOutput()), "ok"); // the mesh is good
}

INSTANTIATE_TEST_SUITE_P(Modes, BadSolver,
  testing::Values(
    BadRun{ "status", "exit-status", "status 3; it last wrote: the matrix is singular." },
    BadRun{ "silent-status", "exit-status", "status 4; it wrote nothing" },
    BadRun{ "signal", "crashed", "SIGSEGV, Segmentation fault; it last wrote: about to fall" },
    BadRun{
      "few", "bad-output", "\"house-solution.txt\" of the solver has 5 numbers and should have 6" },
    BadRun{ "many", "bad-output", "has 7 numbers and should have 6" },
    BadRun{ "nan", "bad-output", "\"nan\" in line 2" },
    BadRun{ "infinite", "bad-output", "\"house-condition-number.txt\" of the solver has \"inf\"" },
    BadRun{
      "word", "bad-output", "\"house-ground-truth.txt\" of the solver has \"0,5\" in line 3" },
    BadRun{ "rubbish", "bad-output", "\"????%s\" in line 1" },
    BadRun{ "empty", "bad-output", "has 0 numbers and should have 6" },
    BadRun{ "folder", "bad-output", "is a folder" },
    BadRun{ "no-files", "bad-output", "not written the file \"house-solution.txt\"" },
    BadRun{ "no-performance", "bad-output", "not written the file \"house-condition-number.txt\"" },
    BadRun{ "two-numbers", "bad-output", "has 2 numbers and should have 1." },
    BadRun{ "no-number", "bad-output", "has 0 numbers and should have 1." }),
  [](const auto& test)
  {
    std::string name = test.param.Mode;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(ExternalSolver, AMissingProgram)
{
  const auto solver = MakeSolver("ok");
  for (const char* program : { "no-such-program", "./no-such-program", "/no-such-program" })
  {
    solver->SetCommand({ program, "{mesh}" });
    ExpectFailed(solver, "not-found", program);
  }
}

TEST(ExternalSolver, AFileThatIsNoProgram)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path file = std::filesystem::path(solver->GetWorkDirectory()) / "text";
  WriteBytes(file, "hello");
  solver->SetCommand({ file.string() });
  ExpectFailed(solver, "not-found", "Permission denied");
}

TEST(ExternalSolver, TheTimeLimitEndsTheSolverAndItsChildren)
{
  const auto solver = MakeSolver("hang-with-child");
  solver->SetTimeLimit(1.25);
  const auto start = std::chrono::steady_clock::now();
  ExpectFailed(solver, "time-out", "1.25 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(6));
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 2);
  solver->SetOption("mode", "deaf");
  ExpectFailed(solver, "time-out", "stopped");
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 1);
}

TEST(ExternalSolver, AbortEndsTheSolverWithinASecond)
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
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(1500));
  ExpectAllGone(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "pids", 2);
  // The filter can be used again.
  solver->SetOption("mode", "ok");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
}

TEST(ExternalSolver, ProgressNeverGoesBack)
{
  const auto solver = MakeSolver("slow");
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&progress);
  observer->SetCallback(
    [](vtkObject* filter, unsigned long, void* client, void*)
    {
      static_cast<std::vector<double>*>(client)->push_back(
        static_cast<vtkAlgorithm*>(filter)->GetProgress());
    });
  solver->AddObserver(vtkCommand::ProgressEvent, observer);
  solver->Update();
  EXPECT_GE(progress.size(), 3U);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(ExternalSolver, AnOldAnswerIsNotTakenForANewOne)
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

TEST(ExternalSolver, AnOldArrayIsNotTakenForANewOne)
{
  const auto first = MakeSolver("ok");
  first->Update();
  const auto solver = MakeSolver("no-files");
  solver->SetInputData(first->GetOutput()); // as read from a file of an earlier study
  ExpectFailed(solver, "bad-output", "not written");
  EXPECT_EQ(PointValues(first->GetOutput(), "run_Solution").size(), 6U); // the input is untouched
}

TEST(ExternalSolver, AFailedMeshIsNotSolved)
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

TEST(ExternalSolver, NamesWithBlanksQuotesAndUnicode)
{
  const std::string names[] = { "a b", "it's \"x\"", "größe 网格", "$HOME;`ls`", "-rf", "{stem}" };
  const std::filesystem::path root = TestFolder() / "a 'quoted' folder – ü";
  for (const std::string& name : names)
  {
    SCOPED_TRACE(name);
    const auto solver = MakeSolver("ok");
    solver->SetWorkDirectory(root.string());
    solver->SetInputData(NamedHouse(name));
    solver->Update();
    EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok")
      << GetFieldText(solver->GetOutput(), "run_StatusMessage");
    EXPECT_TRUE(std::filesystem::exists(root / name / (name + "-solution.txt")));
  }
}

TEST(ExternalSolver, NamesThatAreNoFileNames)
{
  for (const std::string name : { "", ".", "..", "../../x", "a/b", "/abs" })
  {
    SCOPED_TRACE(name);
    const auto solver = MakeSolver("ok");
    solver->SetInputData(NamedHouse(name));
    solver->Update();
    EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
    // All stays below the work folder.
    EXPECT_FALSE(std::filesystem::is_empty(solver->GetWorkDirectory()));
  }
  EXPECT_FALSE(std::filesystem::exists("/abs"));
}

TEST(ExternalSolver, OptionsReachTheSolverOneByOne)
{
  SolverDescription description = FakeSolver("arguments");
  for (const char* argument : { "{order}", "--tol={tolerance}", "{threads}", "{{x}}", "", "a b" })
  {
    description.Command.emplace_back(argument);
  }
  const auto solver = MakeSolver("ok");
  solver->SetDescription(description);
  solver->SetOption("order", "3");
  solver->SetThreads(2);
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
  EXPECT_EQ(
    ReadBytes(std::filesystem::path(solver->GetWorkDirectory()) / "house" / "arguments.txt"),
    "3\n--tol=1e-10\n2\n{x}\n\na b\n");
}

TEST(ExternalSolver, TheSolverRunsInItsFolderWithItsThreads)
{
  const auto solver = MakeSolver("environment");
  solver->SetThreads(3);
  solver->Update();
  const std::filesystem::path folder = std::filesystem::path(solver->GetWorkDirectory()) / "house";
  EXPECT_EQ(ReadBytes(folder / "folder.txt"), folder.string() + "\n");
  EXPECT_THAT(ReadBytes(folder / "environment.txt"),
    testing::AllOf(HasSubstr("OMP_NUM_THREADS=3\n"), HasSubstr("LC_NUMERIC=C\n")));
}

TEST(ExternalSolver, EveryMeshFormatIsWritten)
{
  for (const std::string format : { "obj", "node", "node-plain", "vtp" })
  {
    SCOPED_TRACE(format);
    const auto solver = MakeSolver("ok");
    SolverDescription description;
    description.MeshFormat = format;
    const bool pair = format.rfind("node", 0) == 0;
    description.Command = { "sh", "-c",
      "cat \"$@\" >/dev/null; for i in 1 2 3 4 5 6; do echo $i; "
      "done > {stem}-solution.txt",
      "sh", "{mesh}" };
    if (pair)
    {
      description.Command.insert(description.Command.end(), { "{node}", "{ele}" });
    }
    solver->SetDescription(description);
    solver->Update();
    EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok")
      << GetFieldText(solver->GetOutput(), "run_StatusMessage");
    const std::string extension = pair ? ".ele" : "." + format;
    ExpectSameMesh(
      ReadMesh(std::filesystem::path(solver->GetWorkDirectory()) / "house" / ("house" + extension)),
      MakeHouse());
  }
}

TEST(ExternalSolver, WithoutAWorkDirectoryNothingStays)
{
  const std::filesystem::path temporary = TestFolder();
  setenv("TMPDIR", temporary.c_str(), 1);
  const auto solver = MakeSolver("ok");
  std::filesystem::create_directories(temporary);
  solver->SetWorkDirectory("");
  solver->Update();
  unsetenv("TMPDIR");
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
  EXPECT_TRUE(std::filesystem::is_empty(temporary));
}

TEST(ExternalSolver, AWorkDirectoryThatCannotBeMade)
{
  const auto solver = MakeSolver("ok");
  const std::filesystem::path file = std::filesystem::path(solver->GetWorkDirectory()) / "file";
  WriteBytes(file, "in the way");
  solver->SetWorkDirectory((file / "x").string());
  ExpectFailed(solver, "not-written", "file");
}

TEST(ExternalSolver, AWrongConfigurationIsAnError)
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

TEST(ExternalSolver, IsConfiguredPieceByPiece)
{
  vtkNew<vtkPEMExternalSolver> solver;
  solver->SetFolder(SolverFolder.string());
  solver->SetCommand({ "./fake-solver.sh", "{mode}", "{mesh}", "{output}", "{stem}" });
  solver->SetMeshFormat("off");
  solver->AddOption("mode", "string", "status");
  solver->AddPerformance("condition-number");
  solver->AddPerformance("solve-seconds", true);
  solver->SetOption("mode", "ok");
  solver->SetWorkDirectory(TestFolder().string());
  solver->SetInputData(NamedHouse());
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "SolverStatus"), "ok");
  EXPECT_EQ(solver->GetOption("mode"), "ok");
  EXPECT_EQ(solver->GetOption("none"), "");
  const vtkMTimeType before = solver->GetMTime();
  solver->SetOption("mode", "ok");
  solver->SetFolder(SolverFolder.string());
  solver->SetMeshFormat("off");
  solver->SetTimeLimit(0.0);
  solver->SetTimeLimit(-1.0);
  solver->SetThreads(1);
  solver->SetThreads(-5);
  solver->SetRunName("");
  EXPECT_EQ(solver->GetMTime(), before);
  solver->ResetOptions();
  EXPECT_EQ(solver->GetOption("mode"), "status");
  EXPECT_GT(solver->GetMTime(), before);
  std::ostringstream text;
  solver->Print(text);
  EXPECT_THAT(text.str(),
    testing::AllOf(HasSubstr("mode=status"), HasSubstr("condition-number"), HasSubstr("{stem}"),
      HasSubstr("Threads: 1")));
}

TEST(ExternalSolver, ManyAtOnce)
{
  constexpr int threads = 8;
  constexpr int runs = 5;
  const std::filesystem::path root = TestFolder();
  std::atomic<int> wrong{ 0 };
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t)
  {
    workers.emplace_back(
      [&, t]
      {
        vtkNew<vtkPEMExternalSolver> solver;
        solver->SetRunName("run");
        solver->SetWorkDirectory(root.string());
        for (int i = 0; i < runs; ++i)
        {
          const bool good = (t + i) % 2 == 0;
          solver->SetDescription(FakeSolver(good ? "ok" : "status"));
          solver->SetInputData(NamedHouse(std::to_string(t) + "-" + std::to_string(i)));
          solver->Update();
          const std::string status = GetFieldText(solver->GetOutput(), "run_Status");
          wrong += status == (good ? "ok" : "exit-status") ? 0 : 1;
        }
      });
  }
  for (std::thread& worker : workers)
  {
    worker.join();
  }
  EXPECT_EQ(wrong, 0);
}

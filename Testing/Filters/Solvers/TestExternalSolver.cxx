// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FakeSolver.h"

#include "MeshFormats.h"

#include <vtkCellData.h>

#include <atomic>

using namespace pemesh;
using testing::HasSubstr;

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

TEST(ExternalSolver, ArraysOfTheElementsAreReadIfTheyAreThere)
{
  const auto solver = MakeSolver("elements");
  solver->AddElementArray("ErrorL2");
  solver->AddElementArray("NotWritten");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
  auto* errors =
    vtkDoubleArray::SafeDownCast(solver->GetOutput()->GetCellData()->GetArray("run_ErrorL2"));
  ASSERT_NE(errors, nullptr);
  ASSERT_EQ(errors->GetNumberOfTuples(), 3);
  EXPECT_EQ(errors->GetValue(0), 0.5);
  EXPECT_TRUE(std::isnan(errors->GetValue(2)));
  EXPECT_EQ(solver->GetOutput()->GetCellData()->GetArray("run_NotWritten"), nullptr);
  // Undefined, and said so.
  EXPECT_TRUE(std::isnan(GetFieldNumber(solver->GetOutput(), "run_condition-number")));
}

TEST(ExternalSolver, AnArrayOfTheElementsWithAWrongCountIsLeftOut)
{
  const auto solver = MakeSolver("elements");
  solver->AddElementArray("Short");
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "partial");
  EXPECT_THAT(GetFieldText(solver->GetOutput(), "run_StatusMessage"),
    HasSubstr("should have 3, one for each element of the mesh."));
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

bool IsUtf8(const std::string& text)
{
  std::size_t following = 0;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if ((following > 0) != ((byte & 0xC0) == 0x80))
    {
      return false;
    }
    following = following > 0 ? following - 1 : byte >= 0xE0 ? 2 : byte >= 0xC0 ? 1 : 0;
  }
  return following == 0;
}

// Names that are cut, or changed to be names of files, at the same place.
TEST(ExternalSolver, NoTwoMeshesShareAFolder)
{
  std::string letters; // of two and three bytes
  while (letters.size() < 230)
  {
    letters += letters.size() % 3 == 0 ? "ü" : "网";
  }
  const std::string stem(230, 'a');
  const auto solver = MakeSolver("ok");
  const std::filesystem::path root = solver->GetWorkDirectory();
  std::size_t count = 0;
  for (const std::string& name : { stem + "_000", stem + "_001", letters + "_000", 'x' + letters,
         letters + "_001", std::string("a/b"), std::string("a_b"), std::string("a\nb"),
         std::string("mesh"), std::string(".."), std::string(200, 'b') })
  {
    SCOPED_TRACE(name);
    solver->SetInputData(NamedHouse(name));
    solver->Update();
    EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
    EXPECT_EQ(
      static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(root), {})),
      ++count);
  }
  EXPECT_TRUE(std::filesystem::exists(root / std::string(200, 'b')));
  for (const auto& entry : std::filesystem::directory_iterator(root))
  {
    const std::string name = entry.path().filename().string();
    EXPECT_LE(name.size(), 200U);
    EXPECT_TRUE(IsUtf8(name)) << name << " is cut within a character";
  }
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

TEST(ExternalSolver, IsConfiguredPieceByPiece)
{
  vtkNew<vtkPEMExternalSolver> solver;
  solver->SetFolder(FakeSolverFolder.string());
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
  solver->SetFolder(FakeSolverFolder.string());
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

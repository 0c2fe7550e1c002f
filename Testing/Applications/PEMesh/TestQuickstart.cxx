// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The demonstration study, run as a user runs it.
 */
#include "CsvTable.h"
#include "ProgramRun.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;

namespace
{

const std::string Quickstart = PEMESH_SOURCE_DIR "/Data/Studies/quickstart.json";

double Number(vtkTable* table, vtkIdType row, const char* column)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  EXPECT_NE(array, nullptr) << column;
  return array ? array->GetComponent(row, 0) : 0.0;
}

vtkIdType CountFiles(const fs::path& folder, const std::string& extension)
{
  vtkIdType count = 0;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    count += entry.path().extension() == extension ? 1 : 0;
  }
  return count;
}

} // namespace

TEST(Quickstart, LeavesTheWholeFolderAndTheSameBytesWithAnyNumberOfWorkers)
{
  const fs::path folder = TestFolder("quickstart");
  const auto one = RunProgram("pemesh", { "run", Quickstart, "-o", folder / "one", "-j", "1" });
  ASSERT_EQ(one.ExitCode, 0) << one.Output << one.Errors;
  EXPECT_EQ(one.Errors, "") << "no progress bar in a pipe, no warnings";
  const auto three = RunProgram("pemesh", { "run", Quickstart, "-o", folder / "three", "-j", "3" });
  ASSERT_EQ(three.ExitCode, 0) << three.Errors;
  for (const char* file : { "results.csv", "correlation.csv", "index.csv", "series.pvd" })
  {
    EXPECT_FALSE(FileText(folder / "one" / file).empty()) << file;
    EXPECT_TRUE(FileText(folder / "one" / file) == FileText(folder / "three" / file)) << file;
  }
  EXPECT_FALSE(fs::exists(folder / "one" / "failures.csv"));
  EXPECT_EQ(CountFiles(folder / "one" / "meshes", ".vtp"), 20);

  // Meshes too are the same to the byte.
  for (const auto& entry : fs::directory_iterator(folder / "one" / "meshes"))
  {
    const fs::path other = folder / "three" / "meshes" / entry.path().filename();
    EXPECT_TRUE(FileText(entry.path()) == FileText(other)) << entry.path();
  }

  const auto results = pemesh::ReadCsvFile(folder / "one" / "results.csv");
  ASSERT_EQ(results->GetNumberOfRows(), 20);
  for (vtkIdType row = 0; row < 20; ++row)
  {
    EXPECT_EQ(Number(results, row, "Index"), row);
    EXPECT_NEAR(Number(results, row, "t"), 0.9 * static_cast<double>(row) / 19.0, 1e-15);
    const double elements = Number(results, row, "Elements");
    EXPECT_NEAR(Number(results, row, "Area_mean") * elements, 1.0, 1e-12);
    EXPECT_GE(Number(results, row, "pemesh-vem_condition-number"), 1.0);
    const double error = Number(results, row, "pemesh-vem_relative-error-l2");
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.5);
  }
  EXPECT_EQ(results->GetColumnByName("pemesh-vem_solve-seconds"), nullptr)
    << "machine-dependent values belong in timings.csv";
  const auto timings = pemesh::ReadCsvFile(folder / "one" / "timings.csv");
  EXPECT_GT(Number(timings, 0, "pemesh-vem_solve-seconds"), 0.0);
}

TEST(Quickstart, MeshFilesHoldMetricsAndSolution)
{
  const fs::path folder = TestFolder("quickstart-arrays");
  const auto run = RunProgram("pemesh",
    { "run", Quickstart, "-o", folder / "out", "--set", "sweep.0.count=2", "--set", "plots=[]" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  vtkNew<vtkXMLPolyDataReader> reader;
  const std::string file = folder / "out" / "meshes" / "001_0.900000.vtp";
  ASSERT_TRUE(fs::exists(file));
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (const char* name : { "PolygonId", "ElementFamily", "Area", "KernelAreaRatio", "MinAngle" })
  {
    EXPECT_NE(mesh->GetCellData()->GetArray(name), nullptr) << name;
  }
  vtkDataArray* solution = mesh->GetPointData()->GetArray("pemesh-vem_Solution");
  vtkDataArray* truth = mesh->GetPointData()->GetArray("pemesh-vem_GroundTruth");
  vtkDataArray* error = mesh->GetPointData()->GetArray("pemesh-vem_Error");
  ASSERT_TRUE(solution && truth && error);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    EXPECT_EQ(error->GetComponent(point, 0),
      solution->GetComponent(point, 0) - truth->GetComponent(point, 0));
  }
}

TEST(Quickstart, TheStudyItWritesGivesTheSameResults)
{
  const fs::path folder = TestFolder("quickstart-again");
  const std::vector<std::string> fewer = { "--set", "sweep.0.count=3", "--set", "plots=[]" };
  std::vector<std::string> arguments = { "run", Quickstart, "-o", folder / "one" };
  arguments.insert(arguments.end(), fewer.begin(), fewer.end());
  ASSERT_EQ(RunProgram("pemesh", arguments).ExitCode, 0);
  const auto again =
    RunProgram("pemesh", { "run", folder / "one" / "study.json", "-o", folder / "two" });
  ASSERT_EQ(again.ExitCode, 0) << again.Errors;
  EXPECT_EQ(FileText(folder / "one" / "results.csv"), FileText(folder / "two" / "results.csv"));
}

TEST(MeshFolder, StudyOfRealFilesDoesTheSameFromTheMetricsOn)
{
  const fs::path folder = TestFolder("mesh-folder");
  const fs::path meshes = fs::path(PEMESH_TEST_DATA) / "Meshes" / "exercise_1_2";
  std::ofstream(folder / "study.json")
    << R"({"pemesh": 1, "name": "real", "meshes": ")" << (meshes / "*.off").string()
    << R"(", "solvers": [{"solver": "pemesh-vem", "problem": "franke"}]})";
  const auto run = RunProgram("pemesh", { "run", folder / "study.json", "-o", folder / "out" });
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  const auto results = pemesh::ReadCsvFile(folder / "out" / "results.csv");
  EXPECT_EQ(results->GetNumberOfRows(), 11);
  EXPECT_EQ(results->GetValueByName(0, "Mesh").ToString(), "009_0.426316");
  EXPECT_GT(Number(results, 0, "pemesh-vem_condition-number"), 1.0);
}

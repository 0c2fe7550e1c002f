// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshReader.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshFormats.h"
#include "TestMeshes.h"

#include <limits>
#include <sstream>

#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

/** Three meshes with 1, 4 and 9 squares (some cut in two), and where they are. */
std::vector<std::string> WriteThreeMeshes()
{
  const std::filesystem::path folder = TestFolder();
  std::vector<std::string> names;
  for (int i = 1; i <= 3; ++i)
  {
    names.push_back((folder / ("grid" + std::to_string(i) + ".off")).string());
    WriteMesh(names.back(), MakeJitteredGrid(i, 1));
  }
  return names;
}

} // namespace

TEST(MeshReader, FilesAreTimeSteps)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileNames(WriteThreeMeshes());
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  ASSERT_EQ(information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  const double* steps = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  EXPECT_EQ(std::vector<double>(steps, steps + 3), (std::vector<double>{ 0, 1, 2 }));
  const double* range = information->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 2.0);
  for (int i = 0; i < 3; ++i)
  {
    reader->UpdateTimeStep(i);
    ExpectSameMesh(reader->GetOutput(), MakeJitteredGrid(i + 1, 1));
    EXPECT_EQ(GetFieldText(reader->GetOutput(), "Mesh"), "grid" + std::to_string(i + 1));
    EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), i);
    EXPECT_EQ(GetCaseStatus(reader->GetOutput()), "ok");
  }
}

TEST(MeshReader, TakesTheNearestFileForOtherTimes)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileNames(WriteThreeMeshes());
  reader->Update(); // no time asked for
  EXPECT_EQ(GetFieldText(reader->GetOutput(), "Mesh"), "grid1");
  const std::pair<double, const char*> cases[] = { { 0.4, "grid1" }, { 0.6, "grid2" },
    { 7.0, "grid3" }, { -7.0, "grid1" }, { 1e300, "grid3" },
    { std::numeric_limits<double>::quiet_NaN(), "grid1" } };
  for (const auto& [time, name] : cases)
  {
    reader->UpdateTimeStep(time);
    EXPECT_EQ(GetFieldText(reader->GetOutput(), "Mesh"), name) << time;
  }
}

TEST(MeshReader, ABadFileIsAFailedCaseAndTheOthersAreRead)
{
  std::vector<std::string> names = WriteThreeMeshes();
  WriteBytes(names[1], "OFF\n3 1 0\n0 0 0\n");
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileNames(names);
  reader->UpdateTimeStep(1);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(GetCaseStatus(reader->GetOutput()), "unreadable-mesh");
  EXPECT_THAT(GetCaseStatusMessage(reader->GetOutput()), testing::HasSubstr("line 4"));
  EXPECT_EQ(GetFieldText(reader->GetOutput(), "Mesh"), "grid2");
  EXPECT_EQ(reader->GetExecutive()->Update(), 1);
  reader->UpdateTimeStep(2);
  EXPECT_EQ(GetCaseStatus(reader->GetOutput()), "ok");
  ExpectSameMesh(reader->GetOutput(), MakeJitteredGrid(3, 1));
}

TEST(MeshReader, WithoutFilesIsAnError)
{
  vtkNew<vtkPEMMeshReader> reader;
  ErrorLog errors(reader);
  EXPECT_EQ(reader->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors.GetText(), testing::HasSubstr("No mesh file"));
}

TEST(MeshReader, NamesAreUnique)
{
  vtkNew<vtkPEMMeshReader> reader;
  for (const char* name :
    { "a/Maze0.off", "b/Maze0.obj", "c/Maze0-2.off", "d/Maze0.off", "Maze0.1.off" })
  {
    reader->AddFileName(name);
  }
  std::vector<std::string> names;
  for (int i = 0; i < reader->GetNumberOfFileNames(); ++i)
  {
    names.push_back(reader->GetMeshName(i));
  }
  EXPECT_THAT(names, testing::ElementsAre("Maze0", "Maze0-2", "Maze0-2-2", "Maze0-3", "Maze0.1"));
  EXPECT_EQ(reader->GetMeshName(-1), "");
  EXPECT_EQ(reader->GetMeshName(5), "");
  EXPECT_EQ(reader->GetFileName(5), "");
}

TEST(MeshReader, SettersModifyOnlyWhenSomethingChanges)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName("a.off");
  const vtkMTimeType before = reader->GetMTime();
  reader->SetFileName("a.off");
  EXPECT_EQ(reader->GetMTime(), before);
  reader->SetFileName("b.off");
  EXPECT_GT(reader->GetMTime(), before);
  reader->RemoveAllFileNames();
  EXPECT_EQ(reader->GetNumberOfFileNames(), 0);
}

TEST(MeshReader, PrintsItsFiles)
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName("some.off");
  std::ostringstream text;
  reader->Print(text);
  EXPECT_THAT(text.str(), testing::HasSubstr("some.off"));
}

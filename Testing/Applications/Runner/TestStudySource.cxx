// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A study as a source with time steps: the meshes are those of a run.
 */
#include "vtkPEMStudySource.h"

#include "ErrorLog.h"
#include "TestFolder.h"
#include "TextFile.h"
#include "vtkPEMRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkVariant.h>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
using pemesh::TestPath;
using testing::ElementsAre;
using testing::HasSubstr;

std::string WriteStudy(const std::string& name, const std::string& members)
{
  const std::filesystem::path path = TestPath() / name;
  pemesh::WriteTextFile(path,
    R"({"pemesh": 1, "name": "s", "polygons": [{"family": "zeta"}], "metrics": ["Area"], )" +
      members + "}");
  return path.string();
}

std::vector<double> TimeSteps(vtkPEMStudySource* source)
{
  source->UpdateInformation();
  vtkInformation* information = source->GetOutputInformation(0);
  const double* times = information->Get(Pipeline::TIME_STEPS());
  return { times, times + information->Length(Pipeline::TIME_STEPS()) };
}

} // namespace

TEST(StudySource, MakesTheMeshesOfARun)
{
  const std::string study =
    WriteStudy("family.json", R"("sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": 3}])");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyFile(study);
  runner->SetOutputDirectory(TestPath() / "out");
  ASSERT_TRUE(runner->Run()) << testing::PrintToString(runner->GetMessages());
  vtkNew<vtkPEMStudySource> source;
  source->SetFileName(study);
  EXPECT_THAT(TimeSteps(source), ElementsAre(0.0, 0.4, 0.8));
  for (const int row : { 2, 0, 1 }) // in any order
  {
    source->UpdateTimeStep(0.4 * row);
    vtkPolyData* mesh = source->GetOutput();
    EXPECT_EQ(
      mesh->GetNumberOfCells(), runner->GetResults()->GetValueByName(row, "Elements").ToInt());
    EXPECT_NE(mesh->GetCellData()->GetArray("Area"), nullptr);
  }
}

TEST(StudySource, CasesAreTimesWhereMoreThanTIsSwept)
{
  vtkNew<vtkPEMStudySource> source;
  source->SetFileName(WriteStudy("two.json",
    R"("sweep": [{"parameter": "t", "values": [0.2, 0.4]},
                 {"parameter": "mesh.min-angle", "values": [10, 20, 30]}])"));
  EXPECT_THAT(TimeSteps(source), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(StudySource, LeavesOutSolversAndTheirSweeps)
{
  vtkNew<vtkPEMStudySource> source;
  source->SetFileName(WriteStudy("solvers.json",
    R"("solvers": [{"solver": "pemesh-vem", "order": 1}],
       "sweep": [{"parameter": "solvers[0].order", "values": [1, 2]},
                 {"parameter": "t", "values": [0.2, 0.4], "zip": true}])"));
  EXPECT_THAT(TimeSteps(source), ElementsAre(0.2, 0.4));
  source->Update();
  EXPECT_GT(source->GetOutput()->GetNumberOfCells(), 1);
}

TEST(StudySource, SaysWhatIsWrong)
{
  vtkNew<vtkPEMStudySource> source;
  const pemesh::ErrorLog errors(source);
  source->Update();
  EXPECT_THAT(errors.GetText(), HasSubstr("There is no study; set the file name."));
  source->SetFileName((TestPath() / "missing.json").string());
  source->Update();
  EXPECT_THAT(errors.GetText(), HasSubstr("missing.json"));
}

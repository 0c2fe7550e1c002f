// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramRun.h"
#include "vtkPEMRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

std::string SmallStudy(int count)
{
  return R"({"pemesh": 1, "name": "small", "polygons": [{"family": "zeta"}], "metrics": ["Area"],
             "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": )" +
    std::to_string(count) + "}]}";
}

} // namespace

TEST(Runner, ReportsProgressFromTheCallingThreadUpToOne)
{
  const fs::path folder = TestFolder("progress");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(5), folder.string());
  runner->SetOutputDirectory(folder / "out");
  runner->SetNumberOfWorkers(2);
  std::vector<double> fractions;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&fractions);
  observer->SetCallback([](vtkObject*, unsigned long, void* data, void* fraction)
    { static_cast<std::vector<double>*>(data)->push_back(*static_cast<double*>(fraction)); });
  runner->AddObserver(vtkCommand::ProgressEvent, observer);
  ASSERT_TRUE(runner->Run()) << testing::PrintToString(runner->GetMessages());
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_EQ(runner->GetResults()->GetNumberOfRows(), 5);
}

TEST(Runner, StopKeepsWhatIsDone)
{
  const fs::path folder = TestFolder("stop");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(200), folder.string());
  runner->SetOutputDirectory(folder / "out");
  runner->SetNumberOfWorkers(1);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(
    [](vtkObject* self, unsigned long, void*, void* fraction)
    {
      if (*static_cast<double*>(fraction) > 0.0)
      {
        static_cast<vtkPEMRunner*>(self)->RequestStop();
      }
    });
  runner->AddObserver(vtkCommand::ProgressEvent, observer);
  EXPECT_FALSE(runner->Run());
  EXPECT_FALSE(runner->GetRefused());
  const vtkIdType rows = runner->GetResults()->GetNumberOfRows();
  EXPECT_GT(rows, 0);
  EXPECT_LT(rows, 200);
  EXPECT_THAT(runner->GetMessages().back(), HasSubstr("Stopped after"));
  EXPECT_TRUE(fs::exists(folder / "out" / "results.csv"));
}

TEST(Runner, IsRefusedInOneSentence)
{
  vtkNew<vtkPEMRunner> runner;
  EXPECT_FALSE(runner->Run());
  EXPECT_TRUE(runner->GetRefused());
  EXPECT_EQ(runner->GetMessages().size(), 1U);
  runner->SetStudyText(SmallStudy(2), ".");
  runner->AddSetting("metrics=[\"Aera\"]");
  runner->SetOutputDirectory(TestFolder("refused").string());
  EXPECT_FALSE(runner->Run());
  EXPECT_TRUE(runner->GetRefused());
  ASSERT_EQ(runner->GetMessages().size(), 1U);
  EXPECT_THAT(runner->GetMessages().front(), HasSubstr("Area"));
}

TEST(Runner, RunsTwiceIntoTheSameFolder)
{
  const fs::path folder = TestFolder("twice");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(2), folder.string());
  runner->SetOutputDirectory(folder / "out");
  ASSERT_TRUE(runner->Run());
  const std::string first = pemesh::FileText(folder / "out" / "results.csv");
  ASSERT_TRUE(runner->Run()) << testing::PrintToString(runner->GetMessages());
  EXPECT_EQ(first, pemesh::FileText(folder / "out" / "results.csv"));
}

TEST(Runner, WhatIsRefusedForgetsTheRunBefore)
{
  const fs::path folder = TestFolder("forget");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(2), folder.string());
  runner->SetOutputDirectory(folder / "out");
  ASSERT_TRUE(runner->Run());
  runner->SetResume(true);
  ASSERT_TRUE(runner->Run());
  ASSERT_EQ(runner->GetNumberOfReusedCases(), 2);
  runner->AddSetting("metrics=[\"Aera\"]");
  EXPECT_FALSE(runner->Run());
  EXPECT_TRUE(runner->GetRefused());
  EXPECT_EQ(runner->GetResults(), nullptr);
  EXPECT_EQ(runner->GetNumberOfReusedCases(), 0);
  runner->RemoveAllSettings();
  EXPECT_TRUE(runner->Run()); // nothing is held open
}

TEST(Runner, ResultsThatCannotBeWrittenAreNotLost)
{
  const fs::path folder = TestFolder("unwritable");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(3), folder.string());
  runner->SetOutputDirectory(folder / "out");
  fs::path obstacle = folder / "out" / "results.csv"; // a file cannot take the place of a folder
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&obstacle);
  observer->SetCallback([](vtkObject*, unsigned long, void* path, void*)
    { fs::create_directories(*static_cast<fs::path*>(path) / "full"); });
  const unsigned long tag = runner->AddObserver(vtkCommand::ProgressEvent, observer);
  EXPECT_FALSE(runner->Run());
  EXPECT_FALSE(runner->GetRefused()); // the study is not wrong
  ASSERT_EQ(runner->GetMessages().size(), 1U) << testing::PrintToString(runner->GetMessages());
  EXPECT_THAT(runner->GetMessages().front(), HasSubstr("results.csv"));
  EXPECT_EQ(runner->GetResults()->GetNumberOfRows(), 3);
  runner->RemoveObserver(tag);
  fs::remove_all(obstacle);
  runner->SetResume(true);
  EXPECT_TRUE(runner->Run()) << testing::PrintToString(runner->GetMessages());
  EXPECT_EQ(runner->GetNumberOfReusedCases(), 3);
}

TEST(Runner, WhoeverThrowsInTheMiddleLeavesNoWorkersBehind)
{
  const fs::path folder = TestFolder("throw");
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(SmallStudy(200), folder.string());
  runner->SetOutputDirectory(folder / "out");
  runner->SetNumberOfWorkers(2);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback([](vtkObject*, unsigned long, void*, void*)
    { throw std::runtime_error("The front has fallen over."); });
  runner->AddObserver(vtkCommand::ProgressEvent, observer);
  EXPECT_FALSE(runner->Run());
  EXPECT_THAT(runner->GetMessages().back(), HasSubstr("fallen over"));
}

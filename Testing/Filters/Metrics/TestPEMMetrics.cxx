// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetrics.h"

#include "CaseStatus.h"
#include "MetricMeshes.h"
#include "MetricRegistry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>

using namespace pemesh::test;

namespace
{

/** Collects the errors or the warnings of an object instead of printing them. */
class Listener
{
public:
  Listener(vtkObject* object, unsigned long event)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* text)
      {
        auto* self = static_cast<Listener*>(client);
        ++self->Count;
        self->Text += text ? static_cast<const char*>(text) : "";
      });
    object->AddObserver(event, command);
  }

  int Count = 0;
  std::string Text;
};

} // namespace

TEST(vtkPEMMetrics, MeasuresEveryElement)
{
  vtkNew<vtkPEMMetrics> filter;
  filter->SetInputData(MakeMesh({ SquareCoordinates(), { { 0, 0 }, { 0, 2 }, { 2, 0 } },
    { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } }));
  ASSERT_EQ(filter->GetExecutive()->Update(), 1);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(
    output->GetCellData()->GetNumberOfArrays(), static_cast<int>(pemesh::MetricNames().size()));
  EXPECT_EQ(CellValue(output, "Area", 0), 1.0);
  EXPECT_EQ(CellValue(output, "Area", 1), 2.0); // clockwise
  EXPECT_EQ(CellValue(output, "Area", 2), 3.0);
  EXPECT_NEAR(CellValue(output, "KernelAreaRatio", 2), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(CellValue(output, "InscribedRadius", 2), 2.0 - std::sqrt(2.0), 1e-14);
}

TEST(vtkPEMMetrics, ChoosesMetricsInTheOrderOfTheRegistry)
{
  vtkNew<vtkPEMMetrics> filter;
  EXPECT_EQ(filter->GetMetrics(), vtkPEMMetrics::GetAvailableMetrics());
  filter->SetMetrics({ "MinAngle", "Area", "MinAngle" });
  EXPECT_EQ(filter->GetMetrics(), (std::vector<std::string>{ "Area", "MinAngle" }));
  filter->SetInputData(MakeMesh({ SquareCoordinates() }));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 2);
  EXPECT_STREQ(filter->GetOutput()->GetCellData()->GetArrayName(0), "Area");
  filter->RemoveAllMetrics();
  filter->AddMetric("EdgeRatio");
  EXPECT_EQ(filter->GetMetrics(), (std::vector<std::string>{ "EdgeRatio" }));
  filter->SelectAllMetrics();
  EXPECT_EQ(filter->GetMetrics(), vtkPEMMetrics::GetAvailableMetrics());
}

/** Scaled after it was measured: nothing of before is left. */
TEST(vtkPEMMetrics, ArraysOfMetricsThatTheMeshBringsAreMeasuredAnew)
{
  vtkNew<vtkPEMMetrics> first;
  first->SetInputData(MakeMesh({ SquareCoordinates() }));
  first->Update();
  vtkNew<vtkPolyData> scaled;
  scaled->DeepCopy(first->GetOutput());
  for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
  {
    double point[3];
    scaled->GetPoint(i, point);
    scaled->GetPoints()->SetPoint(i, 3.0 * point[0], 3.0 * point[1], 0.0);
  }
  vtkNew<vtkPEMMetrics> again;
  again->SetMetrics({ "MinAngle" });
  again->SetInputData(scaled);
  again->Update();
  EXPECT_EQ(CellValue(again->GetOutput(), "Area", 0), 9.0);
  EXPECT_EQ(CellValue(again->GetOutput(), "ShortestEdge", 0), 3.0);
  EXPECT_EQ(CellValue(scaled, "Area", 0), 1.0) << "the input is as it was";
}

TEST(vtkPEMMetrics, UnknownMetricsAreErrorsThatTellTheNearest)
{
  vtkNew<vtkPEMMetrics> filter;
  const Listener errors(filter, vtkCommand::ErrorEvent);
  const vtkMTimeType before = filter->GetMTime();
  filter->AddMetric("KernelAera");
  EXPECT_EQ(errors.Count, 1);
  EXPECT_NE(errors.Text.find("\"KernelArea\""), std::string::npos) << errors.Text;
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetMetrics(vtkPEMMetrics::GetAvailableMetrics());
  EXPECT_EQ(filter->GetMTime(), before) << "nothing changed";
}

TEST(vtkPEMMetrics, DegenerateElementsAreNotANumberWithOneWarning)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPEMMetrics> filter;
  const Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(MakeMesh({ SquareCoordinates(), { { 0, 0 }, { 1, 1 }, { 2, 2 } },
    { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, { { 0, 0 }, { nan, 1 }, { 1, 0 } },
    { { 0, 0 }, { 0, 0 }, { 1, 0 }, { 0, 1 } } }));
  ASSERT_EQ(filter->GetExecutive()->Update(), 1);
  for (const std::string& name : vtkPEMMetrics::GetAvailableMetrics())
  {
    EXPECT_TRUE(std::isfinite(CellValue(filter->GetOutput(), name, 0))) << name;
    EXPECT_TRUE(std::isnan(CellValue(filter->GetOutput(), name, 1))) << name;
    EXPECT_TRUE(std::isnan(CellValue(filter->GetOutput(), name, 2))) << name;
    EXPECT_TRUE(std::isnan(CellValue(filter->GetOutput(), name, 3))) << name;
  }
  EXPECT_EQ(CellValue(filter->GetOutput(), "NumberOfEdges", 4), 3.0);
  EXPECT_EQ(CellValue(filter->GetOutput(), "ShortestEdge", 4), 1.0);
  EXPECT_EQ(warnings.Count, 1);
  EXPECT_NE(warnings.Text.find("3 of 5"), std::string::npos) << warnings.Text;
  EXPECT_NE(warnings.Text.find("1 of 5"), std::string::npos) << warnings.Text;
}

TEST(vtkPEMMetrics, FailedAndUnusableMeshes)
{
  vtkNew<vtkPEMMetrics> filter;
  auto failed = MakeMesh({ SquareCoordinates() });
  pemesh::SetCaseFailed(failed, "invalid-layout", "Polygon 1 crosses polygon 2 at t = 0.5.");
  filter->SetInputData(failed);
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "invalid-layout");

  auto withLines = MakeMesh({ SquareCoordinates() });
  vtkNew<vtkCellArray> lines;
  const vtkIdType line[2] = { 0, 1 };
  lines->InsertNextCell(2, line);
  withLines->SetLines(lines);
  filter->SetInputData(withLines);
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "unusable-mesh");
  EXPECT_NE(
    pemesh::GetCaseStatusMessage(filter->GetOutput()).find("not polygons"), std::string::npos);
  EXPECT_EQ(pemesh::GetCaseStatus(withLines), "ok") << "the input is not touched";

  auto badIndex = MakeMesh({ SquareCoordinates() });
  const vtkIdType triangle[3] = { 0, 1, 99 };
  badIndex->GetPolys()->InsertNextCell(3, triangle);
  filter->SetInputData(badIndex);
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "unusable-mesh");

  filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "unusable-mesh");
}

TEST(vtkPEMMetrics, KeepsToThePipelineContract)
{
  vtkNew<vtkPEMMetrics> filter;
  const Listener errors(filter->GetExecutive(), vtkCommand::ErrorEvent);
  EXPECT_EQ(filter->GetExecutive()->Update(), 0) << "no input";
  EXPECT_GT(errors.Count, 0);

  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("KernelAreaRatio"), std::string::npos);

  const Listener executions(filter, vtkCommand::StartEvent);
  filter->SetInputData(MakeMesh({ SquareCoordinates() }));
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions.Count, 1) << "the second update has nothing to do";
  filter->SetMetrics({ "Area" });
  filter->Update();
  EXPECT_EQ(executions.Count, 2);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 1);
}

TEST(vtkPEMMetrics, ReportsProgressAndStops)
{
  std::vector<Coordinates> squares(120000, SquareCoordinates());
  vtkNew<vtkPEMMetrics> filter;
  filter->SetMetrics({ "Area" });
  filter->SetInputData(MakeMesh(squares));
  struct Observer
  {
    std::vector<double> Fractions;
    bool Abort = false;
  } observer;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&observer);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* fraction)
    {
      auto* self = static_cast<Observer*>(client);
      self->Fractions.push_back(*static_cast<double*>(fraction));
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(self->Abort);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_GE(observer.Fractions.size(), 2U);
  EXPECT_TRUE(std::is_sorted(observer.Fractions.begin(), observer.Fractions.end()));
  EXPECT_EQ(observer.Fractions.back(), 1.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 120000);

  observer.Abort = true;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 0) << "nothing half done is passed on";
  observer.Abort = false;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 120000);
}

TEST(vtkPEMMetrics, WhatCrossesOrRunsAlongItselfIsUndefined)
{
  vtkNew<vtkPEMMetrics> filter;
  const Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(MakeMesh({ { { 0, 0 }, { 1, 1 }, { 3, 3 }, { 3, -1 }, { 1, 1 }, { 0, 2 } },
    { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 2, 0 }, { 1, 1 }, { 0, 2 } },
    { { 0, 0 }, { 1, 0 }, { 1, 1 }, { .5, 1 }, { .5, .5 }, { .5, 1 }, { 0, 1 } },
    { { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 1, 1 }, { 0, 2 } } }));
  filter->Update();
  for (const std::string& name : pemesh::MetricNames())
  {
    for (vtkIdType element = 0; element < 3; ++element)
    {
      EXPECT_TRUE(std::isnan(CellValue(filter->GetOutput(), name.c_str(), element))) << name;
    }
  }
  EXPECT_EQ(CellValue(filter->GetOutput(), "Area", 3), 2.0) << "touches itself in a point";
  EXPECT_NE(warnings.Text.find("3 of 4 elements"), std::string::npos) << warnings.Text;
}

/** The square of what is shorter than 1e-162 is zero: no ratio may come of it. */
TEST(vtkPEMMetrics, EdgesTooShortForTheirSquaresAreRepeats)
{
  vtkNew<vtkPEMMetrics> filter;
  const Listener warnings(filter, vtkCommand::WarningEvent);
  filter->SetInputData(MakeMesh({ { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 1e-170 } },
    { { 0, 0 }, { 1e-170, 0 }, { 0, 1e-170 } } }));
  filter->Update();
  EXPECT_EQ(CellValue(filter->GetOutput(), "ShortestEdge", 0), 1.0);
  EXPECT_EQ(CellValue(filter->GetOutput(), "VEMRatio", 0), std::sqrt(2.0));
  EXPECT_TRUE(std::isnan(CellValue(filter->GetOutput(), "Area", 1)));
  EXPECT_EQ(warnings.Count, 1);
}

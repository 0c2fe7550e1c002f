// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMVirtualElementSolver.h"

#include "CaseStatus.h"
#include "EllipticProblem.h"
#include "ErrorLog.h"
#include "SolveReport.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"
#include "VirtualElementTestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace
{

using pemesh::GetFieldNumber;
using testing::HasSubstr;

TEST(PEMVirtualElementSolver, GivesWhatTheKernelGives)
{
  const auto mesh = pemesh::MakeLShapes(6, 0.4);
  vtkNew<vtkPEMVirtualElementSolver> filter;
  filter->SetInputData(mesh);
  filter->SetOrder(3);
  filter->SetRunName("run");
  filter->SetOption("problem", "trigonometric");
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(pemesh::GetFieldText(output, "run_Status"), "ok");
  pemesh::VirtualElementOptions options;
  options.Order = 3;
  const auto expected =
    pemesh::SolveElliptic(mesh, *pemesh::FindTestProblem("trigonometric"), options);
  auto* solution = output->GetPointData()->GetArray("run_Solution");
  auto* truth = output->GetPointData()->GetArray("run_GroundTruth");
  auto* error = output->GetPointData()->GetArray("run_Error");
  ASSERT_NE(error, nullptr);
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    EXPECT_EQ(solution->GetComponent(id, 0), expected.Solution[static_cast<std::size_t>(id)]);
    EXPECT_EQ(
      error->GetComponent(id, 0), solution->GetComponent(id, 0) - truth->GetComponent(id, 0));
  }
  EXPECT_EQ(
    output->GetCellData()->GetArray("run_ErrorL2")->GetComponent(3, 0), expected.ErrorL2[3]);
  EXPECT_EQ(GetFieldNumber(output, "run_relative-error-h1"), expected.RelativeErrorH1);
  EXPECT_TRUE(pemesh::IsInFieldList(output, pemesh::MeasuredList, "run_solve-seconds"));
  EXPECT_TRUE(std::isnan(GetFieldNumber(output, "run_condition-number-2")));
  EXPECT_EQ(output->GetCellData()->GetArray("run_ProjectionCondition"), nullptr);
}

TEST(PEMVirtualElementSolver, AFormulaTakesThePlaceOfTheProblem)
{
  vtkNew<vtkPEMVirtualElementSolver> filter;
  filter->SetInputData(pemesh::MakeLShapes(4));
  filter->SetOrder(2);
  filter->SetOption("solution", "x^2 - 3*x*y");
  filter->Update();
  EXPECT_EQ(pemesh::GetFieldText(filter->GetOutput(), "SolverStatus"), "ok");
  EXPECT_LT(GetFieldNumber(filter->GetOutput(), "relative-error-l2"), 1.0e-12);
}

// -Laplace u = 4 with u = 1 - x^2 - y^2 on the boundary has just that solution.
TEST(PEMVirtualElementSolver, WithoutASolutionThereAreNoErrors)
{
  vtkNew<vtkPEMVirtualElementSolver> filter;
  filter->SetInputData(pemesh::MakeLShapes(4));
  filter->SetOrder(2);
  filter->SetOption("source", "4");
  filter->SetOption("dirichlet", "1-x^2-y^2");
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPointData()->GetArray("GroundTruth"), nullptr);
  EXPECT_TRUE(std::isnan(GetFieldNumber(output, "relative-error-l2")));
  auto* solution = output->GetPointData()->GetArray("Solution");
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double* p = output->GetPoint(id);
    EXPECT_NEAR(solution->GetComponent(id, 0), 1 - p[0] * p[0] - p[1] * p[1], 1.0e-12);
  }
}

TEST(PEMVirtualElementSolver, AMeshThatCannotBeSolvedIsAStatus)
{
  vtkNew<vtkPEMVirtualElementSolver> filter;
  filter->SetInputData(pemesh::MakeMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 } }, { { 0, 1, 2 } }));
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(pemesh::GetFieldText(filter->GetOutput(), "SolverStatus"), "not-solved");
  EXPECT_THAT(pemesh::GetFieldText(filter->GetOutput(), "SolverStatusMessage"),
    HasSubstr("nothing to solve"));
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "ok");
}

TEST(PEMVirtualElementSolver, WrongOptionsAreErrors)
{
  for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{
         { "problem", "frank" }, { "basis", "legendre" }, { "solution", "sin(z)" } })
  {
    vtkNew<vtkPEMVirtualElementSolver> filter;
    const pemesh::ErrorLog log(filter);
    filter->SetInputData(pemesh::MakeLShapes(4));
    filter->SetOption(name, value);
    EXPECT_EQ(filter->GetExecutive()->Update(), 0) << name;
    EXPECT_THAT(log.GetText(), HasSubstr(name == "solution" ? "z" : name)) << name;
  }
}

TEST(PEMVirtualElementSolver, CanBeCancelled)
{
  vtkNew<vtkPEMVirtualElementSolver> filter;
  filter->SetInputData(pemesh::MakeLShapes(4));
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  EXPECT_EQ(pemesh::GetFieldText(filter->GetOutput(), "SolverStatus"), "cancelled");
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Solution"), nullptr);
}

TEST(SolveReport, AsksNowAndThenWithinAStage)
{
  std::vector<double> fractions;
  bool goesOn = true;
  const pemesh::SolveProgress progress = [&](double fraction)
  {
    fractions.push_back(fraction);
    return goesOn;
  };
  pemesh::SolveReport report(progress);
  report.Tell(0.25);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  report.Check();
  EXPECT_THAT(fractions, testing::ElementsAre(0.25, 0.25));
  goesOn = false;
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  EXPECT_THROW(report.Check(), pemesh::SolveAborted);
}

} // namespace

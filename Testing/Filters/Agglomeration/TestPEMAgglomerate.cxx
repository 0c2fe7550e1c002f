// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMAgglomerate.h"

#include "AgglomerationChecks.h"
#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshConversion.h"
#include "PointDistances.h"
#include "SampleMeshes.h"
#include "TestMeshes.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

int ArrayValue(vtkPolyData* mesh, const char* name, vtkIdType cell)
{
  return vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray(name))->GetValue(cell);
}

/** The layout of Data/Studies/quickstart.json and the mesher as that study sets it. */
void MakeQuickstart(vtkPEMPolygonLayout* layout, vtkPEMDomainMesher* mesher)
{
  const int comb = layout->AddPolygon("comb", 0.32, 0.28);
  layout->SetPolygonRotation(comb, 15.0);
  layout->SetPolygonParameter(comb, "teeth", 10);
  const int star = layout->AddPolygon("star", 0.68, 0.7);
  layout->SetPolygonParameter(star, "spikes", 40);
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->SetAreaRuleByName("constant");
  mesher->SetMaximumArea(0.002);
  mesher->SetMinimumAngle(20.0);
}

/** "With diameter the triangles left are at most 5 % of the elements." */
TEST(PEMAgglomerate, DiameterLeavesHardlyAnyTriangleOfTheQuickstart)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  vtkNew<vtkPEMDomainMesher> mesher;
  MakeQuickstart(layout, mesher);
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputConnection(mesher->GetOutputPort());
  for (int step = 0; step < 20; ++step)
  {
    agglomerate->UpdateTimeStep(0.9 * step / 19);
    vtkPolyData* before = mesher->GetOutput();
    vtkPolyData* after = agglomerate->GetOutput();
    ASSERT_EQ(GetCaseStatus(after), "ok") << GetCaseStatusMessage(after);
    double smallest = 1e300;
    std::vector<Point2> vertices;
    const PolygonMesh fine = ToPolygonMesh(before);
    for (int element = 0; element < 2; ++element)
    {
      ASSERT_EQ(ArrayValue(before, "PolygonId", element), element);
      fine.GetVertices(element, vertices);
      smallest = std::min(smallest, Diameter(vertices));
    }
    const PolygonMesh coarse = ToPolygonMesh(after);
    int triangles = 0;
    for (int element = 0; element < coarse.NumberOfElements(); ++element)
    {
      coarse.GetVertices(element, vertices);
      ASSERT_TRUE(IsSimpleAndCounterClockwise(vertices));
      if (ArrayValue(after, "PolygonId", element) < 0)
      {
        EXPECT_LE(Diameter(vertices), smallest * (1.0 + 1e-15));
        triangles += vertices.size() == 3 ? 1 : 0;
      }
    }
    EXPECT_LE(triangles, 0.05 * coarse.NumberOfElements()) << "step " << step;
    EXPECT_LT(coarse.NumberOfElements(), 0.1 * fine.NumberOfElements());
    EXPECT_EQ(ExactArea(coarse), "1");
    EXPECT_EQ(GetFieldNumber(after, "ElementsBefore"), fine.NumberOfElements());
    EXPECT_EQ(GetFieldNumber(after, "VerticesBefore"), before->GetNumberOfPoints());
  }
}

TEST(PEMAgglomerate, CarriesProvenanceAndFieldData)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("star", 0.3, 0.3);
  layout->AddPolygon("maze", 0.7, 0.7);
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputConnection(mesher->GetOutputPort());
  agglomerate->UpdateTimeStep(0.25);
  vtkPolyData* output = agglomerate->GetOutput();
  EXPECT_EQ(GetFieldNumber(output, "t"), 0.25);
  EXPECT_EQ(GetFieldNumber(output, "MovedArea"), 0.0);
  EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), 2);
  for (int cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(ArrayValue(output, "PolygonId", cell), cell < 2 ? cell : -1);
    EXPECT_EQ(ArrayValue(output, "ElementFamily", cell),
      cell < 2 ? ArrayValue(mesher->GetOutput(), "ElementFamily", cell) : -1);
  }
}

TEST(PEMAgglomerate, MergesPolygonsWhereTold)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeHouse();
  vtkNew<vtkIntArray> ids;
  ids->SetName("PolygonId");
  for (const int id : { 0, 1, -1 })
  {
    ids->InsertNextValue(id);
  }
  mesh->GetCellData()->AddArray(ids);
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(mesh);
  agglomerate->SetRuleByName("random");
  agglomerate->SetTargetNumberOfElements(1);
  agglomerate->Update();
  EXPECT_EQ(agglomerate->GetOutput()->GetNumberOfCells(), 3);
  agglomerate->KeepPolygonsOff();
  agglomerate->Update();
  ASSERT_EQ(agglomerate->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(ArrayValue(agglomerate->GetOutput(), "PolygonId", 0), -1);
  EXPECT_EQ(agglomerate->GetOutput()->GetCell(0)->GetNumberOfPoints(), 6);
  agglomerate->SetStraightVertices(vtkPEMAgglomerate::REMOVE_EXACT);
  agglomerate->Update();
  EXPECT_EQ(agglomerate->GetOutput()->GetCell(0)->GetNumberOfPoints(), 4);
  EXPECT_EQ(agglomerate->GetOutput()->GetNumberOfPoints(), 4);
}

TEST(PEMAgglomerate, FailsTheCaseOfAMeshThatDoesNotConform)
{
  vtkSmartPointer<vtkPolyData> mesh =
    MakeTestMesh({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 }, { 1, 0 }, { 1, -1 } },
      { { 0, 1, 2, 3 }, { 5, 4, 0 } });
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(mesh);
  agglomerate->SetRuleByName("metis");
  agglomerate->Update();
  EXPECT_EQ(GetCaseStatus(agglomerate->GetOutput()), "not-agglomerable");
  EXPECT_THAT(GetCaseStatusMessage(agglomerate->GetOutput()), HasSubstr("not conforming"));
  ExpectSameMesh(agglomerate->GetOutput(), mesh);
}

TEST(PEMAgglomerate, FailsTheCaseWithoutPolygonsToMeasureTheDiameterOf)
{
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(MakeHouse());
  agglomerate->Update();
  EXPECT_EQ(GetCaseStatus(agglomerate->GetOutput()), "not-agglomerable");
  EXPECT_THAT(GetCaseStatusMessage(agglomerate->GetOutput()), HasSubstr("max-diameter"));
  agglomerate->SetParameter("max-diameter", 1.2);
  agglomerate->Update();
  EXPECT_EQ(GetCaseStatus(agglomerate->GetOutput()), "ok");
  EXPECT_EQ(agglomerate->GetOutput()->GetNumberOfCells(), 2);
}

TEST(PEMAgglomerate, PassesAFailedMeshOn)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeHouse();
  SetCaseFailed(mesh, "invalid-layout", "It is so.");
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(mesh);
  agglomerate->Update();
  EXPECT_EQ(GetCaseStatus(agglomerate->GetOutput()), "invalid-layout");
  ExpectSameMesh(agglomerate->GetOutput(), mesh);
}

TEST(PEMAgglomerate, RefusesWrongConfigurations)
{
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(MakeHouse());
  ErrorLog errors(agglomerate);
  agglomerate->SetRuleByName("randon");
  EXPECT_THAT(errors.GetText(), HasSubstr("did you mean \"random\""));
  EXPECT_EQ(agglomerate->GetRuleName(), "diameter");
  errors.Clear();
  agglomerate->SetMetric("ShapeRegularty");
  EXPECT_THAT(errors.GetText(), HasSubstr("ShapeRegularity"));
  EXPECT_EQ(agglomerate->GetMetric(), "");
  errors.Clear();
  agglomerate->SetParameter("max-diameter", -1.0);
  EXPECT_THAT(errors.GetText(), HasSubstr("max-diameter is -1"));
  EXPECT_EQ(agglomerate->GetParameter("max-diameter"), 0.0);
  errors.Clear();
  agglomerate->SetRuleByName("quality");
  agglomerate->SetMetric("Area");
  EXPECT_EQ(agglomerate->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors.GetText(), HasSubstr("cannot use the metric Area"));
  errors.Clear();
  agglomerate->SetRuleByName("random");
  EXPECT_EQ(agglomerate->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors.GetText(), HasSubstr("does not use a metric"));
  errors.Clear();
  agglomerate->SetMetric("");
  agglomerate->SetTargetPercentage(50.0);
  agglomerate->SetTargetNumberOfElements(2);
  EXPECT_EQ(agglomerate->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors.GetText(), HasSubstr("one target"));
}

TEST(PEMAgglomerate, EveryRuleForgetsTheParametersOfOthers)
{
  EXPECT_THAT(vtkPEMAgglomerate::GetAvailableRules(),
    ElementsAre("diameter", "random", "quality", "metis", "regular"));
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetRuleByName("random");
  EXPECT_THAT(agglomerate->GetParameterNames(), ElementsAre("seed"));
  agglomerate->SetParameter("seed", 7.0);
  const vtkMTimeType modified = agglomerate->GetMTime();
  agglomerate->SetParameter("seed", 7.0);
  agglomerate->SetRuleByName("random");
  agglomerate->SetMetric("");
  EXPECT_EQ(agglomerate->GetMTime(), modified);
  EXPECT_EQ(agglomerate->GetParameter("seed"), 7.0);
  EXPECT_TRUE(std::isnan(agglomerate->GetParameter("max-diameter")));
  agglomerate->SetRuleByName("metis");
  EXPECT_EQ(agglomerate->GetParameter("seed"), 1.0);
  std::ostringstream text;
  agglomerate->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("Rule: metis"));
}

TEST(PEMAgglomerate, StopsWhenAborted)
{
  vtkNew<vtkPolyData> mesh;
  SetPolygonMesh(mesh, TriangleGrid(60, 60, 1));
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(mesh);
  agglomerate->SetRuleByName("regular");
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  agglomerate->AddObserver(vtkCommand::ProgressEvent, abort);
  agglomerate->Update();
  EXPECT_EQ(agglomerate->GetOutput()->GetNumberOfCells(), 0);
}

} // namespace

} // namespace pemesh

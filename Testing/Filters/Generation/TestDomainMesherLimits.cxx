// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomainMesher.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "GenerationSupport.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCallbackCommand.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{

using pemesh::Point2;
using testing::HasSubstr;

// --- Refusals
// ----------------------------------------------------------------------------------------

std::string Refusal(const std::vector<PolygonVertices>& polygons)
{
  vtkNew<vtkPEMDomainMesher> mesher;
  vtkSmartPointer<vtkPolyData> layout = MakeLayout(polygons);
  pemesh::SetFieldNumber(layout, "t", 0.25);
  mesher->SetInputData(layout);
  EXPECT_EQ(mesher->GetExecutive()->Update(), 1) << "the failure of a case is not an error";
  EXPECT_EQ(pemesh::GetCaseStatus(mesher->GetOutput()), "invalid-layout");
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0) << "nothing is meshed";
  EXPECT_EQ(pemesh::GetFieldNumber(mesher->GetOutput(), "t"), 0.25) << "field data is passed on";
  return pemesh::GetCaseStatusMessage(mesher->GetOutput());
}

TEST(DomainMesher, RefusesBadLayoutsByNameAndTime)
{
  const PolygonVertices square = { { 0.25, 0.25 }, { 0.5, 0.25 }, { 0.5, 0.5 }, { 0.25, 0.5 } };
  const PolygonVertices beside = { { 0.5, 0.3 }, { 0.75, 0.3 }, { 0.75, 0.4 }, { 0.5, 0.4 } };
  const PolygonVertices over = { { 0.45, 0.3 }, { 0.75, 0.3 }, { 0.75, 0.4 }, { 0.45, 0.4 } };
  const PolygonVertices within = { { 0.3, 0.3 }, { 0.4, 0.3 }, { 0.4, 0.4 } };
  const PolygonVertices bowTie = { { 0.6, 0.6 }, { 0.9, 0.9 }, { 0.9, 0.6 }, { 0.6, 0.9 } };
  const PolygonVertices outside = { { 0.6, 0.6 }, { 1.5, 0.6 }, { 0.6, 0.9 } };
  const PolygonVertices onBorder = { { 0.6, 0.6 }, { 1.0, 0.7 }, { 0.6, 0.9 } };
  const PolygonVertices broken = { { 0.6, 0.6 }, { 0.7, NAN }, { 0.6, 0.9 } };
  EXPECT_EQ(Refusal({ square, beside }),
    "polygon 1 and polygon 2 touch at t = 0.25; move them apart or make them smaller.");
  EXPECT_EQ(Refusal({ square, over }),
    "polygon 1 and polygon 2 overlap at t = 0.25; move them apart or make them smaller.");
  EXPECT_EQ(Refusal({ square, within }),
    "polygon 2 lies in polygon 1 at t = 0.25; move them apart or make them smaller.");
  EXPECT_EQ(Refusal({ square, bowTie }),
    "polygon 2 crosses or touches itself: edges 0 and 2 meet at t = 0.25; use a simple polygon.");
  EXPECT_EQ(Refusal({ outside }),
    "polygon 1 leaves the unit square at t = 0.25; move it inwards or make it smaller.");
  EXPECT_EQ(Refusal({ onBorder }),
    "polygon 1 touches the border of the unit square at t = 0.25; move it inwards or make it "
    "smaller.");
  EXPECT_THAT(Refusal({ broken }), HasSubstr("polygon 1 has a coordinate that is not a finite"));
}

TEST(DomainMesher, NamesPolygonsOfTheLayout)
{
  Generation generation;
  generation.Layout->AddPolygon("comb", 0.3, 0.3);
  generation.Layout->AddPolygon("star", 0.35, 0.35);
  EXPECT_EQ(pemesh::GetCaseStatusMessage(generation.MeshAt(0.45)),
    "polygon 1 (comb) and polygon 2 (star) overlap at t = 0.45; move them apart or make them "
    "smaller.");
  generation.Layout->RemoveAllPolygons();
  generation.Layout->AddPolygon("comb", 0.05, 0.5);
  EXPECT_THAT(pemesh::GetCaseStatusMessage(generation.MeshAt(0.9)),
    HasSubstr("polygon 1 (comb) leaves the unit square at t = 0.9"));
}

TEST(DomainMesher, FailedInputIsPassedOnUntouched)
{
  vtkSmartPointer<vtkPolyData> layout =
    MakeLayout({ { { 0.3, 0.3 }, { 0.6, 0.3 }, { 0.6, 0.6 } } });
  pemesh::SetCaseFailed(layout, "unreadable-mesh", "No such file.");
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputData(layout);
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mesher->GetOutput()), "No such file.");
}

// --- Limits
// ------------------------------------------------------------------------------------------

TEST(DomainMesher, TooManyElementsIsAFailureOfTheCase)
{
  Generation generation;
  generation.Layout->AddPolygon("isotropy", 0.5, 0.5);
  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_SHORTEST_EDGE);
  vtkPolyData* mesh = generation.MeshAt(1.0); // asks for 1e11 triangles: told without trying
  EXPECT_EQ(pemesh::GetCaseStatus(mesh), "meshing-failed");
  EXPECT_THAT(pemesh::GetCaseStatusMessage(mesh), HasSubstr("more than 20000000 elements"));
  EXPECT_EQ(mesh->GetNumberOfCells(), 0);

  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_CONSTANT);
  generation.Mesher->SetMaximumArea(0.002);
  generation.Mesher->SetMaximumNumberOfElements(520); // more than 1 / 0.002, less than it takes
  mesh = generation.MeshAt(0.5);
  EXPECT_EQ(pemesh::GetCaseStatus(mesh), "meshing-failed");
  generation.Mesher->SetMaximumNumberOfElements(2000);
  EXPECT_EQ(pemesh::GetCaseStatus(generation.MeshAt(0.5)), "ok") << "a later case is not affected";
}

TEST(DomainMesher, EndsForEveryAngle)
{
  for (const bool preserve : { false, true })
  {
    Generation generation;
    generation.Layout->AddPolygon("star", 0.3, 0.3);
    generation.Layout->AddPolygon("zeta", 0.7, 0.7);
    generation.Layout->SetPolygonRotation(1, 45.0);
    generation.Mesher->SetPreservePolygons(preserve);
    for (const double angle : { 0.0, 10.0, 25.0, 30.0, 33.0 })
    {
      generation.Mesher->SetMinimumAngle(angle);
      vtkPolyData* mesh = generation.MeshAt(0.9);
      ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "") << angle;
      EXPECT_EQ(WhyNotAMesh(mesh), "") << angle;
      EXPECT_LT(mesh->GetNumberOfCells(), 20000) << angle;
      if (!preserve)
      {
        const double own =
          std::min(SmallestOuterAngle(VerticesOf(generation.Layout->GetOutput(), 0)),
            SmallestOuterAngle(VerticesOf(generation.Layout->GetOutput(), 1)));
        EXPECT_GE(
          pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), std::min(angle, own) - 1e-9);
      }
    }
  }
}

TEST(DomainMesher, WrongConfigurationIsAnError)
{
  Generation generation;
  pemesh::ErrorLog log(generation.Mesher);
  generation.Mesher->SetMinimumAngle(NAN);
  EXPECT_EQ(generation.Mesher->GetExecutive()->Update(), 0);
  EXPECT_THAT(log.GetText(), HasSubstr("MinimumAngle is not a number"));
  log.Clear();
  generation.Mesher->SetMinimumAngle(50.0);
  EXPECT_EQ(generation.Mesher->GetMinimumAngle(), 33.0);
  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_CONSTANT);
  for (const double area : { 0.0, -1.0, std::nan("") })
  {
    generation.Mesher->SetMaximumArea(area);
    EXPECT_EQ(generation.Mesher->GetExecutive()->Update(), 0);
    EXPECT_THAT(log.GetText(), HasSubstr("MaximumArea is"));
    log.Clear();
  }
  std::ostringstream text;
  generation.Mesher->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("AreaRule: constant"));
}

// --- Progress and abort
// ------------------------------------------------------------------------------

TEST(DomainMesher, ProgressGrowsAndAbortStops)
{
  Generation generation;
  generation.Layout->AddPolygon("maze", 0.5, 0.5);
  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_CONSTANT);
  generation.Mesher->SetMaximumArea(1e-4);
  struct Watch
  {
    std::vector<double> Fractions;
    bool Abort = false;
  } watch;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* fraction)
    {
      auto* self = static_cast<Watch*>(client);
      self->Fractions.push_back(*static_cast<double*>(fraction));
      if (self->Abort && self->Fractions.back() > 0.0)
      {
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    });
  generation.Mesher->AddObserver(vtkCommand::ProgressEvent, command);
  const vtkIdType cells = generation.MeshAt(0.5)->GetNumberOfCells();
  EXPECT_GT(cells, 10000);
  EXPECT_GT(watch.Fractions.size(), 10u);
  EXPECT_TRUE(std::is_sorted(watch.Fractions.begin(), watch.Fractions.end()));
  EXPECT_EQ(watch.Fractions.back(), 1.0);

  const std::size_t all = watch.Fractions.size();
  watch = {};
  watch.Abort = true;
  EXPECT_EQ(generation.MeshAt(0.6)->GetNumberOfCells(), 0);
  EXPECT_LT(watch.Fractions.size(), all / 2);
  watch.Abort = false;
  generation.Mesher->Modified();
  EXPECT_GT(generation.MeshAt(0.6)->GetNumberOfCells(), 10000) << "runs again when asked again";
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPolygonFamily.h"
#include "vtkPEMPolygonLayout.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"
#include "PolygonPlacement.h"
#include "TestMeshes.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
using pemesh::Point2;
using testing::HasSubstr;

struct Box
{
  double West = 1e9, East = -1e9, South = 1e9, North = -1e9;
};

Box BoxOf(const PolygonVertices& polygon)
{
  Box box;
  for (const Point2& point : polygon)
  {
    box = { std::min(box.West, point.x), std::max(box.East, point.x), std::min(box.South, point.y),
      std::max(box.North, point.y) };
  }
  return box;
}

TEST(PolygonPlacement, ScalesTurnsAndCentres)
{
  const PolygonVertices triangle = { { 0, 0 }, { 4, 0 },
    { 0, 3 } }; // bounding box 4 x 3: diagonal 5
  const PolygonVertices placed = pemesh::PlacePolygon(triangle, { 0.5, 0.25 }, 2.0, 90.0);
  // Diagonal 1: factor 1/5. Turned: (0,0) (0,.8) (-.6,0); box centre (-.3,.4) moved to (.5,.25).
  const PolygonVertices expected = { { 0.8, -0.15 }, { 0.8, 0.65 }, { 0.2, -0.15 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(placed[i].x, expected[i].x, 1e-15);
    EXPECT_NEAR(placed[i].y, expected[i].y, 1e-15);
  }
}

TEST(PolygonPlacement, QuarterTurnsKeepRightAnglesExactly)
{
  const PolygonVertices square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (const double degrees : { 0.0, 90.0, 180.0, 270.0, -90.0, 360.0, 810.0 })
  {
    const PolygonVertices placed = pemesh::PlacePolygon(square, { 0.3, 0.7 }, 1.0, degrees);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Point2& a = placed[i];
      const Point2& b = placed[(i + 1) % 4];
      EXPECT_TRUE(a.x == b.x || a.y == b.y) << degrees;
    }
  }
}

TEST(PolygonLayout, EveryFamilyHasTheSameDiagonalAtEveryTime)
{
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    for (const double t : { 0.0, 0.31, 0.5, 0.93, 1.0 })
    {
      vtkNew<vtkPEMPolygonLayout> layout;
      ASSERT_EQ(family.IsFixed()
          ? layout->AddPolygonFromPoints({ 0, 0, 5, 1, 3, 3, 2, 2, 0, 7 }, 0.4, 0.6)
          : layout->AddPolygon(family.Name, 0.4, 0.6),
        0);
      layout->SetPolygonScale(0, 0.8);
      layout->UpdateTimeStep(t);
      const Box upright = BoxOf(VerticesOf(layout->GetOutput(), 0));
      EXPECT_NEAR(
        std::hypot(upright.East - upright.West, upright.North - upright.South), 0.4, 1e-14);
      const double area = SignedArea(VerticesOf(layout->GetOutput(), 0));

      layout->SetPolygonRotation(0, 33.0);
      layout->UpdateTimeStep(t);
      const PolygonVertices turned = VerticesOf(layout->GetOutput(), 0);
      const Box box = BoxOf(turned);
      EXPECT_NEAR(0.5 * (box.West + box.East), 0.4, 1e-14) << family.Name << " " << t;
      EXPECT_NEAR(0.5 * (box.South + box.North), 0.6, 1e-14) << family.Name << " " << t;
      EXPECT_NEAR(SignedArea(turned), area, 1e-14) << "turning changes no size";
      EXPECT_TRUE(IsSimpleAndCounterClockwise(turned)) << family.Name << " " << t;
    }
  }
}

TEST(PolygonLayout, OutputArrays)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  EXPECT_EQ(layout->AddPolygon("star", 0.25, 0.25), 0);
  EXPECT_EQ(layout->AddPolygon("comb", 0.75, 0.75), 1);
  layout->SetPolygonName(1, "my comb");
  layout->UpdateTimeStep(0.5);
  vtkPolyData* output = layout->GetOutput();
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(output->GetNumberOfCells(), 2);
  vtkDataArray* families = output->GetCellData()->GetArray("ElementFamily");
  vtkDataArray* ids = output->GetCellData()->GetArray("PolygonId");
  auto* names =
    vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("PolygonName"));
  EXPECT_EQ(families->GetTuple1(0), 5);
  EXPECT_EQ(families->GetTuple1(1), 0);
  EXPECT_EQ(ids->GetTuple1(0), 0);
  EXPECT_EQ(ids->GetTuple1(1), 1);
  EXPECT_EQ(names->GetValue(0), "polygon 1 (star)");
  EXPECT_EQ(names->GetValue(1), "my comb");
  EXPECT_EQ(pemesh::GetFieldNumber(output, "t"), 0.5);
  EXPECT_TRUE(pemesh::IsInFieldList(output, pemesh::ParametersList, "t"));
  EXPECT_EQ(output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 0.5);
}

TEST(PolygonLayout, TimeSteps)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("zeta", 0.5, 0.5);
  layout->UpdateInformation();
  vtkInformation* information = layout->GetOutputInformation(0);
  ASSERT_EQ(information->Length(Pipeline::TIME_STEPS()), 20);
  const double* steps = information->Get(Pipeline::TIME_STEPS());
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_DOUBLE_EQ(steps[i], i * 0.9 / 19.0);
  }
  EXPECT_EQ(steps[19], 0.9) << "the last is not spoilt by rounding";
  EXPECT_EQ(information->Get(Pipeline::TIME_RANGE())[0], 0.0);
  EXPECT_EQ(information->Get(Pipeline::TIME_RANGE())[1], 0.9);

  layout->SetFirstTime(0.25);
  layout->SetLastTime(0.75);
  layout->SetNumberOfTimes(3);
  EXPECT_THAT(layout->GetTimes(), testing::ElementsAre(0.25, 0.5, 0.75));
  layout->SetNumberOfTimes(1);
  EXPECT_THAT(layout->GetTimes(), testing::ElementsAre(0.25));
  layout->SetNumberOfTimes(3);
  layout->SetPolygonRange(0, 0.5, 0.5);
  EXPECT_THAT(layout->GetTimes(), testing::ElementsAre(0.25)) << "nothing changes with time";
  layout->RemoveAllPolygons();
  EXPECT_THAT(layout->GetTimes(), testing::ElementsAre(0.25));
}

TEST(PolygonLayout, TimeBetweenStepsAndOwnRanges)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("convexity", 0.5, 0.5);
  layout->AddPolygon("convexity", 0.5, 0.5);
  layout->SetPolygonRange(1, 0.8, 0.4);
  layout->UpdateTimeStep(0.3);
  // Of the second, the deformation is 0.8 - 0.3 * 0.4 = 0.68.
  vtkNew<vtkPEMPolygonLayout> other;
  other->AddPolygon("convexity", 0.5, 0.5);
  other->UpdateTimeStep(0.3);
  EXPECT_EQ(VerticesOf(layout->GetOutput(), 0), VerticesOf(other->GetOutput(), 0));
  other->UpdateTimeStep(0.68);
  const PolygonVertices own = VerticesOf(layout->GetOutput(), 1);
  const PolygonVertices expected = VerticesOf(other->GetOutput(), 0);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(own[i].x, expected[i].x, 1e-15);
    EXPECT_NEAR(own[i].y, expected[i].y, 1e-15);
  }
  layout->SetFirstTime(0.1);
  vtkNew<vtkPEMPolygonLayout> plain;
  plain->AddPolygon("zeta", 0.5, 0.5);
  plain->SetFirstTime(0.1);
  plain->Update();
  EXPECT_EQ(pemesh::GetFieldNumber(plain->GetOutput(), "t"), 0.1);
}

TEST(PolygonLayout, SameTimeTwiceIsOneExecution)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("maze", 0.5, 0.5);
  int executions = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&executions);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  layout->AddObserver(vtkCommand::StartEvent, count);
  layout->UpdateTimeStep(0.5);
  layout->UpdateTimeStep(0.5);
  layout->SetPolygonScale(0, 1.0); // as it is
  layout->SetPolygonRange(0, 0.0, 1.0);
  layout->SetPolygonRotation(0, 0.0);
  layout->SetPolygonCenter(0, 0.5, 0.5);
  layout->SetPolygonName(0, "");
  layout->MovePolygon(0, 0);
  layout->SetFirstTime(0.0);
  layout->UpdateTimeStep(0.5);
  EXPECT_EQ(executions, 1);
  layout->UpdateTimeStep(0.6);
  EXPECT_EQ(executions, 2);
}

TEST(PolygonLayout, UnknownFamilyNamesTheNearest)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  pemesh::ErrorLog log(layout);
  EXPECT_EQ(layout->AddPolygon("starr", 0.5, 0.5), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("no polygon family \"starr\"; did you mean \"star\"?"));
  EXPECT_EQ(layout->GetNumberOfPolygons(), 0);
}

TEST(PolygonLayout, WrongSettersAreErrors)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("maze", 0.5, 0.5);
  layout->AddPolygon("comb", 0.5, 0.5);
  pemesh::ErrorLog log(layout);
  layout->SetPolygonScale(2, 1.0);
  EXPECT_THAT(log.GetText(), HasSubstr("no polygon of index 2"));
  log.Clear();
  layout->SetPolygonParameter(0, "teeth", 5);
  EXPECT_THAT(
    log.GetText(), HasSubstr("In polygon 1 (maze): There is no parameter \"teeth\" here"));
  log.Clear();
  layout->SetPolygonParameter(1, "teeth", 0);
  EXPECT_THAT(log.GetText(),
    HasSubstr("In polygon 2 (comb): teeth is 0; it must be an integer between 1 and "));
  EXPECT_EQ(layout->GetPolygonParameter(1, "teeth"), 10);
  EXPECT_TRUE(std::isnan(layout->GetPolygonParameter(0, "teeth")));
  layout->SetPolygonParameter(1, "teeth", 3);
  EXPECT_EQ(layout->GetPolygonParameter(1, "teeth"), 3);
  const vtkMTimeType before = layout->GetMTime();
  layout->SetPolygonParameter(1, "teeth", 3);
  EXPECT_EQ(layout->GetMTime(), before);
  layout->UpdateTimeStep(1.0);
  EXPECT_EQ(VerticesOf(layout->GetOutput(), 1).size(), 11u);
}

TEST(PolygonLayout, WrongConfigurationStopsThePipeline)
{
  const auto complaint = [](const std::function<void(vtkPEMPolygonLayout*)>& spoil)
  {
    vtkNew<vtkPEMPolygonLayout> layout;
    layout->AddPolygon("zeta", 0.5, 0.5);
    spoil(layout);
    pemesh::ErrorLog log(layout);
    EXPECT_EQ(layout->GetExecutive()->Update(), 0);
    return log.GetText();
  };
  EXPECT_THAT(complaint([](auto* layout) { layout->SetPolygonScale(0, 0.0); }),
    HasSubstr("scale of polygon 1 (zeta) is 0, expected more than 0"));
  EXPECT_THAT(complaint([](auto* layout) { layout->SetPolygonScale(0, NAN); }), HasSubstr("scale"));
  EXPECT_THAT(complaint([](auto* layout) { layout->SetPolygonRotation(0, INFINITY); }),
    HasSubstr("rotation"));
  EXPECT_THAT(
    complaint([](auto* layout) { layout->SetPolygonCenter(0, NAN, 0.5); }), HasSubstr("center"));
  EXPECT_THAT(complaint([](auto* layout) { layout->SetPolygonRange(0, 0.0, 1.5); }),
    HasSubstr("last deformation of polygon 1 (zeta) is 1.5, expected 0 to 1"));
  EXPECT_THAT(complaint(
                [](auto* layout)
                {
                  layout->SetFirstTime(0.8);
                  layout->SetLastTime(0.2);
                }),
    HasSubstr("FirstTime is 0.8 and LastTime 0.2"));
}

TEST(PolygonLayout, ClampsAndPrints)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->SetFirstTime(-1.0);
  layout->SetLastTime(2.0);
  layout->SetNumberOfTimes(0);
  EXPECT_EQ(layout->GetFirstTime(), 0.0);
  EXPECT_EQ(layout->GetLastTime(), 1.0);
  EXPECT_EQ(layout->GetNumberOfTimes(), 1);
  layout->AddPolygon("u-like", 0.5, 0.5);
  std::ostringstream text;
  layout->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("polygon 1 (u-like): family u-like"));
}

TEST(PolygonLayout, FaultsAreToldForAllTimesBeforeMeshing)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("isotropy", 0.3, 0.5);
  layout->AddPolygon("isotropy", 0.7, 0.5);
  layout->SetNumberOfTimes(4);
  // Width sqrt(1/8) = 0.354 at t = 0; flatter is wider: 0.497 at t = 0.9, and the gap is gone at
  // 0.4 = 0.5 / sqrt(1 + (1 - t)^2), that is at t = 0.25.
  EXPECT_EQ(layout->FindFault(0.2), "");
  EXPECT_EQ(layout->FindFault(0.3),
    "polygon 1 (isotropy) and polygon 2 (isotropy) overlap at t = 0.3; move them apart or make "
    "them smaller.");
  EXPECT_EQ(layout->FindFaults().size(), 3u);
}

std::vector<std::string> NamesIn(vtkPEMPolygonLayout* layout)
{
  std::vector<std::string> names;
  for (int i = 0; i < layout->GetNumberOfPolygons(); ++i)
  {
    names.push_back(layout->GetPolygonName(i));
  }
  return names;
}

TEST(PolygonLayout, DuplicateRemoveAndMove)
{
  using testing::ElementsAre;
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("comb", 0.2, 0.2);
  layout->AddPolygon("maze", 0.5, 0.5);
  layout->AddPolygon("random", 0.8, 0.8);
  layout->SetPolygonParameter(2, "seed", 77);
  layout->SetPolygonRange(2, 0.1, 0.4);
  layout->SetPolygonName(1, "M");
  EXPECT_EQ(layout->DuplicatePolygon(2), 3);
  EXPECT_EQ(layout->GetPolygonParameter(3, "seed"), 77);
  EXPECT_EQ(layout->GetPolygonTo(3), 0.4);
  EXPECT_EQ(layout->GetPolygonCenterX(3), 0.8);
  EXPECT_THAT(NamesIn(layout),
    ElementsAre("polygon 1 (comb)", "M", "polygon 3 (random)", "polygon 4 (random)"));
  layout->MovePolygon(0, 2);
  EXPECT_THAT(NamesIn(layout),
    ElementsAre("M", "polygon 2 (random)", "polygon 3 (comb)", "polygon 4 (random)"));
  layout->MovePolygon(3, 0);
  EXPECT_THAT(NamesIn(layout),
    ElementsAre("polygon 1 (random)", "M", "polygon 3 (random)", "polygon 4 (comb)"));
  layout->RemovePolygon(2);
  EXPECT_THAT(NamesIn(layout), ElementsAre("polygon 1 (random)", "M", "polygon 3 (comb)"));
  layout->SetPolygonName(1, "");
  EXPECT_EQ(layout->GetPolygonName(1), "polygon 2 (maze)");

  pemesh::ErrorLog log(layout);
  const vtkMTimeType before = layout->GetMTime();
  EXPECT_EQ(layout->DuplicatePolygon(3), -1);
  layout->RemovePolygon(-1);
  layout->MovePolygon(0, 3);
  layout->MovePolygon(1, 1);
  EXPECT_EQ(layout->GetMTime(), before);
  EXPECT_THAT(log.GetText(), HasSubstr("no polygon of index 3: the layout has 3"));
}

TEST(PolygonLayout, PointsStayAsTheyStandBitByBit)
{
  const std::vector<double> drawn = { 0.1, 0.1, 0.7, 1.0 / 3.0, 0.45, 0.8, 0.3, 0.31 };
  vtkNew<vtkPEMPolygonLayout> layout;
  EXPECT_EQ(layout->AddPolygonFromPoints(drawn), 0);
  EXPECT_EQ(layout->GetPolygonFamily(0), "points");
  EXPECT_EQ(layout->GetPolygonPoints(0), drawn);
  layout->UpdateTimeStep(0.7);
  const PolygonVertices expected = { { 0.1, 0.1 }, { 0.7, 1.0 / 3.0 }, { 0.45, 0.8 },
    { 0.3, 0.31 } };
  EXPECT_EQ(VerticesOf(layout->GetOutput(), 0), expected);
  EXPECT_EQ(layout->GetTimes().size(), 1u) << "it does not depend on t";
  EXPECT_NEAR(layout->GetPolygonScale(0), 2.0 * std::hypot(0.6, 0.7), 1e-15);
  EXPECT_EQ(layout->GetOutput()->GetCellData()->GetArray("ElementFamily")->GetTuple1(0), 10);

  layout->SetPolygonCenter(0, layout->GetPolygonCenterX(0) + 0.125, layout->GetPolygonCenterY(0));
  layout->Update();
  const PolygonVertices moved = VerticesOf(layout->GetOutput(), 0);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(moved[i].x, expected[i].x + 0.125, 1e-15);
    EXPECT_NEAR(moved[i].y, expected[i].y, 1e-15);
  }
}

TEST(PolygonLayout, PointsInEitherOrientationClosedOrNot)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygonFromPoints({ 0.1, 0.1, 0.2, 0.4, 0.5, 0.1, 0.1, 0.1 });
  layout->Update();
  const PolygonVertices expected = { { 0.1, 0.1 }, { 0.5, 0.1 }, { 0.2, 0.4 } };
  EXPECT_EQ(VerticesOf(layout->GetOutput(), 0), expected);
  pemesh::ErrorLog log(layout);
  EXPECT_EQ(layout->AddPolygonFromPoints({ 0.1, 0.1, 0.2 }), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("3 numbers, expected pairs"));
  EXPECT_EQ(layout->AddPolygonFromPoints({ 0.1, 0.1, 0.2, 0.2 }), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("has fewer than three points"));
  EXPECT_EQ(layout->AddPolygonFromPoints({ 0.1, 0.1, 0.2, 0.2, NAN, 0 }, 0.5, 0.5), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("not finite"));
  EXPECT_EQ(layout->AddPolygonFromPoints({ 1, 1, 1, 1, 1, 1, 1, 1 }), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("too small or too large"));
  EXPECT_EQ(layout->AddPolygon("points", 0.5, 0.5), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("AddPolygonFromPoints"));
  EXPECT_EQ(layout->GetNumberOfPolygons(), 1);
  layout->AddPolygonFromPoints({ 0.6, 0.6, 0.9, 0.9, 0.9, 0.6, 0.6, 0.9 });
  EXPECT_THAT(layout->FindFault(0.0), HasSubstr("polygon 2 (points) crosses or touches itself"));
}

TEST(PolygonLayout, FirstPolygonOfAFileIsPlacedLikeTheOthers)
{
  const std::filesystem::path folder = pemesh::TestFolder();
  pemesh::WriteBytes(folder / "two.csv", "x,y\n0,0\n400,0\n0,300\n\n9,9\n8,9\n8,8\n");
  vtkNew<vtkPEMPolygonLayout> layout;
  ASSERT_EQ(layout->AddPolygonFromFile((folder / "two.csv").string(), 0.5, 0.25), 0);
  EXPECT_EQ(layout->GetPolygonFamily(0), "file");
  EXPECT_EQ(layout->GetPolygonFile(0), (folder / "two.csv").string());
  layout->SetPolygonScale(0, 2.0);
  layout->SetPolygonRotation(0, 90.0);
  layout->Update();
  const PolygonVertices placed = VerticesOf(layout->GetOutput(), 0);
  const PolygonVertices expected = { { 0.8, -0.15 }, { 0.8, 0.65 }, { 0.2, -0.15 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(placed[i].x, expected[i].x, 1e-15);
    EXPECT_NEAR(placed[i].y, expected[i].y, 1e-15);
  }
  pemesh::ErrorLog log(layout);
  pemesh::WriteBytes(folder / "bad.csv", "0,0\n1,a\n");
  EXPECT_EQ(layout->AddPolygonFromFile((folder / "bad.csv").string(), 0.5, 0.5), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("bad.csv\", line 2: \"a\" is not a finite number."));
  EXPECT_EQ(layout->GetNumberOfPolygons(), 1);
}

TEST(PolygonFamily, IsALayoutOfOnePolygon)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("star", 0.3, 0.6, 0.5, 30.0);
  layout->SetPolygonParameter(0, "spikes", 7);
  layout->SetPolygonRange(0, 0.25, 1.0);
  vtkNew<vtkPEMPolygonFamily> family; // a comb at first
  family->SetRange(0.25, 1.0);
  family->SetScale(0.5);
  family->SetCenter(0.3, 0.6);
  family->SetRotation(30.0);
  family->SetParameter("teeth", 3);
  family->SetFamily("star"); // keeps the place
  family->SetParameter("spikes", 7);
  for (const double time : { 0.0, 0.5, 0.9 })
  {
    layout->UpdateTimeStep(time);
    family->UpdateTimeStep(time);
    pemesh::ExpectSameMesh(family->GetOutput(), layout->GetOutput());
  }
  EXPECT_EQ(family->GetNumberOfPolygons(), 1);
}

TEST(PolygonFamily, KeepsWhatItHasWhereThereIsNoSuchFamily)
{
  vtkNew<vtkPEMPolygonFamily> family;
  family->SetParameter("teeth", 3);
  const vtkMTimeType before = family->GetMTime();
  family->SetFamily("comb");
  EXPECT_EQ(family->GetMTime(), before);
  const pemesh::ErrorLog errors(family);
  family->SetFamily("coomb");
  EXPECT_THAT(errors.GetText(), HasSubstr("did you mean \"comb\""));
  family->SetFamily("file"); // is no family of a t
  EXPECT_EQ(family->GetFamily(), "comb");
  EXPECT_EQ(family->GetParameter("teeth"), 3.0);
}

} // namespace

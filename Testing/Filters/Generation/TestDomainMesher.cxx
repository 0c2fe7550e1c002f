// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomainMesher.h"

#include "AreaRules.h"
#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTrivialProducer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

namespace
{

using pemesh::Point2;
using testing::HasSubstr;

/** A layout and a mesher behind it. */
struct Generation
{
  vtkNew<vtkPEMPolygonLayout> Layout;
  vtkNew<vtkPEMDomainMesher> Mesher;

  Generation() { this->Mesher->SetInputConnection(this->Layout->GetOutputPort()); }

  vtkPolyData* MeshAt(double t)
  {
    this->Mesher->UpdateTimeStep(t);
    return this->Mesher->GetOutput();
  }
};

/** A mesher of plain polygons. */
vtkSmartPointer<vtkPolyData> MakeLayout(const std::vector<PolygonVertices>& polygons)
{
  auto layout = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const PolygonVertices& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Point2& point : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.x, point.y, 0.0));
    }
  }
  layout->SetPoints(points);
  layout->SetPolys(cells);
  return layout;
}

double LargestFiller(vtkPolyData* mesh)
{
  double largest = 0.0;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (mesh->GetCellData()->GetArray("PolygonId")->GetTuple1(cell) < 0)
    {
      largest = std::max(largest, SignedArea(VerticesOf(mesh, cell)));
    }
  }
  return largest;
}

/** How far a point is from the edge between two others. */
double DistanceToEdge(const Point2& point, const Point2& from, const Point2& to)
{
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double place =
    std::clamp(((point.x - from.x) * (to.x - from.x) + (point.y - from.y) * (to.y - from.y)) /
        (length * length),
      0.0, 1.0);
  return std::hypot(
    point.x - from.x - place * (to.x - from.x), point.y - from.y - place * (to.y - from.y));
}

/**
 * The bound as documented: near a preserved edge of length L an equilateral triangle may have a
 * side of L less 1.5 times the distance of the filler's centroid.
 */
double GradedBound(
  double bound, const PolygonVertices& filler, const std::vector<PolygonVertices>& preserved)
{
  const Point2 centroid = { (filler[0].x + filler[1].x + filler[2].x) / 3.0,
    (filler[0].y + filler[1].y + filler[2].y) / 3.0 };
  for (const PolygonVertices& polygon : preserved)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2& from = polygon[i];
      const Point2& to = polygon[(i + 1) % polygon.size()];
      const double side =
        std::hypot(to.x - from.x, to.y - from.y) - 1.5 * DistanceToEdge(centroid, from, to);
      bound = std::max(bound, side > 0.0 ? std::sqrt(3.0) / 4.0 * side * side : 0.0);
    }
  }
  return bound;
}

/** Whether a filler shares a vertex with a placed polygon. */
bool TouchesPolygon(const PolygonVertices& filler, const PolygonVertices& polygon)
{
  return std::find_first_of(filler.begin(), filler.end(), polygon.begin(), polygon.end()) !=
    filler.end();
}

// --- Every family, several times, all rules, split and preserved
// -----------------------------------

class DomainMesherFamilies : public testing::TestWithParam<std::tuple<int, double, bool>>
{
};

TEST_P(DomainMesherFamilies, IsAMeshWithTheAnglesAndAreasAskedFor)
{
  const auto& [index, t, preserve] = GetParam();
  const pemesh::PolygonFamily& family = pemesh::PolygonFamilies()[index];
  Generation generation;
  generation.Layout->AddPolygon(family.Name, 0.5, 0.5);
  generation.Layout->SetPolygonScale(0, 1.1);
  generation.Layout->SetPolygonRotation(0, 17.0);
  generation.Mesher->SetPreservePolygons(preserve);
  for (const char* rule : { "none", "diagonal", "constant" })
  {
    SCOPED_TRACE(rule);
    generation.Mesher->SetAreaRuleByName(rule);
    generation.Mesher->SetMaximumArea(0.01);
    vtkPolyData* mesh = generation.MeshAt(t);
    ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
    EXPECT_EQ(WhyNotAMesh(mesh), "");
    EXPECT_EQ(WhyNotConstrainedDelaunay(mesh), "");
    const PolygonVertices placed = VerticesOf(generation.Layout->GetOutput(), 0);
    const PolygonVertices element = VerticesOf(mesh, 0);
    if (preserve)
    {
      EXPECT_EQ(element, placed) << "exactly its own vertices";
    }
    else
    {
      EXPECT_EQ(WhyNotConforming(mesh), "");
      EXPECT_EQ(element[0], placed[0]);
    }
    const double bound = pemesh::GetFieldNumber(mesh, "MaximumArea");
    EXPECT_EQ(std::isnan(bound), std::string(rule) == "none");
    EXPECT_TRUE(std::isnan(bound) || preserve || LargestFiller(mesh) <= bound);

    double attained = 180.0;
    const double promised = std::min(20.0, SmallestOuterAngle(placed));
    for (int cell = 1; cell < mesh->GetNumberOfCells(); ++cell)
    {
      const PolygonVertices filler = VerticesOf(mesh, cell);
      const double smallest = AnglesOf(filler)[0];
      attained = std::min(attained, smallest);
      EXPECT_TRUE(std::isnan(bound) || !preserve || TouchesPolygon(filler, placed) ||
        SignedArea(filler) <= GradedBound(bound, filler, { placed }) * (1.0 + 1e-9));
      // Only triangles at a preserved edge may be flatter than the input's own angles ask for.
      const bool excused = preserve && (t > 0.99 || TouchesPolygon(filler, placed));
      EXPECT_TRUE(smallest >= promised - 1e-9 || excused) << "filler " << cell << ": " << smallest;
    }
    EXPECT_NEAR(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), attained, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Everything, DomainMesherFamilies,
  testing::Combine(
    testing::Range(0, 8), testing::Values(0.0, 0.35, 0.5, 0.9, 0.95, 0.999, 1.0), testing::Bool()));

// --- Area rules
// --------------------------------------------------------------------------------------

TEST(AreaRules, FormulasByHand)
{
  // A rectangle 0.2 x 0.1 and a right triangle with legs 0.3 and 0.4.
  const std::vector<PolygonVertices> polygons = { { { 0.1, 0.1 }, { 0.3, 0.1 }, { 0.3, 0.2 },
                                                    { 0.1, 0.2 } },
    { { 0.5, 0.5 }, { 0.8, 0.5 }, { 0.5, 0.9 } } };
  const auto bound = [&](const char* rule, double angle) {
    return pemesh::AreaRules()[pemesh::FindAreaRule(rule)].MaximumArea({ polygons, angle, 0.007 });
  };
  EXPECT_EQ(bound("none", 20.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bound("constant", 20.0), 0.007);
  const double diagonal = 0.5 * (std::hypot(0.2, 0.1) + 0.5);
  EXPECT_NEAR(bound("diagonal", 20.0), diagonal * diagonal / 4.0, 1e-16);
  // Shortest edge 0.1: the sine term is the least up to 25.66 degrees, then sqrt(3)/4.
  EXPECT_NEAR(bound("shortest-edge", 20.0), 0.01 * std::sin(std::acos(-1.0) / 9.0), 1e-16);
  EXPECT_NEAR(bound("shortest-edge", 30.0), 0.01 * std::sqrt(3.0) / 4.0, 1e-16);
  EXPECT_NEAR(bound("shortest-edge", 0.0), 0.01 * std::sqrt(3.0) / 4.0, 1e-16)
    << "no angle asked for: its term is left out";
  EXPECT_EQ(pemesh::FindAreaRule("diagonals"), -1);
}

TEST(AreaRules, SmallestAreaCounts)
{
  const std::vector<PolygonVertices> flat = { { { 0.1, 0.1 }, { 0.5, 0.1 }, { 0.9, 0.1001 },
    { 0.5, 0.101 } } };
  const double area = SignedArea(flat[0]);
  const auto* rule = &pemesh::AreaRules()[pemesh::FindAreaRule("shortest-edge")];
  EXPECT_NEAR(rule->MaximumArea({ flat, 20.0, 0.0 }), area, 1e-15);
}

TEST(DomainMesher, ShortestEdgeRuleHolds)
{
  Generation generation;
  generation.Layout->AddPolygon("n-sided", 0.5, 0.5);
  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_SHORTEST_EDGE);
  vtkPolyData* mesh = generation.MeshAt(0.3); // 15 sides
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  const PolygonVertices placed = VerticesOf(generation.Layout->GetOutput(), 0);
  const double edge = std::hypot(placed[1].x - placed[0].x, placed[1].y - placed[0].y);
  const double bound = edge * edge * std::sin(std::acos(-1.0) / 9.0);
  EXPECT_NEAR(pemesh::GetFieldNumber(mesh, "MaximumArea"), bound, 1e-12);
  EXPECT_LE(LargestFiller(mesh), bound * (1.0 + 1e-9));
}

TEST(DomainMesher, RulesByName)
{
  vtkNew<vtkPEMDomainMesher> mesher;
  EXPECT_EQ(mesher->GetAreaRuleName(), "diagonal");
  for (const char* name : { "none", "shortest-edge", "diagonal", "constant" })
  {
    mesher->SetAreaRuleByName(name);
    EXPECT_EQ(mesher->GetAreaRuleName(), name);
  }
  EXPECT_EQ(mesher->GetAreaRule(), vtkPEMDomainMesher::AREA_CONSTANT);
  pemesh::ErrorLog log(mesher);
  mesher->SetAreaRuleByName("diagnal");
  EXPECT_THAT(log.GetText(), HasSubstr("no area rule \"diagnal\"; did you mean \"diagonal\"?"));
  EXPECT_EQ(mesher->GetAreaRule(), vtkPEMDomainMesher::AREA_CONSTANT);
}

// --- The bare square, and input of other makes
// -------------------------------------------------------

TEST(DomainMesher, EmptyLayoutIsTheBareSquare)
{
  Generation generation;
  EXPECT_EQ(WhyNotAMesh(generation.MeshAt(0.0)), "");
  EXPECT_EQ(generation.Mesher->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_NEAR(
    pemesh::GetFieldNumber(generation.Mesher->GetOutput(), "AttainedMinimumAngle"), 45.0, 1e-12);
  generation.Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_CONSTANT);
  generation.Mesher->SetMaximumArea(0.001);
  vtkPolyData* mesh = generation.MeshAt(0.0);
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  EXPECT_GE(mesh->GetNumberOfCells(), 1000);
  EXPECT_LE(mesh->GetNumberOfCells(), 3000);
  EXPECT_LE(LargestFiller(mesh), 0.001);
}

TEST(DomainMesher, ClockwisePolygonsAreTurnedRound)
{
  const PolygonVertices clockwise = { { 0.3, 0.3 }, { 0.3, 0.6 }, { 0.7, 0.6 }, { 0.7, 0.3 } };
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputData(MakeLayout({ clockwise }));
  mesher->Update();
  EXPECT_EQ(WhyNotAMesh(mesher->GetOutput()), "");
  EXPECT_EQ(VerticesOf(mesher->GetOutput(), 0)[0], clockwise[0]);
}

TEST(DomainMesher, PolygonsAlmostTouching)
{
  // A tip almost at an edge, and a tip almost at the border; the mesh is graded down to the gaps.
  const double gap = 1e-9;
  const PolygonVertices tip = { { 0.2, 0.3 }, { 0.5 - gap, 0.4 }, { 0.2, 0.6 } };
  const PolygonVertices square = { { 0.5, 0.2 }, { 0.8, 0.2 }, { 0.8, 0.5 }, { 0.5, 0.5 } };
  const PolygonVertices atBorder = { { 0.1, 0.8 }, { 0.3, 0.8 }, { 0.17, 1.0 - gap } };
  for (const bool preserve : { false, true })
  {
    vtkNew<vtkPEMDomainMesher> mesher;
    mesher->SetPreservePolygons(preserve);
    mesher->SetInputData(MakeLayout({ tip, square, atBorder }));
    mesher->Update();
    EXPECT_EQ(pemesh::GetCaseStatusMessage(mesher->GetOutput()), "");
    EXPECT_EQ(WhyNotAMesh(mesher->GetOutput()), "");
    EXPECT_LT(mesher->GetOutput()->GetNumberOfCells(), 3000);
    if (!preserve)
    {
      EXPECT_GE(pemesh::GetFieldNumber(mesher->GetOutput(), "AttainedMinimumAngle"), 20.0);
    }
  }
}

TEST(DomainMesher, PreservedPolygonsWithALongNarrowGap)
{
  const double gap = 1e-9;
  const PolygonVertices left = { { 0.2, 0.3 }, { 0.5 - gap, 0.3 }, { 0.5 - gap, 0.6 },
    { 0.2, 0.6 } };
  const PolygonVertices right = { { 0.5, 0.2 }, { 0.8, 0.2 }, { 0.8, 0.5 }, { 0.5, 0.5 } };
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->PreservePolygonsOn();
  mesher->SetInputData(MakeLayout({ left, right }));
  mesher->Update();
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mesher->GetOutput()), "");
  EXPECT_EQ(WhyNotAMesh(mesher->GetOutput()), "");
  EXPECT_LT(mesher->GetOutput()->GetNumberOfCells(), 3000);
}

TEST(DomainMesher, SmallTrianglesAroundLongPreservedEdgesAreNotFlat)
{
  for (const auto& [first, second] :
    { std::pair{ "comb", "star" }, { "zeta", "u-like" }, { "maze", "isotropy" } })
  {
    SCOPED_TRACE(first);
    Generation generation;
    generation.Layout->AddPolygon(first, 0.3, 0.3);
    generation.Layout->AddPolygon(second, 0.7, 0.7);
    generation.Mesher->PreservePolygonsOn();
    generation.Mesher->SetAreaRuleByName("constant");
    for (const double area : { 2e-3, 5e-4, 1e-4 })
    {
      generation.Mesher->SetMaximumArea(area);
      vtkPolyData* mesh = generation.MeshAt(0.9);
      EXPECT_EQ(WhyNotAMesh(mesh), "");
      // Single triangles at a preserved edge may miss the 20 degrees; a bound that is not graded
      // gives hundreds, the worst below a tenth of a degree.
      EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), 10.0) << area;
    }
    // Far from all polygons the bound holds as it is: there is at least the area over the bound.
    EXPECT_GT(generation.Mesher->GetOutput()->GetNumberOfCells(), 1000);
  }
}

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
  generation.Mesher->SetMaximumNumberOfElements(600); // more than 1 / 0.002, less than it takes
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Mirrored and tiled meshes: conforming, of exactly the area of their box, with seams that match to
 * the bit, in exact arithmetic and for boxes whose coordinates no binary number holds.
 */
#include "MeshRepetition.h"

#include "CaseStatus.h"
#include "MeshConversion.h"
#include "MeshInvariants.h"
#include "TestMeshes.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMMirror.h"
#include "vtkPEMPolygonLayout.h"
#include "vtkPEMTile.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CGAL/Exact_rational.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace
{

using pemesh::MeshBox;
using pemesh::Point2;
using pemesh::PolygonMesh;
using pemesh::RepeatedMesh;
using Rational = CGAL::Exact_rational;
using testing::HasSubstr;

constexpr MeshBox UnitBox = { { 0.0, 0.0 }, { 1.0, 1.0 } };
constexpr MeshBox OddBoxes[] = { UnitBox, { { 0.1, 1.0 / 3.0 }, { 0.4, 1.0 } },
  { { -1e6 / 7.0, 1e-3 }, { 1e6 / 3.0, 0.1 } }, { { -0.3, -0.7 }, { -0.1, 1.1 } } };

Rational ExactArea(const std::vector<Point2>& polygon)
{
  Rational twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& next = polygon[(i + 1) % polygon.size()];
    twice += Rational(polygon[i].x) * Rational(next.y) - Rational(next.x) * Rational(polygon[i].y);
  }
  return twice / 2;
}

/** Empty if the mesh is a conforming one of simple elements that fills the box exactly. */
std::string WhyNotFilling(const PolygonMesh& mesh, const MeshBox& box)
{
  Rational area = 0;
  std::vector<Point2> polygon;
  for (int i = 0; i < mesh.NumberOfElements(); ++i)
  {
    mesh.GetVertices(i, polygon);
    if (!IsSimpleAndCounterClockwise(polygon))
    {
      return "element " + std::to_string(i) + " is not simple and counter-clockwise";
    }
    area += ExactArea(polygon);
  }
  if (area !=
    (Rational(box.High.x) - Rational(box.Low.x)) * (Rational(box.High.y) - Rational(box.Low.y)))
  {
    return "the area is not that of the box";
  }
  std::set<std::pair<double, double>> places;
  for (const Point2& point : mesh.Points)
  {
    if (!places.insert({ point.x, point.y }).second)
    {
      return "a point is there twice";
    }
  }
  std::vector<bool> isUsed(mesh.Points.size(), false);
  const pemesh::MeshAdjacency adjacency = pemesh::FindAdjacency(mesh);
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    isUsed[mesh.Vertices[side]] = true;
    const Point2& a = mesh.Points[mesh.Vertices[side]];
    const Point2& b =
      mesh.Points[mesh.Vertices[pemesh::NextSide(mesh, adjacency.Element[side], side)]];
    const bool isOnBox = (a.x == b.x && (a.x == box.Low.x || a.x == box.High.x)) ||
      (a.y == b.y && (a.y == box.Low.y || a.y == box.High.y));
    if (adjacency.Twin[side] == pemesh::MeshAdjacency::Conflict ||
      isOnBox != (adjacency.Twin[side] == pemesh::MeshAdjacency::Border))
    {
      return "side " + std::to_string(side) + " has a wrong number of elements";
    }
  }
  return std::find(isUsed.begin(), isUsed.end(), false) == isUsed.end() ? "" : "unused points";
}

/** Two polygons in the unit square with triangles around. */
vtkSmartPointer<vtkPolyData> MakeMesherMesh()
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("comb", 0.3, 0.3);
  layout->SetPolygonScale(0, 0.8);
  layout->SetPolygonRotation(0, 20.0);
  layout->AddPolygon("random", 0.7, 0.75);
  layout->SetPolygonScale(1, 0.6);
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->UpdateTimeStep(0.6);
  return mesher->GetOutput();
}

/** A mesh of the unit square, moved to another box, whose sides it keeps exactly. */
PolygonMesh MoveTo(PolygonMesh mesh, const MeshBox& box)
{
  const auto move = [](double x, double low, double high)
  { return x == 1.0 ? high : low + x * (high - low); };
  for (Point2& point : mesh.Points)
  {
    point = { move(point.x, box.Low.x, box.High.x), move(point.y, box.Low.y, box.High.y) };
  }
  return mesh;
}

/** One element, with other vertices on the left than on the right, and on the top than below. */
PolygonMesh MakeUneven()
{
  PolygonMesh mesh;
  mesh.Points = { { 0, 0 }, { 0.2, 0 }, { 0.3, 0 }, { 1, 0 }, { 1, 0.5 }, { 1, 1 }, { 0.7, 1 },
    { 0.6, 1 }, { 0, 1 }, { 0, 1.0 / 3.0 } };
  const int vertices[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  mesh.AddElement(vertices);
  return mesh;
}

PolygonMesh Mirror(PolygonMesh mesh, int times)
{
  for (int i = 0; i < times; ++i)
  {
    RepeatedMesh repeated = pemesh::RepeatMesh(mesh, pemesh::MirrorOnce(pemesh::BoxOfMesh(mesh)));
    EXPECT_EQ(repeated.Message, "");
    mesh = std::move(repeated.Mesh);
  }
  return mesh;
}

} // namespace

TEST(MeshRepetition, MirroredMeshesFillTheirBoxExactly)
{
  const PolygonMesh unit = pemesh::ToPolygonMesh(MakeMesherMesh());
  for (const MeshBox& box : OddBoxes)
  {
    const PolygonMesh mesh = MoveTo(unit, box);
    for (const int times : { 1, 2 })
    {
      const PolygonMesh mirrored = Mirror(mesh, times);
      EXPECT_EQ(WhyNotFilling(mirrored, box), "") << box.Low.x << " " << times;
      EXPECT_EQ(mirrored.NumberOfElements(), mesh.NumberOfElements() * std::pow(4, times));
    }
  }
}

TEST(MeshRepetition, TiledMeshesFillTheirBoxExactly)
{
  const PolygonMesh unit = pemesh::ToPolygonMesh(MakeMesherMesh());
  for (const MeshBox& box : OddBoxes)
  {
    for (const int count : { 2, 3, 5 })
    {
      for (const PolygonMesh& mesh : { MoveTo(unit, box), MoveTo(MakeUneven(), box) })
      {
        const RepeatedMesh tiled = pemesh::RepeatMesh(mesh, pemesh::TileBox(box, count, count));
        EXPECT_EQ(tiled.Message, "");
        EXPECT_EQ(WhyNotFilling(tiled.Mesh, box), "") << box.Low.x << " " << count;
        EXPECT_EQ(tiled.Mesh.NumberOfElements(), mesh.NumberOfElements() * count * count);
      }
    }
  }
}

TEST(MeshRepetition, FewerRowsThanColumnsKeepTheShape)
{
  for (const MeshBox& box : OddBoxes)
  {
    const PolygonMesh mesh = MoveTo(MakeUneven(), box);
    const RepeatedMesh tiled = pemesh::RepeatMesh(mesh, pemesh::TileBox(box, 4, 2));
    const MeshBox filled = pemesh::BoxOfMesh(tiled.Mesh);
    EXPECT_EQ(filled.Low, box.Low);
    EXPECT_EQ(filled.High.x, box.High.x);
    EXPECT_NEAR(filled.High.y, 0.5 * (box.Low.y + box.High.y), 1e-15);
    EXPECT_EQ(WhyNotFilling(tiled.Mesh, filled), "");
    const RepeatedMesh row = pemesh::RepeatMesh(mesh, pemesh::TileBox(box, 1, 7));
    EXPECT_EQ(pemesh::BoxOfMesh(row.Mesh).High.y, box.High.y);
    EXPECT_EQ(WhyNotFilling(row.Mesh, pemesh::BoxOfMesh(row.Mesh)), "");
  }
}

TEST(MeshRepetition, OtherVerticesOfASeamBecomeStraightOnes)
{
  const RepeatedMesh tiled = pemesh::RepeatMesh(MakeUneven(), pemesh::TileBox(UnitBox, 2, 2));
  std::vector<std::size_t> sizes;
  std::vector<Point2> last;
  for (int i = 0; i < 4; ++i)
  {
    sizes.push_back(tiled.Mesh.Element(i).size());
  }
  // One from the side, two from above or below.
  EXPECT_EQ(sizes, (std::vector<std::size_t>{ 13, 13, 13, 13 }));
  tiled.Mesh.GetVertices(0, last);
  const std::vector<Point2> expected = { { 0, 0 }, { 0.1, 0 }, { 0.15, 0 }, { 0.5, 0 },
    { 0.5, (1.0 / 3.0) / 2.0 }, { 0.5, 0.25 }, { 0.5, 0.5 }, { 0.35, 0.5 }, { 0.3, 0.5 },
    { 0.15, 0.5 }, { 0.1, 0.5 }, { 0, 0.5 }, { 0, (1.0 / 3.0) / 2.0 } };
  EXPECT_EQ(last, expected);
  EXPECT_EQ(tiled.Sources, (std::vector<int>{ 0, 0, 0, 0 }));
}

TEST(MeshRepetition, MirroredUnitSquareByHand)
{
  PolygonMesh mesh = pemesh::ToPolygonMesh(pemesh::MakeHouse());
  mesh.Points.push_back({ 7.0, 7.0 }); // of no element
  const RepeatedMesh mirrored = pemesh::RepeatMesh(mesh, pemesh::MirrorOnce(UnitBox));
  EXPECT_EQ(mirrored.Mesh.Points.size(), 15u) << "5 by 3";
  EXPECT_EQ(mirrored.Sources, (std::vector<int>{ 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2 }));
  std::vector<Point2> vertices;
  mirrored.Mesh.GetVertices(5, vertices); // triangle (.5,0) (1,0) (.5,1), reflected in x
  EXPECT_EQ(vertices, (std::vector<Point2>{ { 0.75, 0 }, { 0.75, 0.5 }, { 0.5, 0 } }));
  mirrored.Mesh.GetVertices(7, vertices); // in both
  EXPECT_EQ(vertices, (std::vector<Point2>{ { 0.75, 1 }, { 0.5, 1 }, { 0.75, 0.5 } }));
}

TEST(MeshRepetition, SeamsThatArePointsOrEmptyAreRefused)
{
  PolygonMesh triangle;
  triangle.Points = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
  triangle.AddElement(std::vector<int>{ 0, 1, 2 });
  EXPECT_THAT(pemesh::RepeatMesh(triangle, pemesh::MirrorOnce(UnitBox)).Message,
    HasSubstr("none on the east side of its bounding box"));
  EXPECT_THAT(pemesh::RepeatMesh(triangle, pemesh::TileBox(UnitBox, 2, 1)).Message,
    HasSubstr("none on the east and the west side"));
  // A parallelogram whose upright sides meet in a point only when it is tiled, and can be mirrored.
  PolygonMesh slanted;
  slanted.Points = { { 0, 0 }, { 1, 1 }, { 1, 2 }, { 0, 1 } };
  slanted.AddElement(std::vector<int>{ 0, 1, 2, 3 });
  EXPECT_THAT(pemesh::RepeatMesh(slanted, pemesh::TileBox({ { 0, 0 }, { 1, 2 } }, 2, 1)).Message,
    HasSubstr("No segment of the border is common"));
  // An L: its straight sides hold the copies together.
  PolygonMesh corner;
  corner.Points = { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0.5, 0.5 }, { 0.5, 1 }, { 0, 1 } };
  corner.AddElement(std::vector<int>{ 0, 1, 2, 3, 4, 5 });
  const PolygonMesh mirrored = Mirror(corner, 1);
  Rational area = 0;
  std::vector<Point2> polygon;
  for (int i = 0; i < 4; ++i)
  {
    mirrored.GetVertices(i, polygon);
    area += ExactArea(polygon);
  }
  EXPECT_EQ(area, Rational(3) / 4);
  const pemesh::MeshAdjacency adjacency = pemesh::FindAdjacency(mirrored);
  EXPECT_EQ(
    std::count(adjacency.Twin.begin(), adjacency.Twin.end(), pemesh::MeshAdjacency::Border), 24 - 8)
    << "four seams of one side each";
  EXPECT_EQ(pemesh::RepeatMesh(PolygonMesh(), pemesh::MirrorOnce(UnitBox)).Message,
    "The mesh has no elements.");
}

TEST(MeshRepetition, ElementsThatRoundingWouldSpoilAreNamed)
{
  PolygonMesh mesh;
  mesh.Points = { { 0, 0 }, { 1e-20, 0 }, { 1, 0 }, { 1, 1 }, { 1e-20, 1 }, { 0, 1 } };
  mesh.AddElement(std::vector<int>{ 1, 2, 3, 4 });
  mesh.AddElement(std::vector<int>{ 0, 1, 4, 5 });
  EXPECT_THAT(pemesh::RepeatMesh(mesh, pemesh::MirrorOnce(UnitBox)).Message,
    testing::StartsWith("Element 1 is too thin for its copies"));
  mesh.Points[1].x = mesh.Points[4].x = 1e-9;
  EXPECT_EQ(WhyNotFilling(Mirror(mesh, 3), UnitBox), "");
}

TEST(Mirror, CarriesProvenanceAndFieldDataOnly)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesherMesh();
  vtkNew<vtkDoubleArray> metric;
  metric->SetName("Area");
  metric->SetNumberOfTuples(mesh->GetNumberOfCells());
  mesh->GetCellData()->AddArray(metric);
  vtkNew<vtkPEMMirror> mirror;
  mirror->SetInputData(mesh);
  mirror->Update();
  vtkPolyData* output = mirror->GetOutput();
  EXPECT_EQ(output->GetNumberOfCells(), 4 * mesh->GetNumberOfCells());
  EXPECT_EQ(WhyNotAMesh(output), "") << "judged as a mesh of the mesher";
  EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), 2);
  vtkDataArray* ids = output->GetCellData()->GetArray("PolygonId");
  vtkDataArray* families = output->GetCellData()->GetArray("ElementFamily");
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(ids->GetTuple1(i), i < 4 ? 0 : i < 8 ? 1 : -1);
    EXPECT_EQ(families->GetTuple1(i), i < 4 ? 0 : i < 8 ? 8 : -1);
  }
  EXPECT_EQ(pemesh::GetFieldNumber(output, "t"), 0.6);
  mirror->SetNumberOfTimes(2);
  mirror->Update();
  EXPECT_EQ(mirror->GetOutput()->GetNumberOfCells(), 16 * mesh->GetNumberOfCells());
  EXPECT_EQ(mirror->GetOutput()->GetCellData()->GetArray("PolygonId")->GetTuple1(31), 1);
  EXPECT_EQ(WhyNotAMesh(mirror->GetOutput()), "");
}

TEST(Mirror, PassesOnWhatItNeedNotOrCannotChange)
{
  const auto mesh = pemesh::MakeHouse();
  vtkNew<vtkPEMMirror> mirror;
  mirror->SetInputData(mesh);
  mirror->SetNumberOfTimes(0);
  mirror->Update();
  pemesh::ExpectSameMesh(mirror->GetOutput(), mesh);
  vtkNew<vtkPolyData> failed;
  pemesh::SetCaseFailed(failed, "invalid-layout", "Why.");
  mirror->SetInputData(failed);
  mirror->SetNumberOfTimes(1);
  mirror->Update();
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mirror->GetOutput()), "Why.");
}

TEST(Mirror, RefusalsAreTheStatusOfTheCase)
{
  vtkNew<vtkPEMMirror> mirror;
  mirror->SetInputData(pemesh::MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } }));
  mirror->Update();
  EXPECT_EQ(pemesh::GetCaseStatus(mirror->GetOutput()), "not-mirrorable");
  EXPECT_THAT(pemesh::GetCaseStatusMessage(mirror->GetOutput()), HasSubstr("east side"));
  EXPECT_EQ(mirror->GetOutput()->GetNumberOfCells(), 0);
  mirror->SetInputData(pemesh::MakeHouse());
  mirror->SetNumberOfTimes(14);
  mirror->Update();
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mirror->GetOutput()),
    "The repeated mesh would have more than 20000000 elements; repeat it less often or raise the "
    "limit.");
  mirror->SetNumberOfTimes(99);
  EXPECT_EQ(mirror->GetNumberOfTimes(), 14);
}

TEST(Tile, TilesAndRefuses)
{
  vtkNew<vtkPEMTile> tile;
  tile->SetInputData(pemesh::MakeHouse());
  tile->SetNumberOfColumns(3);
  tile->Update();
  EXPECT_EQ(tile->GetOutput()->GetNumberOfCells(), 18);
  EXPECT_EQ(tile->GetOutput()->GetCellData()->GetArray("PolygonId")->GetTuple1(0), -1);
  tile->SetNumberOfColumns(1);
  tile->SetNumberOfRows(1);
  tile->Update();
  pemesh::ExpectSameMesh(tile->GetOutput(), pemesh::MakeHouse());
  tile->SetInputData(pemesh::MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } }));
  tile->SetNumberOfColumns(2);
  tile->Update();
  EXPECT_EQ(pemesh::GetCaseStatus(tile->GetOutput()), "not-tileable");
}

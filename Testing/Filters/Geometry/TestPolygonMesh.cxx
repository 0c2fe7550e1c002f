// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Domain.h"
#include "PolygonMesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/** Two squares side by side; the right one has a straight vertex on its lower side. */
PolygonMesh MakeTwoSquares()
{
  PolygonMesh mesh;
  mesh.Points = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 0, 1 }, { 1.5, 0 } };
  mesh.AddElement(std::vector<int>{ 0, 1, 4, 5 });
  mesh.AddElement(std::vector<int>{ 1, 6, 2, 3, 4 });
  return mesh;
}

std::vector<Point2> Square(double low, double high)
{
  return { { low, low }, { high, low }, { high, high }, { low, high } };
}

TEST(PolygonMesh, SidesAreElementAfterElement)
{
  const PolygonMesh mesh = MakeTwoSquares();
  EXPECT_EQ(mesh.NumberOfElements(), 2);
  EXPECT_THAT(mesh.Offsets, ElementsAre(0, 4, 9));
  EXPECT_EQ(NextSide(mesh, 0, 3), 0);
  EXPECT_EQ(NextSide(mesh, 1, 4), 5);
  EXPECT_EQ(PreviousSide(mesh, 1, 4), 8);
}

TEST(PolygonMesh, CommonSidesFindEachOther)
{
  constexpr int None = MeshAdjacency::Border;
  const MeshAdjacency adjacency = FindAdjacency(MakeTwoSquares());
  EXPECT_THAT(adjacency.Element, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 1));
  EXPECT_THAT(adjacency.Twin, ElementsAre(None, 8, None, None, None, None, None, None, 1));
}

TEST(PolygonMesh, SidesOfThreeElementsOrOfTwoThatTurnTheSameWayAreConflicts)
{
  PolygonMesh mesh = MakeTwoSquares();
  mesh.AddElement(std::vector<int>{ 1, 4, 0 });
  const MeshAdjacency three = FindAdjacency(mesh);
  EXPECT_EQ(three.Twin[1], MeshAdjacency::Conflict);
  EXPECT_EQ(three.Twin[8], MeshAdjacency::Conflict);
  mesh = MakeTwoSquares();
  std::reverse(mesh.Vertices.begin() + 4, mesh.Vertices.end());
  EXPECT_EQ(FindAdjacency(mesh).Twin[1], MeshAdjacency::Conflict);
}

TEST(PolygonMesh, UnusedPointsGo)
{
  PolygonMesh mesh = MakeTwoSquares();
  mesh.Points.insert(mesh.Points.begin(), { 9, 9 });
  std::for_each(mesh.Vertices.begin(), mesh.Vertices.end(), [](int& vertex) { ++vertex; });
  EXPECT_THAT(RemoveUnusedPoints(mesh), ElementsAre(-1, 0, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(mesh.Points, MakeTwoSquares().Points);
  EXPECT_EQ(mesh.Vertices, MakeTwoSquares().Vertices);
}

TEST(Domain, LoopsInAnyOrderAndOrientationMakeOne)
{
  std::vector<Point2> hole = Square(1, 2);
  std::reverse(hole.begin(), hole.end());
  Domain domain;
  EXPECT_EQ(MakeDomain({ hole, Square(0, 4), Square(2.5, 3) }, domain), "");
  EXPECT_EQ(domain.Outer, Square(0, 4));
  ASSERT_EQ(domain.Holes.size(), 2U);
  EXPECT_DOUBLE_EQ(DomainArea(domain), 16 - 1 - 0.25);
  EXPECT_FALSE(IsRectangle(domain));
}

TEST(Domain, ImpossibleOnesAreRefusedByName)
{
  Domain domain;
  EXPECT_THAT(MakeDomain({}, domain), HasSubstr("no loop"));
  EXPECT_THAT(MakeDomain({ { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } } }, domain),
    HasSubstr("loop 1 of the domain crosses"));
  EXPECT_THAT(MakeDomain({ Square(0, 4), Square(0, 1) }, domain), HasSubstr("Hole 1"));
  EXPECT_THAT(MakeDomain({ Square(0, 4), Square(5, 6) }, domain), HasSubstr("beside"));
  EXPECT_THAT(MakeDomain({ Square(0, 9), Square(1, 3), Square(2, 4) }, domain),
    HasSubstr("Holes 1 and 2 of the domain meet"));
  EXPECT_THAT(MakeDomain({ Square(0, 9), Square(1, 4), Square(2, 3) }, domain),
    HasSubstr("Holes 1 and 2 of the domain meet"));
}

TEST(Domain, OnlyUprightRectanglesAreRectangles)
{
  EXPECT_TRUE(IsRectangle(UnitSquare()));
  EXPECT_TRUE(IsRectangle({ { { 2, 1 }, { 2, 5 }, { -1, 5 }, { -1, 1 } }, {} }));
  EXPECT_FALSE(IsRectangle({ { { 0, 0 }, { 1, 0 }, { 2, 1 }, { 1, 1 } }, {} }));
  EXPECT_FALSE(IsRectangle({ { { 0, 0 }, { 1, 0 }, { 1, 1 } }, {} }));
}

} // namespace

} // namespace pemesh

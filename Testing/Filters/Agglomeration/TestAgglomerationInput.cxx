// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationInput.h"

#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

std::string WhyNot(const PolygonMesh& mesh)
{
  return WhyNotAgglomerable(mesh, FindAdjacency(mesh));
}

PolygonMesh MakeMesh(const std::vector<Point2>& points, const std::vector<std::vector<int>>& cells)
{
  PolygonMesh mesh;
  mesh.Points = points;
  for (const std::vector<int>& cell : cells)
  {
    mesh.AddElement(cell);
  }
  return mesh;
}

TEST(AgglomerationInput, TakesConformingMeshes)
{
  for (const SampleMesh& sample : SampleMeshes())
  {
    EXPECT_EQ(WhyNot(sample.Mesh), "") << sample.Name;
  }
}

TEST(AgglomerationInput, TakesTwoPieces)
{
  EXPECT_EQ(WhyNot(MakeMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 3, 0 }, { 2, 1 } },
              { { 0, 1, 2 }, { 3, 4, 5 } })),
    "");
}

TEST(AgglomerationInput, RefusesAnEmptyMesh)
{
  EXPECT_THAT(WhyNot({}), HasSubstr("no elements"));
}

TEST(AgglomerationInput, RefusesElementsThatAreNotSimple)
{
  const std::vector<Point2> square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_THAT(
    WhyNot(MakeMesh(square, { { 0, 1, 3, 2 } })), HasSubstr("Element 0 crosses or touches itself"));
  EXPECT_THAT(WhyNot(MakeMesh(square, { { 0, 2, 1 } })), HasSubstr("clockwise"));
  EXPECT_THAT(WhyNot(MakeMesh(square, { { 0, 1, 2 }, { 0, 2 } })), HasSubstr("Element 1"));
  std::vector<Point2> infinite = square;
  infinite[2].x = std::numeric_limits<double>::infinity();
  EXPECT_THAT(WhyNot(MakeMesh(infinite, { { 0, 1, 2, 3 } })), HasSubstr("finite"));
  // A triangle of no area, and a pentagram, which turns left everywhere.
  EXPECT_THAT(
    WhyNot(MakeMesh({ { 0, 0 }, { 1, 1 }, { 2, 2 } }, { { 0, 1, 2 } })), HasSubstr("Element 0"));
  PolygonMesh pentagram;
  for (int i = 0; i < 5; ++i)
  {
    const double angle = 4.0 * std::numbers::pi * i / 5.0;
    pentagram.Points.push_back({ std::cos(angle), std::sin(angle) });
  }
  pentagram.AddElement(std::vector<int>{ 0, 1, 2, 3, 4 });
  EXPECT_THAT(WhyNot(pentagram), HasSubstr("Element 0 crosses or touches itself"));
}

TEST(AgglomerationInput, RefusesASideOfThreeElements)
{
  EXPECT_THAT(WhyNot(MakeMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, -1 }, { 0.5, -2 } },
                { { 0, 1, 2 }, { 1, 0, 3 }, { 1, 0, 4 } })),
    HasSubstr("more than two elements"));
}

TEST(AgglomerationInput, RefusesAHangingNodeThatTheNeighborDoesNotKnow)
{
  const std::vector<Point2> points = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 0, 1 }, { 2, 2 },
    { 0, 2 }, { 1, 2 } };
  EXPECT_THAT(WhyNot(MakeMesh(points, { { 0, 1, 2, 4 }, { 4, 3, 7, 6 }, { 3, 2, 5, 7 } })),
    HasSubstr("not conforming"));
  EXPECT_EQ(WhyNot(MakeMesh(points, { { 0, 1, 2, 3, 4 }, { 4, 3, 7, 6 }, { 3, 2, 5, 7 } })), "");
}

TEST(AgglomerationInput, RefusesABorderThatTouchesItself)
{
  EXPECT_THAT(WhyNot(MakeMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 1, 2 } },
                { { 0, 1, 2 }, { 2, 3, 4 } })),
    HasSubstr("touches itself at vertex 2"));
}

TEST(AgglomerationInput, RefusesPiecesThatOverlap)
{
  EXPECT_THAT(WhyNot(MakeMesh({ { 0, 0 }, { 4, 0 }, { 0, 4 }, { 1, -1 }, { 3, -1 }, { 2, 1 } },
                { { 0, 1, 2 }, { 3, 4, 5 } })),
    HasSubstr("not conforming"));
}

/** The double cover of a square, cut open: about its centre eight triangles wind twice. */
TEST(AgglomerationInput, RefusesElementsThatWindTwiceAboutAVertex)
{
  PolygonMesh mesh;
  mesh.Points = { { 0, 0 } };
  for (int i = 0; i < 8; ++i)
  {
    const double angle = std::numbers::pi * i / 2.0;
    const double radius = 1.0 + 0.1 * i;
    mesh.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  for (int i = 0; i < 8; ++i)
  {
    mesh.AddElement(std::vector<int>{ 0, 1 + i, 1 + (i + 1) % 8 });
  }
  EXPECT_THAT(WhyNot(mesh), HasSubstr("not conforming")); // its border crosses itself
  // Two squares on top of each other that share their centre only: nested borders.
  PolygonMesh nested;
  nested.Points = { { 0, 0 } };
  for (const double size : { 1.0, 2.0 })
  {
    const int first = static_cast<int>(nested.Points.size());
    for (const Point2& p : { Point2{ 1, 0 }, Point2{ 0, 1 }, Point2{ -1, 0 }, Point2{ 0, -1 } })
    {
      nested.Points.push_back({ size * p.x, size * p.y });
    }
    for (int i = 0; i < 4; ++i)
    {
      nested.AddElement(std::vector<int>{ 0, first + i, first + (i + 1) % 4 });
    }
  }
  EXPECT_THAT(WhyNot(nested), HasSubstr("more than once about a vertex"));
}

} // namespace

} // namespace pemesh

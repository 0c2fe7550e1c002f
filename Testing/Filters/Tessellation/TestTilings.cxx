// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonMeasures.h"
#include "SampleDomains.h"
#include "TessellationInvariants.h"
#include "Tessellations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

using Settings = std::initializer_list<std::pair<const char*, double>>;

PolygonMesh Make(const char* name, const Settings& settings, const Domain& domain = UnitSquare())
{
  const Tessellation& kind = Tessellations()[FindTessellation(name)];
  TessellationInput input;
  input.Values = ParameterValues(kind.Parameters);
  input.Region = domain;
  for (const auto& [parameter, value] : settings)
  {
    EXPECT_EQ(input.Values.Set(parameter, value), "");
  }
  TessellationResult result = MakeTessellation(kind, input);
  EXPECT_EQ(result.Message, "");
  EXPECT_EQ(WhyNotAMeshOf(domain, result.Mesh), "") << name;
  return std::move(result.Mesh);
}

std::vector<Point2> ElementOf(const PolygonMesh& mesh, int element)
{
  std::vector<Point2> vertices;
  mesh.GetVertices(element, vertices);
  return vertices;
}

/** How many elements have how many vertices. */
std::map<int, int> CountVertices(const PolygonMesh& mesh)
{
  std::map<int, int> counts;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    ++counts[static_cast<int>(mesh.Element(element).size())];
  }
  return counts;
}

using Counts = std::map<int, int>;

TEST(Tilings, HaveTheElementsThatTheyShould)
{
  EXPECT_EQ(CountVertices(Make("squares", { { "squares", 7 } })), (Counts{ { 4, 49 } }));
  EXPECT_EQ(CountVertices(Make("triangles", { { "squares", 7 } })), (Counts{ { 3, 98 } }));
  EXPECT_EQ(CountVertices(Make("octagons", { { "squares", 7 } })),
    (Counts{ { 3, 28 }, { 4, 36 }, { 8, 49 } }));
  EXPECT_EQ(
    CountVertices(Make("bricks", { { "squares", 4 }, { "offset", 0 } })), (Counts{ { 4, 16 } }));
  // Of 4 x 4 bricks a row gains 3 vertices where it borders on another one: 6 times 3.
  EXPECT_EQ(Make("bricks", { { "squares", 4 } }).NumberOfSides(), 64 + 18);
  EXPECT_EQ(CountVertices(Make("koch", { { "squares", 3 }, { "depth", 2 } }))[4 + 4 * 15], 1);
  // As square as they can be.
  EXPECT_EQ(
    Make("squares", { { "squares", 6 } }, RectangleDomain(1, 2, 4, 3)).NumberOfElements(), 12);
}

TEST(Tilings, OctagonsAreRegular)
{
  const PolygonMesh mesh = Make("octagons", { { "squares", 4 } });
  for (int element = 0; element < 16; ++element)
  {
    const EdgeLengths edges = MeasureEdges(ElementOf(mesh, element));
    EXPECT_NEAR(edges.Shortest, 0.25 / (1.0 + std::numbers::sqrt2), 1e-14);
    EXPECT_NEAR(edges.Longest, edges.Shortest, 1e-14);
  }
}

TEST(Tilings, HexagonsInsideAreRegular)
{
  const PolygonMesh mesh = Make("hexagons", { { "cells", 8 } });
  const double side = 1.0 / 8.0 / std::numbers::sqrt3;
  const double area = 1.5 * std::numbers::sqrt3 * side * side;
  int whole = 0;
  double least = area;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const std::vector<Point2> vertices = ElementOf(mesh, element);
    least = std::min(least, SignedArea(vertices));
    if (SignedArea(vertices) > 0.999 * area)
    {
      ++whole;
      EXPECT_NEAR(SignedArea(vertices), area, 1e-14);
      EXPECT_NEAR(MeasureEdges(vertices).Shortest, side, 1e-13);
      EXPECT_NEAR(MeasureAngles(vertices).Largest, 2.0 * std::numbers::pi / 3.0, 1e-12);
    }
  }
  // Rows are 1.5 sides apart; the gap between two is in the middle, and with four on either side of
  // it the tips are 6.5 sides from there, of 6.93 to the border; by turns 8 and 7 are whole.
  EXPECT_EQ(whole, 4 * 8 + 4 * 7);
  EXPECT_GT(least, 0.05 * area);
}

TEST(Tilings, QuarteredSquaresFollowLevelsAndShare)
{
  EXPECT_EQ(
    CountVertices(Make("hanging-squares", { { "squares", 3 }, { "levels", 2 }, { "share", 1 } })),
    (Counts{ { 4, 144 } }));
  EXPECT_EQ(Make("hanging-squares", { { "squares", 3 }, { "share", 0 } }).NumberOfElements(), 9);
  const PolygonMesh mesh = Make("hanging-squares", { { "squares", 16 }, { "levels", 3 } });
  std::map<double, int> areas;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    ++areas[SignedArea(ElementOf(mesh, element)) * 256.0];
  }
  ASSERT_EQ(areas.size(), 4U); // powers of two: exactly
  // A share of 0.4 is quartered: of 256 about 102, of their 410 about 164.
  EXPECT_NEAR(areas[1.0], 154, 30);
  EXPECT_NEAR(areas[1.0 / 4.0], 0.6 * 4.0 * (256 - areas[1.0]), 60);
  EXPECT_GT(areas[1.0 / 64.0], 0);
}

TEST(Tilings, DistortedQuadrilateralsAreConvexUpToAQuarter)
{
  for (const double seed : { 1.0, 2.0, 3.0 })
  {
    const PolygonMesh mesh = Make(
      "distorted-quadrilaterals", { { "squares", 12 }, { "distortion", 0.25 }, { "seed", seed } });
    for (int element = 0; element < mesh.NumberOfElements(); ++element)
    {
      EXPECT_TRUE(IsConvex(ElementOf(mesh, element)));
    }
    Make(
      "distorted-quadrilaterals", { { "squares", 25 }, { "distortion", 0.499 }, { "seed", seed } });
  }
}

TEST(Tilings, DartsAreNotConvexBeyondAHalf)
{
  for (const double amplitude : { 0.4, 0.6, 0.99 })
  {
    const PolygonMesh mesh = Make("darts", { { "squares", 6 }, { "amplitude", amplitude } });
    for (int row = 1; row < 5; ++row)
    {
      for (int column = 1; column < 5; ++column)
      {
        const std::vector<Point2> vertices = ElementOf(mesh, 6 * row + column);
        EXPECT_EQ(IsConvex(vertices), amplitude < 0.5);
        // The tip: its sides are (1 - a, -a) and (-a, 1 - a).
        const double a = amplitude;
        const double tip = std::acos(-2.0 * a * (1.0 - a) / (a * a + (1.0 - a) * (1.0 - a)));
        const std::vector<double> angles = InteriorAngles(vertices);
        const double angle = (row + column) % 2 == 0 ? angles[0] : angles[2];
        EXPECT_NEAR(angle, a > 0.5 ? 2.0 * std::numbers::pi - tip : tip, 1e-10);
      }
    }
  }
}

TEST(Tilings, ZigzagAndKochKeepTheAreaOfInnerSquares)
{
  for (const PolygonMesh& mesh : { Make("zigzag", { { "squares", 5 }, { "amplitude", 0.99 } }),
         Make("koch", { { "squares", 5 }, { "depth", 4 } }) })
  {
    EXPECT_NEAR(SignedArea(ElementOf(mesh, 12)), 0.04, 1e-14);
  }
}

TEST(Tilings, KochsCurveGrowsByAThird)
{
  for (int depth = 0; depth <= 5; ++depth)
  {
    const PolygonMesh mesh = Make("koch", { { "squares", 3 }, { "depth", double(depth) } });
    const double length = std::pow(4.0 / 3.0, depth) / 3.0;
    EXPECT_NEAR(Perimeter(ElementOf(mesh, 4)), 4.0 * length, 1e-12);
    EXPECT_NEAR(MeasureEdges(ElementOf(mesh, 4)).Shortest, std::pow(3.0, -depth) / 3.0, 1e-14);
  }
  const PolygonMesh flat = Make("koch", { { "squares", 3 }, { "depth", 2 }, { "amplitude", 0 } });
  EXPECT_NEAR(Perimeter(ElementOf(flat, 4)), 4.0 / 3.0, 1e-14);
}

TEST(Tilings, TrapezoidsHaveTheirSlant)
{
  const PolygonMesh mesh = Make("trapezoids", { { "squares", 4 }, { "slant", 0.6 } });
  // From the lower side up to the bent line: heights 1.3 and 0.7 sides.
  const std::vector<Point2> first = ElementOf(mesh, 0);
  EXPECT_DOUBLE_EQ(first[3].y, 0.25 * 1.3);
  EXPECT_DOUBLE_EQ(first[2].y, 0.25 * 0.7);
}

TEST(Tilings, WavesAreSymmetric)
{
  const PolygonMesh mesh = Make("wavy-quadrilaterals", { { "squares", 8 }, { "waviness", 0.95 } });
  // The map commutes with the exchange of x and y.
  EXPECT_NEAR(
    SignedArea(ElementOf(mesh, 8 * 2 + 5)), SignedArea(ElementOf(mesh, 8 * 5 + 2)), 1e-15);
  // 1 + w sin(2 pi (x + y)) is its Jacobian.
  const PolygonMesh fine = Make("wavy-quadrilaterals", { { "squares", 64 }, { "waviness", 0.9 } });
  const double sum = (10.5 + 3.5) / 64.0;
  EXPECT_NEAR(SignedArea(ElementOf(fine, 64 * 10 + 3)) * 64.0 * 64.0,
    1.0 + 0.9 * std::sin(2.0 * std::numbers::pi * sum), 0.01);
}

TEST(Tilings, AgglomeratesAreAsManyAsAsked)
{
  EXPECT_EQ(Make("random-agglomerates", { { "cells", 40 } }).NumberOfElements(), 40);
}

} // namespace

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TriangulatePolygon.h"

#include "BruteForce.h"
#include "PolygonSamples.h"
#include "Predicates.h"

#include <gtest/gtest.h>

#include <map>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

/** n - 2 triangles that all turn left, whose exact areas add up, and whose edges match. */
void ExpectTriangulation(const Polygon& polygon, const std::string& name)
{
  const std::vector<PolygonTriangle> triangles = TriangulatePolygon(polygon);
  EXPECT_EQ(triangles.size() + 2, polygon.size()) << name;
  double sum = 0.0;
  std::map<std::pair<int, int>, int> edges;
  for (const PolygonTriangle& triangle : triangles)
  {
    Polygon corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners.push_back(polygon[static_cast<std::size_t>(triangle[i])]);
      ++edges[{ triangle[i], triangle[(i + 1) % 3] }];
    }
    EXPECT_EQ(Orientation(corners[0], corners[1], corners[2]), 1) << name;
    sum += ExactArea(corners);
  }
  const double area = std::abs(ExactArea(polygon));
  EXPECT_NEAR(sum, area, 1e-14 * area) << name;
  int boundary = 0;
  for (const auto& [edge, count] : edges)
  {
    EXPECT_EQ(count, 1) << name;
    boundary += edges.count({ edge.second, edge.first }) == 0 ? 1 : 0;
  }
  EXPECT_EQ(boundary, static_cast<int>(polygon.size())) << name;
}

} // namespace

TEST(TriangulatePolygon, RandomPolygonsInBothOrientations)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    Polygon polygon = RandomPolygon(seed, 3, 60);
    ExpectTriangulation(polygon, "seed " + std::to_string(seed));
    std::reverse(polygon.begin(), polygon.end());
    ExpectTriangulation(polygon, "reversed seed " + std::to_string(seed));
  }
}

TEST(TriangulatePolygon, HardPolygonsAnywhere)
{
  for (const NamedPolygon& hard : HardPolygons())
  {
    for (const double scale : { 1e-9, 1.0, 1e9 })
    {
      ExpectTriangulation(Transformed(hard.Vertices, 0.0, scale, {}), hard.Name);
    }
  }
  // A pentagon with a reflex vertex 1e-9 from an edge, and slivers.
  ExpectTriangulation({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.5, 1e-9 }, { 0, 1 } }, "almost split");
  ExpectTriangulation({ { 0, 0 }, { 1, 0 }, { 1, 1e-7 }, { 0.5, 2e-7 }, { 0, 1e-7 } }, "sliver");
  ExpectTriangulation({ { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 }, { 3, std::nextafter(3.0, 4.0) } },
    "one unit in the last place");
}

TEST(TriangulatePolygon, RepeatedVerticesGiveFewerTriangles)
{
  const Polygon square = { { 0, 0 }, { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
  const std::vector<PolygonTriangle> triangles = TriangulatePolygon(square);
  EXPECT_EQ(triangles.size(), 2U);
  double sum = 0.0;
  for (const PolygonTriangle& t : triangles)
  {
    const Polygon corners = { square[static_cast<std::size_t>(t[0])],
      square[static_cast<std::size_t>(t[1])], square[static_cast<std::size_t>(t[2])] };
    sum += ExactArea(corners);
  }
  EXPECT_EQ(sum, 1.0);
}

TEST(TriangulatePolygon, NothingToFill)
{
  EXPECT_TRUE(TriangulatePolygon(Polygon{}).empty());
  EXPECT_TRUE(TriangulatePolygon(Polygon{ { 0, 0 }, { 1, 0 } }).empty());
  EXPECT_TRUE(TriangulatePolygon(Polygon{ { 0, 0 }, { 1, 1 }, { 3, 3 }, { 2, 2 } }).empty());
}

TEST(TriangulatePolygon, PolygonsThatTouchOrCrossThemselvesEnd)
{
  // Two squares that share a corner: the area is right all the same.
  const Polygon touching = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 },
    { 0, 1 } };
  double sum = 0.0;
  for (const PolygonTriangle& t : TriangulatePolygon(touching))
  {
    const Polygon corners = { touching[static_cast<std::size_t>(t[0])],
      touching[static_cast<std::size_t>(t[1])], touching[static_cast<std::size_t>(t[2])] };
    sum += ExactArea(corners);
  }
  EXPECT_EQ(sum, 2.0);
  EXPECT_LE(TriangulatePolygon(Polygon{ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }).size(), 2U);
}

TEST(TriangulatePolygon, ManyVertices)
{
  Polygon gear = RegularPolygon(2000);
  for (std::size_t i = 0; i < gear.size(); i += 2)
  {
    gear[i] = { 1.1 * gear[i].x, 1.1 * gear[i].y };
  }
  ExpectTriangulation(gear, "gear");
}

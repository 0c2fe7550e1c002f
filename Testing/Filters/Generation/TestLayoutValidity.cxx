// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutValidity.h"

#include "MeshInvariants.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace
{

using pemesh::Domain;
using pemesh::FindLayoutFault;
using pemesh::Point2;

PolygonVertices Square(double x, double y, double side)
{
  return { { x, y }, { x + side, y }, { x + side, y + side }, { x, y + side } };
}

/** A U, open upwards, with a square hole in its left arm and one in its right arm. */
Domain UShape()
{
  return { { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 3.0 }, { 2.0, 3.0 }, { 2.0, 1.0 }, { 1.0, 1.0 },
             { 1.0, 3.0 }, { 0.0, 3.0 } },
    { Square(0.25, 1.0, 0.5), Square(2.25, 1.0, 0.5) } };
}

std::string FaultOf(const PolygonVertices& polygon, double t = std::nan(""))
{
  return FindLayoutFault({ { "The star", polygon } }, UShape(), t);
}

TEST(LayoutValidity, NamesWhatIsInTheWay)
{
  EXPECT_EQ(FaultOf(Square(1.2, 0.2, 0.5)), "");
  EXPECT_EQ(FaultOf(Square(1.25, 1.5, 0.5)),
    "The star leaves the domain; move it inwards or make it smaller.")
    << "in the bounding box, between the arms";
  EXPECT_EQ(FaultOf(Square(0.5, 2.0, 2.0)),
    "The star leaves the domain; move it inwards or make it smaller.")
    << "its vertices are in both arms";
  EXPECT_EQ(FaultOf(Square(-5.0, -5.0, 20.0)),
    "The star leaves the domain; move it inwards or make it smaller.");
  EXPECT_EQ(FaultOf(Square(0.75, 2.0, 0.25)),
    "The star touches the border of the domain; move it inwards or make it smaller.");
  EXPECT_EQ(FaultOf({ { 0.8, 0.8 }, { 1.0, 1.0 }, { 0.7, 0.9 } }, 0.5),
    "The star touches the border of the domain at t = 0.5; move it inwards or make it smaller.")
    << "at a reflex vertex";
  EXPECT_EQ(FaultOf(Square(2.375, 1.125, 0.25)),
    "The star lies in hole 2 of the domain; move it away or make it smaller.");
  EXPECT_EQ(FaultOf(Square(0.125, 0.875, 0.75)),
    "hole 1 of the domain lies in The star; move it away or make it smaller.");
  EXPECT_EQ(FaultOf(Square(0.125, 0.875, 0.25), 0.25),
    "The star meets hole 1 of the domain at t = 0.25; move it away or make it smaller.");
  EXPECT_EQ(FaultOf(Square(0.25, 0.5, 0.5)),
    "The star touches hole 1 of the domain; move it away or make it smaller.");
  EXPECT_EQ(FindLayoutFault({ { "The star", Square(0.9, 0.4, 0.2) } }, pemesh::UnitSquare(), 1.0),
    "The star leaves the unit square at t = 1; move it inwards or make it smaller.");
}

TEST(LayoutValidity, NamesTheFirstPairInTheOrderOfTheList)
{
  // Swept from west to east, the pair (2, 3) is met before the pair (0, 2).
  const std::string fault =
    FindLayoutFault({ { "a", Square(0.6, 0.6, 0.1) }, { "b", Square(0.9, 0.1, 0.05) },
                      { "c", { { 0.1, 0.6 }, { 0.65, 0.6 }, { 0.65, 0.8 }, { 0.1, 0.8 } } },
                      { "d", Square(0.05, 0.7, 0.1) } },
      pemesh::UnitSquare(), 0.0);
  EXPECT_EQ(fault, "a and c overlap at t = 0; move them apart or make them smaller.");
}

/** Brute force in exact arithmetic: whether any two edges of two loops have a point in common. */
bool DoLoopsMeet(const PolygonVertices& a, const PolygonVertices& b)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto edge = [](const PolygonVertices& loop, std::size_t i) -> Kernel::Segment_2
  {
    const Point2& to = loop[(i + 1) % loop.size()];
    return { { loop[i].x, loop[i].y }, { to.x, to.y } };
  };
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      if (CGAL::do_intersect(edge(a, i), edge(b, j)))
      {
        return true;
      }
    }
  }
  return false;
}

bool IsInside(const Point2& point, const PolygonVertices& loop)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  CGAL::Polygon_2<Kernel> polygon;
  for (const Point2& vertex : loop)
  {
    polygon.push_back({ vertex.x, vertex.y });
  }
  return polygon.bounded_side({ point.x, point.y }) == CGAL::ON_BOUNDED_SIDE;
}

TEST(LayoutValidity, AgreesWithBruteForce)
{
  const Domain domain = UShape();
  std::vector<PolygonVertices> loops = domain.Holes;
  loops.push_back(domain.Outer);
  std::mt19937_64 bits(7);
  const auto eighth = [&bits] { return static_cast<double>(bits() % 33) * 0.125 - 0.5; };
  int valid = 0;
  for (int trial = 0; trial < 4000; ++trial)
  {
    const double x = eighth();
    const double y = eighth();
    const double side = 0.0625 * static_cast<double>(1 + bits() % 8);
    const PolygonVertices polygon = { { x, y }, { x + side, y }, { x + 0.5 * side, y + side } };
    bool expected = IsInside(polygon[0], domain.Outer);
    for (const PolygonVertices& loop : loops)
    {
      expected = expected && !DoLoopsMeet(polygon, loop);
    }
    for (const PolygonVertices& hole : domain.Holes)
    {
      expected = expected && !IsInside(polygon[0], hole) && !IsInside(hole[0], polygon);
    }
    EXPECT_EQ(FaultOf(polygon).empty(), expected) << x << " " << y << " " << side;
    valid += expected;
  }
  EXPECT_GT(valid, 300);
}

TEST(LayoutValidity, ManyPolygonsAreQuick)
{
  std::vector<pemesh::PlacedPolygon> polygons;
  for (int i = 0; i < 20000; ++i)
  {
    polygons.push_back(
      { "p", Square(0.0005 + 0.007 * (i % 141), 0.0005 + 0.007 * (i / 141), 0.005) });
  }
  EXPECT_EQ(FindLayoutFault(polygons, pemesh::UnitSquare(), 0.0), "");
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonValidity.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using pemesh::EdgePair;
using pemesh::Point2;
using pemesh::PolygonRelation;
using pemesh::RectangleRelation;
using Polygon = std::vector<Point2>;

const Polygon Square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };

Polygon Shifted(Polygon polygon, double x, double y)
{
  for (Point2& point : polygon)
  {
    point = { point.x + x, point.y + y };
  }
  return polygon;
}

PolygonRelation Mirrored(PolygonRelation relation)
{
  return relation == PolygonRelation::FirstInsideSecond ? PolygonRelation::SecondInsideFirst
    : relation == PolygonRelation::SecondInsideFirst    ? PolygonRelation::FirstInsideSecond
                                                        : relation;
}

/** Asks in both orders and with both orientations of each. */
PolygonRelation Relate(const Polygon& a, const Polygon& b)
{
  const PolygonRelation relation = pemesh::RelatePolygons(a, b);
  const Polygon reversedA(a.rbegin(), a.rend());
  const Polygon reversedB(b.rbegin(), b.rend());
  EXPECT_EQ(pemesh::RelatePolygons(b, a), Mirrored(relation));
  EXPECT_EQ(pemesh::RelatePolygons(reversedA, b), relation);
  EXPECT_EQ(pemesh::RelatePolygons(a, reversedB), relation);
  return relation;
}

// --- An independent brute force in rational numbers -------------------------------------------

using Rational = CGAL::Exact_rational;

int Turn(const Point2& a, const Point2& b, const Point2& c)
{
  const Rational turn = (Rational(b.x) - Rational(a.x)) * (Rational(c.y) - Rational(a.y)) -
    (Rational(b.y) - Rational(a.y)) * (Rational(c.x) - Rational(a.x));
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

bool InBox(const Point2& p, const Point2& a, const Point2& b)
{
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
    p.y <= std::max(a.y, b.y);
}

bool Meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const int abc = Turn(a, b, c), abd = Turn(a, b, d), cda = Turn(c, d, a), cdb = Turn(c, d, b);
  return (abc != abd && cda != cdb) || (abc == 0 && InBox(c, a, b)) ||
    (abd == 0 && InBox(d, a, b)) || (cda == 0 && InBox(a, c, d)) || (cdb == 0 && InBox(b, c, d));
}

std::optional<EdgePair> BruteForceCrossing(const Polygon& polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      const Point2& a = polygon[i];
      const Point2& b = polygon[(i + 1) % n];
      const Point2& c = polygon[j];
      const Point2& d = polygon[(j + 1) % n];
      const bool follows = j == i + 1;
      const bool closes = (j + 1) % n == i;
      bool wrong = false;
      if (!follows && !closes)
      {
        wrong = Meet(a, b, c, d);
      }
      if (follows) // they may share b only
      {
        wrong =
          wrong || a == b || c == d || (Turn(a, b, d) == 0 && (InBox(a, c, d) || InBox(d, a, b)));
      }
      if (closes) // they may share a only
      {
        wrong =
          wrong || a == b || c == d || (Turn(c, d, b) == 0 && (InBox(c, a, b) || InBox(b, c, d)));
      }
      if (wrong)
      {
        return EdgePair{ i, j };
      }
    }
  }
  return std::nullopt;
}

TEST(PolygonValidity, SimplePolygonsAreSimple)
{
  EXPECT_TRUE(pemesh::IsSimple(Square));
  EXPECT_TRUE(pemesh::IsSimple(Polygon{ { 0, 0 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_TRUE(pemesh::IsSimple(Polygon{ { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }))
    << "straight vertices are allowed";
  EXPECT_EQ(pemesh::WhyNotSimple(Square), "");
}

TEST(PolygonValidity, NamesTheFirstEdgesThatMeet)
{
  const Polygon bowTie = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
  ASSERT_TRUE(pemesh::FindSelfCrossing(bowTie));
  EXPECT_EQ(*pemesh::FindSelfCrossing(bowTie), (EdgePair{ 0, 2 }));
  EXPECT_EQ(pemesh::WhyNotSimple(bowTie), "crosses or touches itself: edges 0 and 2 meet");
}

TEST(PolygonValidity, TouchingIsFoundToTheLastBit)
{
  // Vertex 3 comes down to the lower edge: simple while it is one unit in the last place above.
  const double above = std::numeric_limits<double>::denorm_min();
  const auto dented = [](double y) {
    return Polygon{ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, y }, { 0, 1 } };
  };
  EXPECT_TRUE(pemesh::IsSimple(dented(above)));
  EXPECT_EQ(*pemesh::FindSelfCrossing(dented(0.0)), (EdgePair{ 0, 2 }));
  EXPECT_EQ(*pemesh::FindSelfCrossing(dented(-above)), (EdgePair{ 0, 2 }));
}

TEST(PolygonValidity, DegeneratePolygonsAreNotSimple)
{
  EXPECT_EQ(pemesh::WhyNotSimple(Polygon{ { 0, 0 }, { 1, 0 } }), "has fewer than three vertices");
  EXPECT_EQ(pemesh::WhyNotSimple(Polygon{ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0, 1 } }),
    "has vertices 1 and 2 at the same place");
  EXPECT_EQ(pemesh::WhyNotSimple(Polygon{ { 0, 0 }, { 1, 0 }, { NAN, 1 } }),
    "has a coordinate that is not a finite number");
  EXPECT_EQ(pemesh::WhyNotSimple(Polygon{ { 0, 0 }, { INFINITY, 0 }, { 0, 1 } }),
    "has a coordinate that is not a finite number");
  const Polygon flat = { { 0, 0 }, { 1, 1 }, { 2, 2 } };
  EXPECT_FALSE(pemesh::IsSimple(flat));
  const Polygon spike = { { 0, 0 }, { 1, 0 }, { 3, 0 }, { 2, 0 }, { 1, 1 } };
  EXPECT_EQ(*pemesh::FindSelfCrossing(spike), (EdgePair{ 1, 2 }));
}

TEST(PolygonValidity, AgreesWithRationalBruteForceOnAGrid)
{
  // Points of a small grid: touching, collinear and repeated vertices all are frequent.
  std::mt19937_64 bits(20260101);
  int simple = 0;
  for (int trial = 0; trial < 4000; ++trial)
  {
    Polygon polygon(3 + bits() % 5);
    for (Point2& point : polygon)
    {
      point = { static_cast<double>(bits() % 5), static_cast<double>(bits() % 5) };
    }
    const auto expected = BruteForceCrossing(polygon);
    ASSERT_EQ(pemesh::FindSelfCrossing(polygon), expected) << "trial " << trial;
    simple += !expected;
  }
  EXPECT_GT(simple, 300);
}

TEST(PolygonValidity, AgreesWithRationalBruteForceNearAnAwkwardLine)
{
  // Points within a few units in the last place of one line: only exact arithmetic can tell.
  std::mt19937_64 bits(7);
  for (int trial = 0; trial < 500; ++trial)
  {
    Polygon polygon(4);
    for (Point2& point : polygon)
    {
      const double x = 0.5 + static_cast<double>(bits() % 64) * 0x1p-53;
      point = { x, x * 3.0 + static_cast<double>(bits() % 3) * 0x1p-51 };
    }
    ASSERT_EQ(pemesh::FindSelfCrossing(polygon), BruteForceCrossing(polygon)) << "trial " << trial;
  }
}

TEST(PolygonValidity, RelationsOfTwoPolygons)
{
  EXPECT_EQ(Relate(Square, Shifted(Square, 1.5, 0)), PolygonRelation::Apart);
  EXPECT_EQ(Relate(Square, Shifted(Square, 1, 0)), PolygonRelation::Touching) << "a whole edge";
  EXPECT_EQ(Relate(Square, Shifted(Square, 1, 0.5)), PolygonRelation::Touching) << "half an edge";
  EXPECT_EQ(Relate(Square, Shifted(Square, 1, 1)), PolygonRelation::Touching) << "one vertex";
  EXPECT_EQ(Relate(Square, Shifted(Square, 1 - 0x1p-53, 0)), PolygonRelation::Overlapping);
  EXPECT_EQ(Relate(Square, Shifted(Square, 1 + 0x1p-52, 0)), PolygonRelation::Apart);
  EXPECT_EQ(Relate(Square, Shifted(Square, 0.5, 0.5)), PolygonRelation::Overlapping);
  EXPECT_EQ(Relate(Square, Shifted(Square, 0.5, 0)), PolygonRelation::Overlapping)
    << "edges on one line, no proper crossing of any two";
  const Polygon small = { { 0.25, 0.25 }, { 0.75, 0.25 }, { 0.75, 0.75 }, { 0.25, 0.75 } };
  EXPECT_EQ(Relate(small, Square), PolygonRelation::FirstInsideSecond);
  EXPECT_EQ(Relate(Shifted(small, 0.25, 0), Square), PolygonRelation::FirstInsideSecond)
    << "inside, touching from within";
  EXPECT_EQ(Relate(Square, Square), PolygonRelation::Equal);
  const Polygon rotated = { { 1, 1 }, { 0.5, 1 }, { 0, 1 }, { 0, 0 }, { 1, 0 } };
  EXPECT_EQ(Relate(Square, rotated), PolygonRelation::Equal) << "same region, other vertices";
}

TEST(PolygonValidity, ConcavePolygonsThatInterlock)
{
  const Polygon u = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 },
    { 0, 3 } };
  const Polygon plug = { { 1.25, 1.5 }, { 1.75, 1.5 }, { 1.75, 4 }, { 1.25, 4 } };
  EXPECT_EQ(Relate(u, plug), PolygonRelation::Apart) << "in the notch, not in the polygon";
  EXPECT_EQ(Relate(u, Shifted(plug, 0, -0.5)), PolygonRelation::Touching);
  EXPECT_EQ(Relate(u, Shifted(plug, 0, -0.75)), PolygonRelation::Overlapping);
  // Vertices of one on vertices of the other only, yet the interiors cross.
  const Polygon diamond = { { 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 } };
  const Polygon wide = { { 0, 1 }, { 1, 0.5 }, { 2, 1 }, { 1, 1.5 } };
  EXPECT_EQ(Relate(wide, diamond), PolygonRelation::FirstInsideSecond);
  const Polygon kite = { { 0, 1 }, { 1, -1 }, { 2, 1 }, { 1, 1.5 } };
  EXPECT_EQ(Relate(kite, diamond), PolygonRelation::Overlapping);
}

TEST(PolygonValidity, PositionInARectangle)
{
  const Polygon inside = { { 0.1, 0.1 }, { 0.9, 0.1 }, { 0.5, 0.9 } };
  EXPECT_EQ(pemesh::RelateToRectangle(inside), RectangleRelation::Inside);
  EXPECT_EQ(pemesh::RelateToRectangle(Square), RectangleRelation::Touching);
  const Polygon touching = { { 0.1, 0.0 }, { 0.9, 0.1 }, { 0.5, 0.9 } };
  EXPECT_EQ(pemesh::RelateToRectangle(touching), RectangleRelation::Touching);
  const Polygon barelyInside = { { 0.1, 0x1p-60 }, { 1.0 - 0x1p-53, 0.1 }, { 0.5, 0.9 } };
  EXPECT_EQ(pemesh::RelateToRectangle(barelyInside), RectangleRelation::Inside);
  EXPECT_EQ(pemesh::RelateToRectangle(Shifted(inside, 0.2, 0)), RectangleRelation::Outside);
  EXPECT_EQ(pemesh::RelateToRectangle(Square, { -1, -1 }, { 2, 2 }), RectangleRelation::Inside);
  EXPECT_EQ(pemesh::RelateToRectangle(Polygon{ { NAN, 0.5 } }), RectangleRelation::Outside);
}

TEST(PolygonValidity, TenThousandVerticesAreQuick)
{
  Polygon comb;
  for (int i = 0; i <= 10000; ++i)
  {
    comb.push_back({ i * 1e-4, i % 2 == 0 ? 0.0 : 0.5 });
  }
  comb.push_back({ 1, 1 });
  comb.push_back({ 0, 1 });
  EXPECT_TRUE(pemesh::IsSimple(comb));
  EXPECT_EQ(pemesh::RelatePolygons(comb, Shifted(comb, 0, 1.25)), PolygonRelation::Apart);
  comb[5001].y = 1.0; // its spike reaches the upper edge
  EXPECT_FALSE(pemesh::IsSimple(comb));
}

} // namespace

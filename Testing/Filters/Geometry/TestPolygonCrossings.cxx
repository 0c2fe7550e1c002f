// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonCrossings.h"

#include "PolygonSamples.h"
#include "PolygonValidity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

double CrossOf(const Point2& a, const Point2& b, const Point2& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int WindingNumber(PolygonView polygon, const Point2& point)
{
  int number = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    number += a.y <= point.y && b.y > point.y && CrossOf(a, b, point) > 0.0 ? 1 : 0;
    number -= b.y <= point.y && a.y > point.y && CrossOf(a, b, point) < 0.0 ? 1 : 0;
  }
  return number;
}

/** Where edge i is met by others, as parameters along it; `runsAlong` if one shares a piece. */
std::vector<double> CutsOf(PolygonView polygon, std::size_t i, bool& runsAlong)
{
  const std::size_t size = polygon.size();
  const Point2& a = polygon[i];
  const Point2& b = polygon[(i + 1) % size];
  const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  std::vector<double> cuts = { 0.0, 1.0 };
  for (std::size_t j = 0; j < size; ++j)
  {
    const Point2& c = polygon[j];
    const Point2& d = polygon[(j + 1) % size];
    const auto Along = [&](const Point2& p)
    { return ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length; };
    const double ofC = CrossOf(a, b, c);
    const double ofD = CrossOf(a, b, d);
    if (ofC == 0.0 && ofD == 0.0)
    {
      runsAlong = runsAlong ||
        (j != i &&
          std::max(0.0, std::min(Along(c), Along(d))) <
            std::min(1.0, std::max(Along(c), Along(d))));
    }
    else if (ofC * ofD <= 0.0)
    {
      const double t = ofC / (ofC - ofD);
      cuts.push_back(Along({ c.x + t * (d.x - c.x), c.y + t * (d.y - c.y) }));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/**
 * A closed curve that never runs along itself does not cross itself if and only if it winds around
 * no point but those of one region, and around them once: at a crossing three numbers meet.
 * Coordinates are small whole numbers here, so that this needs no care.
 */
bool CrossesByWinding(PolygonView polygon)
{
  std::set<int> numbers;
  bool runsAlong = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    const std::vector<double> cuts = CutsOf(polygon, i, runsAlong);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
    {
      if (cuts[k] < 0.0 || cuts[k + 1] > 1.0 || cuts[k + 1] - cuts[k] < 1e-9)
      {
        continue;
      }
      const double t = 0.5 * (cuts[k] + cuts[k + 1]);
      for (const double side : { -1e-7, 1e-7 })
      {
        numbers.insert(WindingNumber(polygon,
          { a.x + t * (b.x - a.x) - side * (b.y - a.y),
            a.y + t * (b.y - a.y) + side * (b.x - a.x) }));
      }
    }
  }
  return runsAlong || (numbers != std::set{ 0, 1 } && numbers != std::set{ -1, 0 });
}

/** How often the boundary passes through one point, at most. */
int MostPassages(PolygonView polygon)
{
  int most = 0;
  const std::size_t size = polygon.size();
  bool runsAlong = false;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % size];
    for (const double t : CutsOf(polygon, i, runsAlong))
    {
      const Point2 point = { a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) };
      int passages = 0;
      for (std::size_t j = 0; j < size; ++j)
      {
        const Point2& c = polygon[j];
        const Point2& d = polygon[(j + 1) % size];
        const double length = std::hypot(d.x - c.x, d.y - c.y);
        const double along =
          ((point.x - c.x) * (d.x - c.x) + (point.y - c.y) * (d.y - c.y)) / length;
        const bool isOn = std::abs(CrossOf(c, d, point)) < 1e-9 * length;
        passages += isOn && along > -1e-9 && along < length - 1e-9 ? 1 : 0; // the end is the next's
      }
      most = std::max(most, passages);
    }
  }
  return most;
}

} // namespace

TEST(PolygonCrossings, BetweenVertices)
{
  EXPECT_TRUE(HasCrossingEdges(Polygon{ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }));
  EXPECT_FALSE(HasCrossingEdges(Polygon{ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0 }, { 0, 2 } }));
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    Polygon polygon = Untangled(*std::make_unique<Random>(seed), 20 + static_cast<int>(seed));
    EXPECT_FALSE(HasCrossingEdges(polygon)) << seed;
    // The diagonals of the quadrilateral of two edges far apart cross or the edges do.
    std::swap(polygon[0], polygon[polygon.size() / 2]);
    bool crosses = false;
    for (std::size_t i = 0; i < polygon.size() && !crosses; ++i)
    {
      for (std::size_t j = i + 2; j < polygon.size() && !crosses; ++j)
      {
        const auto Side = [](const Point2& a, const Point2& b, const Point2& c)
        { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0; };
        const Point2& a = polygon[i];
        const Point2& b = polygon[i + 1];
        const Point2& c = polygon[j];
        const Point2& d = polygon[(j + 1) % polygon.size()];
        crosses = !(a == d) && Side(a, b, c) != Side(a, b, d) && Side(c, d, a) != Side(c, d, b);
      }
    }
    EXPECT_EQ(HasCrossingEdges(polygon), crosses) << seed;
  }
}

TEST(PolygonCrossings, InAVertex)
{
  // Two triangles that share a corner: passed through, and turned back at.
  EXPECT_TRUE(
    HasCrossingEdges(Polygon{ { 0, 0 }, { 1, 1 }, { 3, 3 }, { 3, -1 }, { 1, 1 }, { 0, 2 } }));
  EXPECT_TRUE(
    HasCrossingEdges(Polygon{ { 0, 0 }, { 1, 1 }, { 2, 2 }, { 2, 0 }, { 1, 1 }, { 0, 2 } }));
  EXPECT_FALSE(
    HasCrossingEdges(Polygon{ { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 1, 1 }, { 0, 2 } }));
}

TEST(PolygonCrossings, AlongItself)
{
  EXPECT_TRUE(HasCrossingEdges(
    Polygon{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.5, 1 }, { 0.5, 0.5 }, { 0.5, 1 }, { 0, 1 } }))
    << "a slit";
  EXPECT_TRUE(HasCrossingEdges(Polygon{ { 0, 0 }, { 2, 0 }, { 1, 0 }, { 1, 1 } })) << "a spike";
  EXPECT_TRUE(
    HasCrossingEdges(Polygon{ { 0, 0 }, { 4, 0 }, { 4, 1 }, { 3, 0 }, { 1, 0 }, { 0, 1 } }))
    << "part of an edge";
  EXPECT_FALSE(HasCrossingEdges(
    Polygon{ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 2, 2 }, { 0, 2 } }))
    << "repeats are ignored";
}

TEST(PolygonCrossings, OnAGridAgreeWithWindingNumbers)
{
  Random random(7);
  int crossing = 0;
  int touching = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    const int size = random.Integer(4, 8);
    Polygon polygon;
    while (static_cast<int>(polygon.size()) < size)
    {
      const Point2 point = { static_cast<double>(random.Integer(0, 3)),
        static_cast<double>(random.Integer(0, 3)) };
      if (polygon.empty() || point != polygon.back())
      {
        polygon.push_back(point);
      }
    }
    if (polygon.front() == polygon.back())
    {
      continue;
    }
    if (MostPassages(polygon) > 2)
    {
      continue; // three that cross in one point may wind around every other sector once
    }
    const bool expected = CrossesByWinding(polygon);
    ASSERT_EQ(HasCrossingEdges(polygon), expected) << trial;
    crossing += expected ? 1 : 0;
    touching += !expected && !IsSimple(polygon) ? 1 : 0;
  }
  EXPECT_GT(crossing, 1000);
  EXPECT_LT(crossing, 19000);
  EXPECT_GT(touching, 50);
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonFamilies.h"

#include "MeshInvariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace
{

using pemesh::Point2;
using Polygon = std::vector<Point2>;

Polygon Vertices(const char* family, double t)
{
  const pemesh::PolygonFamily* found = pemesh::FindPolygonFamily(family);
  return found->Vertices(t, pemesh::ParameterValues(found->Parameters));
}

Polygon VerticesAtEnd(const char* family, const char* parameter, double value)
{
  const pemesh::PolygonFamily* found = pemesh::FindPolygonFamily(family);
  pemesh::ParameterValues values(found->Parameters);
  EXPECT_EQ(values.Set(parameter, value), "");
  return found->Vertices(1.0, values);
}

void ExpectPolygon(const Polygon& actual, const Polygon& expected)
{
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(actual[i].x, expected[i].x, 1e-15) << "vertex " << i;
    EXPECT_NEAR(actual[i].y, expected[i].y, 1e-15) << "vertex " << i;
  }
}

TEST(PolygonFamilies, PositionsInTheTableAreForever)
{
  const std::vector<std::string> expected = { "comb", "convexity", "isotropy", "maze", "n-sided",
    "star", "u-like", "zeta", "random", "file", "points" };
  std::vector<std::string> names;
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    EXPECT_EQ(pemesh::PolygonFamilyIndex(&family), static_cast<int>(names.size()));
    EXPECT_EQ(pemesh::FindPolygonFamily(family.Name), &family);
    EXPECT_EQ(family.IsFixed(), names.size() >= 9);
    const bool counts = family.Parameters.size() == 1;
    EXPECT_EQ(family.Stepped, counts);
    EXPECT_TRUE(!counts || family.Parameters[0].IsInteger);
    EXPECT_FALSE(std::string(family.Label).empty());
    EXPECT_FALSE(std::string(family.Description).empty());
    const bool isAttene =
      std::string(family.Reference).find("10.1016/j.matcom.2021.07.018") != std::string::npos;
    EXPECT_EQ(isAttene, names.size() < 8);
    names.emplace_back(family.Name);
  }
  EXPECT_EQ(names, expected);
  EXPECT_EQ(pemesh::FindPolygonFamily("N-Sided"), pemesh::FindPolygonFamily("n-sided"));
  EXPECT_EQ(pemesh::FindPolygonFamily("spiral"), nullptr);
  EXPECT_EQ(pemesh::FindPolygonFamily(""), nullptr);
}

TEST(PolygonFamilies, Comb)
{
  ExpectPolygon(Vertices("comb", 0.0), { { 0, 0 }, { 1, 0.5 }, { 2, 0 }, { 2, 1 }, { 0, 1 } });
  // round(10 * 0.1) = 1 extra tooth: five abscissae.
  ExpectPolygon(Vertices("comb", 0.1),
    { { 0, 0 }, { 0.5, 0.5 }, { 1, 0 }, { 1.5, 0.5 }, { 2, 0 }, { 2, 1 }, { 0, 1 } });
  EXPECT_EQ(Vertices("comb", 0.049).size(), 5u);
  EXPECT_EQ(Vertices("comb", 0.05).size(), 7u) << "halves are rounded away from zero";
  for (const double t : { 0.0, 0.3, 0.77, 1.0 })
  {
    EXPECT_NEAR(SignedArea(Vertices("comb", t)), 1.5, 1e-12) << "the notches always add up to 1/2";
  }
}

TEST(PolygonFamilies, Convexity)
{
  ExpectPolygon(Vertices("convexity", 0.7), { { 0.7, 0.7 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  for (const double t : { 0.0, 0.25, 0.5, 0.9 })
  {
    EXPECT_NEAR(SignedArea(Vertices("convexity", t)), 1.0 - t, 1e-15);
  }
  EXPECT_NEAR(SignedArea(Vertices("convexity", 1.0)), 1e-5, 1e-15) << "kept from collapsing";
}

TEST(PolygonFamilies, Isotropy)
{
  ExpectPolygon(Vertices("isotropy", 0.5), { { 0, 0.25 }, { 1, 0.25 }, { 1, 0.75 }, { 0, 0.75 } });
  EXPECT_NEAR(SignedArea(Vertices("isotropy", 0.9)), 0.1, 1e-15);
  EXPECT_NEAR(SignedArea(Vertices("isotropy", 1.0)), 1e-5, 1e-15) << "kept from collapsing";
}

TEST(PolygonFamilies, Maze)
{
  ExpectPolygon(Vertices("maze", 0.0),
    { { 0, 1 }, { 0, .75 }, { 0, .5 }, { 0, .25 }, { 0, 0 }, { .25, 0 }, { .5, 0 }, { .75, 0 },
      { 1, 0 }, { 1, .25 }, { 1, .5 }, { 1, .75 }, { .75, .75 }, { .5, .75 }, { .5, .5 },
      { .75, .5 }, { .75, .25 }, { .5, .25 }, { .25, .25 }, { .25, .5 }, { .25, .75 },
      { .25, 1 } });
  ExpectPolygon(Vertices("maze", 1.0),
    { { 0, 1 }, { 0, .75 }, { 0, .5 }, { 0, .25 }, { 0, 0 }, { .25, 0 }, { .5, 0 }, { .75, 0 },
      { 1, 0 }, { 1, .25 }, { 1, .5 }, { 1, .75 }, { .75, .75 }, { .5, .75 }, { .5, .745 },
      { .995, .745 }, { .995, .005 }, { .5, .005 }, { .005, .005 }, { .005, .5 }, { .005, .75 },
      { .005, 1 } });
  EXPECT_NEAR(SignedArea(Vertices("maze", 0.0)), 0.625, 1e-15);
  EXPECT_NEAR(SignedArea(Vertices("maze", 1.0)), 0.0162, 5e-5);
}

TEST(PolygonFamilies, NSidedAndStar)
{
  const double root3 = std::numbers::sqrt3;
  ExpectPolygon(Vertices("n-sided", 0.0), { { 0, 1 }, { -root3 / 2, -0.5 }, { root3 / 2, -0.5 } });
  ExpectPolygon(Vertices("star", 0.0),
    { { 0, 1.8 }, { -root3 / 2, 0.5 }, { -0.9 * root3, -0.9 }, { 0, -1 }, { 0.9 * root3, -0.9 },
      { root3 / 2, 0.5 } });
  for (const int n : { 3, 7, 40 })
  {
    const double t = (n - 3) / 37.0;
    const Polygon sided = Vertices("n-sided", t);
    const Polygon star = Vertices("star", t);
    ASSERT_EQ(sided.size(), static_cast<std::size_t>(n)) << "steps are not missed by rounding";
    ASSERT_EQ(star.size(), static_cast<std::size_t>(2 * n));
    EXPECT_NEAR(SignedArea(sided), 0.5 * n * std::sin(2.0 * std::numbers::pi / n), 1e-12);
    EXPECT_NEAR(SignedArea(star), 1.8 * n * std::sin(std::numbers::pi / n), 1e-12);
  }
  EXPECT_EQ(Vertices("n-sided", 1e-6).size(), 4u) << "rounded up";
}

TEST(PolygonFamilies, ULike)
{
  ExpectPolygon(Vertices("u-like", 1.0),
    { { 0, 0 }, { .01, .99 }, { .5, .99 }, { .99, .99 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  for (const double t : { 0.1, 0.5, 0.9 })
  {
    // The notch is a trapezium of height 0.99 t with sides 1 and 0.5 + 0.48 t.
    EXPECT_NEAR(SignedArea(Vertices("u-like", t)), 1.0 - 0.99 * t * (1.5 + 0.48 * t) / 2.0, 1e-14);
  }
  EXPECT_GT(Vertices("u-like", 0.0)[1].y, 0.0) << "kept from a straight line";
  EXPECT_NEAR(Vertices("u-like", 0.0)[1].y, 0.99e-5, 1e-15);
}

TEST(PolygonFamilies, Zeta)
{
  ExpectPolygon(
    Vertices("zeta", 0.0), { { 0, 0 }, { 1, 0 }, { 1, .5 }, { 1, 1 }, { 0, 1 }, { 0, .5 } });
  ExpectPolygon(
    Vertices("zeta", 1.0), { { 0, 0 }, { 1, 0 }, { .02, .01 }, { 1, 1 }, { 0, 1 }, { .98, .99 } });
  EXPECT_NEAR(SignedArea(Vertices("zeta", 0.9)), 1.0 - 0.98 * 0.9, 1e-14);
}

TEST(PolygonFamilies, VertexCountsOfAPublishedFamilyOfMeshes)
{
  // Steps 9 to 19 of 0.9 / 19: the vertex counts in the files of the predecessor's data set.
  const std::vector<std::size_t> comb = { 13, 15, 15, 17, 17, 19, 19, 21, 21, 23, 23 };
  const std::vector<std::size_t> sided = { 19, 21, 23, 25, 26, 28, 30, 32, 33, 35, 37 };
  for (std::size_t i = 0; i < comb.size(); ++i)
  {
    const double t = static_cast<double>(i + 9) * 0.9 / 19.0;
    EXPECT_EQ(Vertices("comb", t).size(), comb[i]);
    EXPECT_EQ(Vertices("n-sided", t).size(), sided[i]);
    EXPECT_EQ(Vertices("star", t).size(), 2 * sided[i]);
  }
}

TEST(PolygonFamilies, SimpleAndCounterClockwiseForEveryTime)
{
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    for (int i = family.IsFixed() ? 103 : -1; i <= 102; ++i) // a little beyond both ends, too
    {
      const Polygon polygon = Vertices(family.Name, i / 100.0);
      EXPECT_TRUE(IsSimpleAndCounterClockwise(polygon)) << family.Name << " at " << i / 100.0;
    }
    EXPECT_TRUE(family.IsFixed() || IsSimpleAndCounterClockwise(Vertices(family.Name, NAN)));
  }
}

TEST(PolygonFamilies, ParametersAreTakenWithinBounds)
{
  EXPECT_EQ(VerticesAtEnd("comb", "teeth", 3).size(), 11u);
  EXPECT_EQ(VerticesAtEnd("n-sided", "sides", 12).size(), 12u);
  EXPECT_EQ(VerticesAtEnd("star", "spikes", 3).size(), 6u);
  EXPECT_EQ(VerticesAtEnd("star", "spikes", 100000).size(), 200000u);
  EXPECT_EQ(VerticesAtEnd("random", "vertices", 9).size(), 9u);
  EXPECT_NE(VerticesAtEnd("random", "seed", 9), Vertices("random", 1.0));
  pemesh::ParameterValues values(pemesh::FindPolygonFamily("n-sided")->Parameters);
  EXPECT_EQ(values.Set("sides", 2), "sides is 2; it must be an integer between 3 and 100000.");
}

} // namespace

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StraightVertices.h"

#include "AgglomerationChecks.h"
#include "AgglomerationInput.h"
#include "PolygonMeasures.h"
#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;

/** Elements a, below, and b, above a slanted chain from (0, 0.1) to (3, 0.7) of n inner vertices.
 */
PolygonMesh TwoElements(const std::vector<Point2>& chain)
{
  PolygonMesh mesh;
  mesh.Points = { { 0, -1 }, { 3, -1 }, { 3, 2 }, { 0, 2 } };
  std::vector<int> below = { 0, 1 };
  std::vector<int> above = { 2, 3 };
  for (const Point2& point : chain)
  {
    mesh.Points.push_back(point);
  }
  const int last = static_cast<int>(mesh.Points.size()) - 1;
  for (int i = last; i >= 4; --i)
  {
    below.push_back(i);
  }
  for (int i = 4; i <= last; ++i)
  {
    above.push_back(i);
  }
  mesh.AddElement(below);
  mesh.AddElement(above);
  return mesh;
}

TEST(StraightVertices, RemovesThoseExactlyOnALine)
{
  PolygonMesh mesh = TwoElements({ { 0, 0 }, { 1, 0.5 }, { 2, 1 }, { 2.5, 1 }, { 3, 1 } });
  const std::string area = ExactArea(mesh);
  EXPECT_EQ(RemoveStraightVertices(mesh, StraightVertices::RemoveExact), 0.0);
  EXPECT_THAT(mesh.Vertices, ElementsAre(0, 1, 8, 6, 4, 2, 3, 4, 6, 8));
  EXPECT_EQ(ExactArea(mesh), area);
}

TEST(StraightVertices, KeepsAllWhenTold)
{
  PolygonMesh mesh = TwoElements({ { 0, 0 }, { 1, 0.5 }, { 3, 1.5 } });
  const std::vector<int> before = mesh.Vertices;
  EXPECT_EQ(RemoveStraightVertices(mesh, StraightVertices::Keep), 0.0);
  EXPECT_EQ(mesh.Vertices, before);
}

TEST(StraightVertices, RemovesThoseThatRoundingMoved)
{
  std::vector<Point2> chain;
  for (int i = 0; i <= 10; ++i)
  {
    chain.push_back({ 3.0 * i / 10.0, 0.1 + 0.6 * i / 10.0 });
  }
  const PolygonMesh before = TwoElements(chain);
  PolygonMesh exact = before;
  RemoveStraightVertices(exact, StraightVertices::RemoveExact);
  EXPECT_GT(exact.Vertices.size(), 8U); // so there is something that only rounding bends
  PolygonMesh mesh = before;
  const double moved = RemoveStraightVertices(mesh, StraightVertices::RemoveRounded);
  EXPECT_THAT(mesh.Vertices, ElementsAre(0, 1, 14, 4, 2, 3, 4, 14));
  EXPECT_GT(moved, 0.0);
  EXPECT_LT(moved, 1e-14);
  for (int element = 0; element < 2; ++element)
  {
    std::vector<Point2> old;
    std::vector<Point2> now;
    before.GetVertices(element, old);
    mesh.GetVertices(element, now);
    EXPECT_NEAR(SignedArea(now), SignedArea(old), moved + 4e-15);
  }
}

TEST(StraightVertices, KeepsCornersThatAreMoreThanRounding)
{
  PolygonMesh mesh = TwoElements({ { 0, 0.1 }, { 1.5, 0.4 + 1e-13 }, { 3, 0.7 } });
  EXPECT_EQ(RemoveStraightVertices(mesh, StraightVertices::RemoveRounded), 0.0);
  EXPECT_EQ(mesh.NumberOfSides(), 10);
}

/** A chain that drifts: every vertex is within rounding of its neighbours, the whole is an arc. */
TEST(StraightVertices, DoesNotFollowAnArc)
{
  std::vector<Point2> chain;
  for (int i = 0; i <= 200; ++i)
  {
    const double x = 3.0 * i / 200.0;
    chain.push_back({ x, 0.5 + 1e-12 * x * (3.0 - x) });
  }
  PolygonMesh mesh = TwoElements(chain);
  const double moved = RemoveStraightVertices(mesh, StraightVertices::RemoveRounded);
  EXPECT_GT(mesh.NumberOfSides(), 20);
  EXPECT_LT(moved, 3.0 * 4.0 * 0x1p-51);
}

/** An element thinner than the tolerance, across which the chain below would jump. */
TEST(StraightVertices, GivesBackWhatWouldCross)
{
  PolygonMesh mesh;
  const double low = std::nextafter(1.0, 0.0);
  mesh.Points = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, low }, { 0, 1 }, { 1, 1 }, { 3, 2 },
    { 0, 2 } };
  mesh.AddElement(std::vector<int>{ 0, 1, 2, 3, 4 });
  mesh.AddElement(std::vector<int>{ 4, 3, 2, 5 });
  mesh.AddElement(std::vector<int>{ 4, 5, 2, 6, 7 });
  ASSERT_EQ(WhyNotAgglomerable(mesh, FindAdjacency(mesh)), "");
  RemoveStraightVertices(mesh, StraightVertices::RemoveRounded);
  EXPECT_EQ(WhyNotAgglomerable(mesh, FindAdjacency(mesh)), "");
  EXPECT_EQ(mesh.NumberOfElements(), 3);
}

TEST(StraightVertices, KeepsMeshesConformingAfterEveryRule)
{
  for (const SampleMesh& sample : SampleMeshes())
  {
    for (const AgglomerationRule& rule : AgglomerationRules())
    {
      AgglomerationOptions options(rule);
      options.Placed = sample.Placed;
      options.Parameters.Set("max-diameter", sample.Placed.empty() ? 3.5 : 0.0);
      const AgglomerationResult kept = Agglomerate(sample.Mesh, options);
      options.StraightVertices = StraightVertices::RemoveExact;
      const AgglomerationResult exact = Agglomerate(sample.Mesh, options);
      options.StraightVertices = StraightVertices::RemoveRounded;
      const AgglomerationResult rounded = Agglomerate(sample.Mesh, options);
      EXPECT_EQ(exact.Group, kept.Group);
      EXPECT_EQ(exact.MovedArea, 0.0);
      EXPECT_EQ(ExactArea(exact.Mesh), ExactArea(kept.Mesh));
      EXPECT_LE(rounded.MovedArea, 1e-13);
      EXPECT_LE(rounded.Mesh.NumberOfSides(), exact.Mesh.NumberOfSides());
      EXPECT_LE(exact.Mesh.NumberOfSides(), kept.Mesh.NumberOfSides());
      for (const AgglomerationResult* result : { &exact, &rounded })
      {
        EXPECT_EQ(WhyNotAgglomerable(result->Mesh, FindAdjacency(result->Mesh)), "")
          << sample.Name << ", " << rule.Name;
        EXPECT_EQ(EulerCharacteristic(result->Mesh), EulerCharacteristic(sample.Mesh));
      }
    }
  }
}

} // namespace

} // namespace pemesh

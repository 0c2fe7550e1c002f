// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementMerger.h"

#include "AgglomerationChecks.h"
#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

ElementMerger MakeMerger(const PolygonMesh& mesh)
{
  return { mesh, FindAdjacency(mesh) };
}

/** 3 x 3 unit squares: element 3 j + i is the square in column i of row j. */
PolygonMesh NineSquares()
{
  PolygonMesh mesh;
  for (int j = 0; j <= 3; ++j)
  {
    for (int i = 0; i <= 3; ++i)
    {
      mesh.Points.push_back({ double(i), double(j) });
    }
  }
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = 4 * j + i;
      mesh.AddElement(std::vector<int>{ a, a + 1, a + 5, a + 4 });
    }
  }
  return mesh;
}

std::vector<int> LoopOf(const ElementMerger& merger, int group)
{
  std::vector<int> loop;
  int side = merger.GetFirstSide(group);
  do
  {
    loop.push_back(merger.GetVertex(side));
    side = merger.GetNextSide(side);
  } while (side != merger.GetFirstSide(group));
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

TEST(ElementMerger, CutsTheCommonSideOut)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  const int group = merger.Merge(0, 1);
  ASSERT_NE(group, ElementMerger::None);
  EXPECT_EQ(merger.Find(0), merger.Find(1));
  EXPECT_EQ(merger.GetNumberOfGroups(), 8);
  EXPECT_EQ(merger.GetNumberOfSides(group), 6);
  EXPECT_THAT(LoopOf(merger, group), ElementsAre(0, 1, 2, 6, 5, 4));
}

TEST(ElementMerger, CutsAChainOfSidesOut)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  const int bend = merger.Merge(merger.Merge(0, 1), merger.Find(3)); // an L around square 4
  EXPECT_EQ(merger.GetNumberOfSides(bend), 8);
  const int square = merger.Merge(bend, 4);
  EXPECT_THAT(LoopOf(merger, square), ElementsAre(0, 1, 2, 6, 10, 9, 8, 4));
}

TEST(ElementMerger, RefusesNeighborsInAPointOnly)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  EXPECT_FALSE(merger.CanMerge(0, 4));
  EXPECT_FALSE(merger.CanMerge(0, 8));
  EXPECT_FALSE(merger.CanMerge(0, 0));
  EXPECT_EQ(merger.Merge(0, 4), ElementMerger::None);
  EXPECT_EQ(merger.GetNumberOfGroups(), 9);
}

TEST(ElementMerger, RefusesAPinch)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  const int bar = merger.Merge(merger.Merge(2, 5), 8); // the right column
  const int hook = merger.Merge(merger.Merge(0, 1), 3);
  // Squares 4 and 6 touch the hook along sides; square 7 touches neither, but with 6 it would.
  EXPECT_TRUE(merger.CanMerge(hook, bar));
  EXPECT_TRUE(merger.CanMerge(hook, 6));
  const int arch = merger.Merge(hook, 6);
  EXPECT_TRUE(merger.CanMerge(arch, 7));
  EXPECT_TRUE(merger.CanMerge(arch, 4));
  // A side in common below, and a corner in common beyond a gap.
  const int stairs = merger.Merge(4, 7);
  EXPECT_TRUE(merger.CanMerge(stairs, arch));
  const int beam = merger.Merge(arch, bar);
  EXPECT_EQ(merger.GetNumberOfGroups(), 2);
  EXPECT_TRUE(merger.CanMerge(beam, stairs)); // fills the U
}

TEST(ElementMerger, RefusesAHole)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  const int lower = merger.Merge(merger.Merge(merger.Merge(3, 0), 1), 2);
  const int upper = merger.Merge(merger.Merge(merger.Merge(5, 8), 7), 6);
  EXPECT_FALSE(merger.CanMerge(lower, upper)); // a ring around square 4
  EXPECT_EQ(merger.Merge(lower, upper), ElementMerger::None);
  EXPECT_TRUE(merger.CanMerge(4, upper));
  EXPECT_TRUE(merger.CanMerge(merger.Merge(4, upper), lower));
}

TEST(ElementMerger, RefusesACornerInCommonOffTheChain)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  // 0-1-4 and 3-6: along side 4-5 (of 0 and 3) and side 5-9 (of 4 and 3) in one chain. 0-1 and
  // 3-6-7-8: in common are the side above 0 and nothing else; with 5 added, the side above 1 is
  // still between 1 and 4, but the corner of 2 and 5 closes a ring around 4.
  const int low = merger.Merge(0, 1);
  const int high = merger.Merge(merger.Merge(merger.Merge(3, 6), 7), 8);
  EXPECT_TRUE(merger.CanMerge(low, high));
  const int ring = merger.Merge(high, 5);
  EXPECT_FALSE(merger.CanMerge(low, ring)); // they meet in the side above 0 and in vertex 6
  EXPECT_TRUE(merger.CanMerge(4, ring));
}

TEST(ElementMerger, FindsEachNeighborOnce)
{
  const PolygonMesh mesh = NineSquares();
  ElementMerger merger = MakeMerger(mesh);
  const int group = merger.Merge(0, 1);
  std::vector<int> neighbors;
  merger.GetNeighbors(group, neighbors);
  EXPECT_THAT(neighbors, UnorderedElementsAre(2, 3, 4));
}

/** Of all pairs of elements of tiny meshes, themselves merged at random before. */
TEST(ElementMerger, AgreesWithExactUnions)
{
  int simple = 0;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    const PolygonMesh fine = seed % 3 == 0 ? TriangleFrame(6, seed)
      : seed % 3 == 1                      ? TriangleGrid(5, 4, seed)
                                           : BrickWall(4, 5, seed);
    AgglomerationOptions options(*FindAgglomerationRule("random"));
    options.Parameters.Set("seed", static_cast<double>(seed));
    options.TargetElements = 10;
    const AgglomerationResult coarse = Agglomerate(fine, options);
    ASSERT_EQ(WhyNotAnAgglomeration(fine, coarse), "");
    for (int a = 0; a < coarse.Mesh.NumberOfElements(); ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        ElementMerger merger = MakeMerger(coarse.Mesh);
        const bool expected = IsUnionSimple(coarse.Mesh, a, b);
        ASSERT_EQ(merger.CanMerge(a, b), expected) << seed << ": " << a << ", " << b;
        std::vector<Point2> vertices;
        ASSERT_EQ(merger.GetUnion(a, b, vertices), expected);
        if (expected)
        {
          std::vector<Point2> merged;
          const int group = merger.Merge(a, b);
          merger.GetVertices(group, merged);
          EXPECT_TRUE(IsSimpleAndCounterClockwise(merged));
          EXPECT_TRUE(
            std::is_permutation(merged.begin(), merged.end(), vertices.begin(), vertices.end()));
          EXPECT_TRUE(IsSimpleAndCounterClockwise(vertices));
        }
        (expected ? simple : others) += 1;
      }
    }
  }
  EXPECT_GT(simple, 100);
  EXPECT_GT(others, 100);
}

} // namespace

} // namespace pemesh

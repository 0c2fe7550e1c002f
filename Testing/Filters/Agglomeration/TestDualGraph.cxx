// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DualGraph.h"

#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;

DualGraph GraphOf(const PolygonMesh& mesh)
{
  ElementMerger merger(mesh, FindAdjacency(mesh));
  return MakeDualGraph(merger, [](int) { return false; });
}

TEST(DualGraph, HasAnEdgeForEachPairOfNeighbors)
{
  const PolygonMesh mesh = TriangleGrid(2, 1, 1);
  const DualGraph graph = GraphOf(mesh);
  EXPECT_THAT(graph.Offsets, ElementsAre(0, 2, 3, 4, 6));
  EXPECT_THAT(graph.Neighbors, ElementsAre(3, 1, 0, 3, 2, 0));
  EXPECT_EQ(CountCutEdges(graph, { 0, 0, 1, 1 }), 1);
  EXPECT_EQ(CountCutEdges(graph, { 0, 1, 0, 1 }), 3);
}

TEST(DualGraph, LeavesElementsOut)
{
  const PolygonMesh mesh = TriangleGrid(2, 1, 1);
  ElementMerger merger(mesh, FindAdjacency(mesh));
  const DualGraph graph = MakeDualGraph(merger, [](int element) { return element == 0; });
  EXPECT_THAT(graph.Elements, ElementsAre(1, 2, 3));
  EXPECT_THAT(graph.Offsets, ElementsAre(0, 0, 1, 2));
}

/** "Edge cut within 10 % of plain METIS." */
TEST(DualGraph, BlocksCutNotMoreEdgesThanPlainMetis)
{
  const DualGraph graph = GraphOf(TriangleGrid(80, 80, 1));
  for (const int parts : { 300, 1280 })
  {
    const long plain = CountCutEdges(graph, PartitionPlainly(graph, parts, 1));
    const long byBlocks = CountCutEdges(graph, PartitionByBlocks(graph, parts, 1));
    EXPECT_LE(byBlocks, 1.1 * plain);
  }
}

/** METIS draws from rand(), which both threads share. */
TEST(DualGraph, GivesTheSameBitsFromAnyThread)
{
  const DualGraph graph = GraphOf(TriangleGrid(40, 40, 1));
  const std::vector<int> expected = PartitionByBlocks(graph, 320, 5);
  std::vector<int> results[2];
  std::thread threads[2];
  for (int i = 0; i < 2; ++i)
  {
    threads[i] = std::thread([&, i] { results[i] = PartitionByBlocks(graph, 320, 5); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(results[0], expected);
  EXPECT_EQ(results[1], expected);
  EXPECT_NE(PartitionByBlocks(graph, 320, 6), expected);
}

} // namespace

} // namespace pemesh

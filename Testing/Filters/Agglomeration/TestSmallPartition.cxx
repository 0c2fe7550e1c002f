// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallPartition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;
using Edges = std::vector<std::pair<int, int>>;

DualGraph MakeGraph(int nodes, const Edges& edges)
{
  DualGraph graph;
  for (int node = 0; node < nodes; ++node)
  {
    for (const auto& [a, b] : edges)
    {
      if (a == node || b == node)
      {
        graph.Neighbors.push_back(a == node ? b : a);
      }
    }
    graph.Offsets.push_back(static_cast<int>(graph.Neighbors.size()));
  }
  return graph;
}

/** Nodes of a lattice, each with those to its left and right, below and above. */
DualGraph Lattice(int columns, int rows)
{
  Edges edges;
  for (int i = 0; i < columns * rows; ++i)
  {
    if (i % columns + 1 < columns)
    {
      edges.emplace_back(i, i + 1);
    }
    if (i + columns < columns * rows)
    {
      edges.emplace_back(i, i + columns);
    }
  }
  return MakeGraph(columns * rows, edges);
}

/** A tree that is bushy or thin, and some more edges. */
DualGraph RandomGraph(int nodes, std::mt19937_64& engine)
{
  Edges edges;
  for (int node = 1; node < nodes; ++node)
  {
    const int least = std::max(0, node - 4);
    const int other = least + static_cast<int>(engine() % static_cast<std::uint64_t>(node - least));
    edges.emplace_back(other, node);
    const int another = static_cast<int>(engine() % static_cast<std::uint64_t>(node));
    if (another != other && engine() % 2 == 0)
    {
      edges.emplace_back(another, node);
    }
  }
  return MakeGraph(nodes, edges);
}

std::vector<long> WeightsOf(const DualGraph& graph, const std::vector<int>& part, int parts)
{
  std::vector<long> weights(static_cast<std::size_t>(parts), 0);
  for (std::size_t node = 0; node < part.size(); ++node)
  {
    weights.at(static_cast<std::size_t>(part[node])) +=
      graph.Weights.empty() ? 1 : graph.Weights[node];
  }
  return weights;
}

/** The least cut of all bisections whose sides differ from the half by at most one node. */
long LeastCut(const DualGraph& graph)
{
  const int nodes = graph.NumberOfNodes();
  long least = std::numeric_limits<long>::max();
  std::vector<int> part(static_cast<std::size_t>(nodes));
  for (unsigned int set = 0; set < 1U << nodes; ++set)
  {
    if (std::abs(2 * std::popcount(set) - nodes) <= 2)
    {
      for (int node = 0; node < nodes; ++node)
      {
        part[node] = static_cast<int>(set >> node & 1U);
      }
      least = std::min(least, CountCutEdges(graph, part));
    }
  }
  return least;
}

TEST(SmallPartition, CutsAPathInPieces)
{
  EXPECT_THAT(PartitionSmallGraph(Lattice(6, 1), 1), ElementsAre(0, 0, 0, 0, 0, 0));
  const std::vector<int> part = PartitionSmallGraph(Lattice(6, 1), 3);
  EXPECT_EQ(CountCutEdges(Lattice(6, 1), part), 2);
  EXPECT_THAT(WeightsOf(Lattice(6, 1), part, 3), ElementsAre(2, 2, 2));
}

TEST(SmallPartition, CutsALatticeOfAllNodesStraight)
{
  static_assert(SmallGraphNodes == 64);
  const DualGraph graph = Lattice(16, 4);
  const std::vector<int> part = PartitionSmallGraph(graph, 4);
  EXPECT_EQ(CountCutEdges(graph, part), 12);
  EXPECT_THAT(WeightsOf(graph, part, 4), ElementsAre(16, 16, 16, 16));
}

TEST(SmallPartition, FindsAlmostAllLeastCuts)
{
  std::mt19937_64 engine(7);
  constexpr int Graphs = 60;
  int best = 0;
  for (int i = 0; i < Graphs; ++i)
  {
    const DualGraph graph = RandomGraph(12, engine);
    const std::vector<int> part = PartitionSmallGraph(graph, 2);
    const std::vector<long> weights = WeightsOf(graph, part, 2);
    EXPECT_LE(std::abs(weights[0] - weights[1]), 2);
    const long cut = CountCutEdges(graph, part);
    const long least = LeastCut(graph);
    EXPECT_GE(cut, least);
    EXPECT_LE(cut, least + 2);
    best += cut == least ? 1 : 0;
  }
  EXPECT_GE(best, Graphs * 9 / 10);
}

TEST(SmallPartition, WeighsNodes)
{
  DualGraph graph = Lattice(8, 1);
  graph.Weights = { 500000000, 100000000, 100000000, 100000000, 100000000, 50000000, 30000000,
    20000000 };
  EXPECT_THAT(WeightsOf(graph, PartitionSmallGraph(graph, 2), 2),
    ::testing::UnorderedElementsAre(500000000, 500000000));
}

/** As METIS makes blocks. */
TEST(SmallPartition, TakesGraphsInPieces)
{
  const DualGraph graph = MakeGraph(6, { { 0, 1 }, { 1, 2 }, { 3, 4 } });
  const std::vector<int> part = PartitionSmallGraph(graph, 2);
  EXPECT_EQ(CountCutEdges(graph, part), 0);
  EXPECT_EQ(part.size(), 6U);
}

TEST(SmallPartition, TakesMorePartsThanNodes)
{
  const std::vector<int> part = PartitionSmallGraph(Lattice(3, 1), 5);
  EXPECT_THAT(part, ::testing::Each(::testing::AllOf(::testing::Ge(0), ::testing::Lt(5))));
  EXPECT_TRUE(PartitionSmallGraph(DualGraph(), 2).empty());
}

} // namespace

} // namespace pemesh

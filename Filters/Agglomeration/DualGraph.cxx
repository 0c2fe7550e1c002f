// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DualGraph.h"

#include "SmallPartition.h"

#include <metis.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <type_traits>

namespace pemesh
{

static_assert(std::is_same_v<idx_t, std::int32_t>, "METIS must be built with 32 bit numbers");

namespace
{

/** Parts of the shares given, or of equal ones where there are none. */
std::vector<int> CallMetis(decltype(&METIS_PartGraphKway) metis, const DualGraph& graph, int parts,
  int seed, const std::vector<real_t>& shares)
{
  std::vector<int> part(static_cast<std::size_t>(graph.NumberOfNodes()), 0);
  if (parts <= 1 || graph.NumberOfNodes() <= 1)
  {
    return part;
  }
  std::array<idx_t, METIS_NOPTIONS> options;
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_NUMBERING] = 0;
  idx_t nodes = graph.NumberOfNodes();
  idx_t constraints = 1;
  idx_t count = parts;
  idx_t cut = 0;
  // METIS changes none of its arguments but the last two, yet takes no pointers to const.
  const auto plain = [](const auto& values)
  {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    return values.empty() ? nullptr : const_cast<Value*>(values.data());
  };
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  metis(&nodes, &constraints, plain(graph.Offsets), plain(graph.Neighbors), plain(graph.Weights),
    nullptr, nullptr, &count, plain(shares), nullptr, options.data(), &cut, part.data());
  return part;
}

/** The nodes of each block, one after the other. */
struct NodesByBlock
{
  std::vector<int> First;
  std::vector<int> Nodes;
};

NodesByBlock SortByBlock(const std::vector<int>& block, int blocks)
{
  NodesByBlock sorted;
  sorted.First.assign(static_cast<std::size_t>(blocks) + 1, 0);
  for (const int b : block)
  {
    ++sorted.First[b + 1];
  }
  for (int b = 0; b < blocks; ++b)
  {
    sorted.First[b + 1] += sorted.First[b];
  }
  sorted.Nodes.resize(block.size());
  std::vector<int> next(sorted.First.begin(), sorted.First.end() - 1);
  for (int node = 0; node < static_cast<int>(block.size()); ++node)
  {
    sorted.Nodes[next[block[node]]++] = node;
  }
  return sorted;
}

/** The graph of some nodes; `local` is a buffer, -1 for every node before and after. */
void ExtractGraph(const DualGraph& graph, const int* nodes, int count, std::vector<int>& local,
  DualGraph& extracted)
{
  extracted.Offsets.assign(1, 0);
  extracted.Neighbors.clear();
  extracted.Weights.clear();
  for (int i = 0; i < count; ++i)
  {
    local[nodes[i]] = i;
  }
  for (int i = 0; i < count; ++i)
  {
    const int node = nodes[i];
    for (int j = graph.Offsets[node]; j < graph.Offsets[node + 1]; ++j)
    {
      if (local[graph.Neighbors[j]] >= 0)
      {
        extracted.Neighbors.push_back(local[graph.Neighbors[j]]);
      }
    }
    extracted.Offsets.push_back(static_cast<int>(extracted.Neighbors.size()));
    if (!graph.Weights.empty())
    {
      extracted.Weights.push_back(graph.Weights[node]);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    local[nodes[i]] = -1;
  }
}

using Partitioner =
  std::function<std::vector<int>(const DualGraph&, int, const std::vector<real_t>&)>;

/**
 * In two steps: blocks of the given number of parts by one function, the parts of each block by
 * another.
 */
std::vector<int> PartitionInBlocks(const DualGraph& graph, int parts, int partsOfABlock,
  const Partitioner& makeBlocks,
  const std::function<std::vector<int>(const DualGraph&, int)>& divideBlock,
  const std::function<bool(double)>& progress = {})
{
  const int blocks = (parts + partsOfABlock - 1) / partsOfABlock;
  if (blocks <= 1)
  {
    return divideBlock(graph, parts);
  }
  std::vector<int> firstPart(static_cast<std::size_t>(blocks) + 1);
  std::vector<real_t> shares(static_cast<std::size_t>(blocks));
  for (int block = 0; block <= blocks; ++block)
  {
    firstPart[block] = static_cast<int>(static_cast<std::int64_t>(parts) * block / blocks);
  }
  for (int block = 0; block < blocks; ++block)
  {
    shares[block] =
      static_cast<real_t>(firstPart[block + 1] - firstPart[block]) / static_cast<real_t>(parts);
  }
  const NodesByBlock sorted = SortByBlock(makeBlocks(graph, blocks, shares), blocks);
  std::vector<int> part(static_cast<std::size_t>(graph.NumberOfNodes()));
  std::vector<int> local(part.size(), -1);
  DualGraph inner;
  for (int block = 0; block < blocks; ++block)
  {
    if (progress && !progress(static_cast<double>(block + 1) / (blocks + 1)))
    {
      return {};
    }
    const int* nodes = sorted.Nodes.data() + sorted.First[block];
    const int count = sorted.First[block + 1] - sorted.First[block];
    ExtractGraph(graph, nodes, count, local, inner);
    const std::vector<int> found = divideBlock(inner, firstPart[block + 1] - firstPart[block]);
    for (int i = 0; i < count; ++i)
    {
      part[nodes[i]] = firstPart[block] + found[i];
    }
  }
  return part;
}

} // namespace

DualGraph MakeDualGraph(ElementMerger& merger, const std::function<bool(int)>& isLeftOut)
{
  DualGraph graph;
  const int elements = merger.GetMesh().NumberOfElements();
  std::vector<int> node(static_cast<std::size_t>(elements), -1);
  for (int element = 0; element < elements; ++element)
  {
    if (!isLeftOut(element))
    {
      node[element] = static_cast<int>(graph.Elements.size());
      graph.Elements.push_back(element);
    }
  }
  graph.Offsets.reserve(graph.Elements.size() + 1);
  graph.Neighbors.reserve(merger.GetMesh().Vertices.size());
  std::vector<int> neighbors;
  for (const int element : graph.Elements)
  {
    merger.GetNeighbors(element, neighbors);
    for (const int neighbor : neighbors)
    {
      if (node[neighbor] >= 0)
      {
        graph.Neighbors.push_back(node[neighbor]);
      }
    }
    graph.Offsets.push_back(static_cast<int>(graph.Neighbors.size()));
  }
  return graph;
}

long CountCutEdges(const DualGraph& graph, const std::vector<int>& parts)
{
  long twice = 0;
  for (int node = 0; node < graph.NumberOfNodes(); ++node)
  {
    for (int j = graph.Offsets[node]; j < graph.Offsets[node + 1]; ++j)
    {
      twice += parts[node] != parts[graph.Neighbors[j]] ? 1 : 0;
    }
  }
  return twice / 2;
}

std::vector<int> PartitionPlainly(const DualGraph& graph, int parts, int seed)
{
  return CallMetis(&METIS_PartGraphKway, graph, parts, seed, {});
}

std::vector<int> PartitionByBlocks(
  const DualGraph& graph, int parts, int seed, const std::function<bool(double)>& progress)
{
  constexpr int PartsOfABlock = 256;
  // Less than SmallGraphNodes, so that uneven blocks of METIS are small, too.
  constexpr int NodesOfASmallBlock = 60;
  const int nodes = std::max(1, graph.NumberOfNodes());
  const auto partsOfASmallBlock =
    static_cast<int>(std::int64_t{ NodesOfASmallBlock } * parts / nodes);
  const auto bisect = [seed](const DualGraph& block, int count, const std::vector<real_t>& shares)
  { return CallMetis(&METIS_PartGraphRecursive, block, count, seed, shares); };
  const auto divideSmall = [&bisect](const DualGraph& block, int count)
  {
    return block.NumberOfNodes() <= SmallGraphNodes ? PartitionSmallGraph(block, count)
                                                    : bisect(block, count, {});
  };
  const auto divide = [&](const DualGraph& block, int count)
  { return PartitionInBlocks(block, count, std::max(1, partsOfASmallBlock), bisect, divideSmall); };
  const auto spread = [seed](const DualGraph& whole, int count, const std::vector<real_t>& shares)
  { return CallMetis(&METIS_PartGraphKway, whole, count, seed, shares); };
  return PartitionInBlocks(graph, parts, PartsOfABlock, spread, divide, progress);
}

} // namespace pemesh

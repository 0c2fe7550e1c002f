// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallPartition.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace pemesh
{

namespace
{

using NodeSet = std::uint64_t;

constexpr NodeSet SetOf(int node)
{
  return NodeSet{ 1 } << node;
}

int FirstOf(NodeSet nodes)
{
  return std::countr_zero(nodes);
}

class SmallPartitioner
{
public:
  explicit SmallPartitioner(const DualGraph& graph)
    : Part(static_cast<std::size_t>(graph.NumberOfNodes()), 0)
  {
    for (int node = 0; node < graph.NumberOfNodes(); ++node)
    {
      this->Weight[node] = graph.Weights.empty() ? 1 : graph.Weights[node];
      this->Near[node] = 0;
      for (int j = graph.Offsets[node]; j < graph.Offsets[node + 1]; ++j)
      {
        this->Near[node] |= SetOf(graph.Neighbors[j]);
      }
    }
    for (int node = 0; node < graph.NumberOfNodes(); ++node)
    {
      this->Wide[node] = this->NeighborsOf(this->Near[node]) & ~SetOf(node);
    }
  }

  const std::vector<int>& Run(int parts)
  {
    const auto nodes = static_cast<int>(this->Part.size());
    this->Divide(nodes == SmallGraphNodes ? ~NodeSet{ 0 } : SetOf(nodes) - 1, 0, parts);
    return this->Part;
  }

private:
  /** A bisection that is being worked at: of all nodes, those of its first side. */
  struct Side
  {
    NodeSet Nodes = 0;
    std::int64_t Weight = 0;
    int Cut = 0;
  };

  void Divide(NodeSet nodes, int firstPart, int parts)
  {
    if (parts == 1 || nodes == 0)
    {
      for (; nodes != 0; nodes &= nodes - 1)
      {
        this->Part[FirstOf(nodes)] = firstPart;
      }
      return;
    }
    const NodeSet half = this->Bisect(nodes, parts);
    this->Divide(half, firstPart, parts / 2);
    this->Divide(nodes & ~half, firstPart + parts / 2, parts - parts / 2);
  }

  /** The nodes that make the first half of the parts. */
  NodeSet Bisect(NodeSet nodes, int parts)
  {
    this->All = nodes;
    this->Parts = parts;
    std::int64_t heaviest = 0;
    this->Total = 0;
    for (NodeSet left = nodes; left != 0; left &= left - 1)
    {
      heaviest = std::max<std::int64_t>(heaviest, this->Weight[FirstOf(left)]);
      this->Total += this->Weight[FirstOf(left)];
    }
    this->Tolerance = std::min(heaviest * parts, this->Total * (parts / 2) / 2);
    constexpr int Attempts = 3;
    NodeSet seeds = this->Farthest(SetOf(FirstOf(nodes)));
    Side best = this->Refine(this->Grow(seeds));
    for (int i = 1; i < Attempts; ++i)
    {
      const NodeSet seed = this->Farthest(seeds);
      seeds |= seed;
      const Side side = this->Refine(this->Grow(seed));
      best = this->IsBetter(side, best) ? side : best;
    }
    return best.Nodes;
  }

  NodeSet NeighborsOf(NodeSet nodes) const
  {
    NodeSet near = 0;
    for (; nodes != 0; nodes &= nodes - 1)
    {
      near |= this->Near[FirstOf(nodes)];
    }
    return near;
  }

  /** The one of All that most edges, or no path at all, part from some nodes. */
  NodeSet Farthest(NodeSet from) const
  {
    NodeSet reached = from;
    NodeSet last = from;
    for (NodeSet layer = from; layer != 0;)
    {
      last = layer;
      layer = this->NeighborsOf(layer) & this->All & ~reached;
      reached |= layer;
    }
    const NodeSet apart = this->All & ~reached;
    return SetOf(FirstOf(apart != 0 ? apart : last));
  }

  /** How far the first side is from its share, times the number of parts. */
  std::int64_t Imbalance(std::int64_t weight) const
  {
    return std::abs(weight * this->Parts - this->Total * (this->Parts / 2));
  }

  bool IsBetter(const Side& a, const Side& b) const
  {
    const std::int64_t imbalanceOfA = this->Imbalance(a.Weight);
    const std::int64_t imbalanceOfB = this->Imbalance(b.Weight);
    const std::int64_t excessOfA = std::max(imbalanceOfA, this->Tolerance);
    const std::int64_t excessOfB = std::max(imbalanceOfB, this->Tolerance);
    if (excessOfA != excessOfB)
    {
      return excessOfA < excessOfB;
    }
    return a.Cut != b.Cut ? a.Cut < b.Cut : imbalanceOfA < imbalanceOfB;
  }

  /** By how many edges more a node is bound to the other side than to its own. */
  int GainOf(int node, NodeSet own) const
  {
    const NodeSet near = this->Near[node] & this->All;
    return std::popcount(near & ~own) - std::popcount(near & own);
  }

  /** Of equal gains the one that rounds the sides: counts the neighbours of neighbours. */
  int RankOf(int node, NodeSet own) const
  {
    const NodeSet wide = this->Wide[node] & this->All;
    return 2 * SmallGraphNodes * this->GainOf(node, own) + std::popcount(wide & ~own) -
      std::popcount(wide & own);
  }

  void Move(int node, Side& side) const
  {
    const bool leaves = (side.Nodes & SetOf(node)) != 0;
    side.Cut -= this->GainOf(node, leaves ? side.Nodes : this->All & ~side.Nodes);
    side.Weight += leaves ? -this->Weight[node] : this->Weight[node];
    side.Nodes ^= SetOf(node);
  }

  /** Node by node, the one that leaves fewest edges cut, while that comes nearer to the share. */
  Side Grow(NodeSet seed) const
  {
    Side side;
    for (NodeSet border = seed; border != 0;)
    {
      const NodeSet rest = this->All & ~side.Nodes;
      int best = FirstOf(border);
      int bestRank = this->RankOf(best, rest);
      for (NodeSet left = border & (border - 1); left != 0; left &= left - 1)
      {
        const int rank = this->RankOf(FirstOf(left), rest);
        if (rank > bestRank)
        {
          best = FirstOf(left);
          bestRank = rank;
        }
      }
      if (this->Imbalance(side.Weight + this->Weight[best]) >= this->Imbalance(side.Weight))
      {
        break;
      }
      this->Move(best, side);
      border = (border | this->Near[best]) & this->All & ~side.Nodes;
      border = border != 0 ? border : this->All & ~side.Nodes;
    }
    return side;
  }

  /** The best node to move; -1 if none may be. */
  int ChooseMove(const Side& side, NodeSet free) const
  {
    const std::int64_t bound = std::max(this->Tolerance, this->Imbalance(side.Weight) - 1);
    int best = -1;
    int bestRank = 0;
    for (; free != 0; free &= free - 1)
    {
      const int node = FirstOf(free);
      const bool leaves = (side.Nodes & SetOf(node)) != 0;
      const NodeSet own = leaves ? side.Nodes : this->All & ~side.Nodes;
      if ((this->Near[node] & this->All & ~own) == 0 ||
        this->Imbalance(side.Weight + (leaves ? -this->Weight[node] : this->Weight[node])) > bound)
      {
        continue;
      }
      const int rank = this->RankOf(node, own);
      if (best < 0 || rank > bestRank)
      {
        best = node;
        bestRank = rank;
      }
    }
    return best;
  }

  /** Passes of moves, each node at most once in a pass; a pass ends where it was best. */
  Side Refine(Side side) const
  {
    constexpr int Patience = 6; // moves in a row that gain nothing
    for (bool improved = true; improved;)
    {
      improved = false;
      Side current = side;
      NodeSet free = this->All;
      for (int idle = 0; idle < Patience; ++idle)
      {
        const int node = this->ChooseMove(current, free);
        if (node < 0)
        {
          break;
        }
        this->Move(node, current);
        free &= ~SetOf(node);
        if (this->IsBetter(current, side))
        {
          side = current;
          improved = true;
          idle = -1;
        }
      }
    }
    return side;
  }

  std::array<NodeSet, SmallGraphNodes> Near; ///< neighbours
  std::array<NodeSet, SmallGraphNodes> Wide; ///< neighbours of neighbours
  std::array<int, SmallGraphNodes> Weight;
  std::vector<int> Part;

  ///@{
  /** Of the bisection in hand. */
  NodeSet All = 0;
  int Parts = 0;
  std::int64_t Total = 0;
  std::int64_t Tolerance = 0;
  ///@}
};

} // namespace

std::vector<int> PartitionSmallGraph(const DualGraph& graph, int parts)
{
  return SmallPartitioner(graph).Run(parts);
}

} // namespace pemesh

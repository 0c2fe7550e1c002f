// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "RuleFunctions.h"

#include <cstdint>
#include <numeric>
#include <random>

namespace pemesh
{

namespace
{

/** Uniform in [0, count): multiplies instead of rejecting, the same with every library. */
int RandomBelow(std::mt19937_64& engine, int count)
{
  return static_cast<int>(
    ((engine() >> 32) * static_cast<std::uint64_t>(static_cast<unsigned int>(count))) >> 32);
}

class RandomMerger
{
public:
  explicit RandomMerger(AgglomerationState& state)
    : State(state)
    , Engine(static_cast<std::uint64_t>(state.Parameters.Get("seed")))
    , Waiting(static_cast<std::size_t>(state.Merger.GetMesh().NumberOfElements()))
  {
    std::iota(this->Waiting.begin(), this->Waiting.end(), 0);
  }

  bool Run()
  {
    // An element that no neighbour can take waits for a later round: merges around it may have
    // opened a way. Every round but the last merges, so it ends.
    bool merged = true;
    while (merged && !this->State.IsDone())
    {
      merged = false;
      this->Candidates.swap(this->Waiting);
      this->Waiting.clear();
      while (!this->Candidates.empty() && !this->State.IsDone())
      {
        if (!this->State.GoesOn())
        {
          return false;
        }
        merged = this->MergeOne() || merged;
      }
    }
    return true;
  }

private:
  /** A random candidate merges with a random neighbour; a longer common boundary counts more. */
  bool MergeOne()
  {
    ElementMerger& merger = this->State.Merger;
    const auto chosen = static_cast<std::size_t>(
      RandomBelow(this->Engine, static_cast<int>(this->Candidates.size())));
    const int group = this->Candidates[chosen];
    if (merger.IsGroup(group) && !this->State.IsKept(group))
    {
      int side = merger.GetFirstSide(group);
      for (int i = RandomBelow(this->Engine, merger.GetNumberOfSides(group)); i > 0; --i)
      {
        side = merger.GetNextSide(side);
      }
      if (this->MergeAcrossSome(group, side))
      {
        return true; // the group, merged, stays a candidate if it kept its name
      }
      this->Waiting.push_back(group);
    }
    this->Candidates[chosen] = this->Candidates.back();
    this->Candidates.pop_back();
    return false;
  }

  /** Across the given side, or else the next one that can be; each neighbour is tried once. */
  bool MergeAcrossSome(int group, int first)
  {
    ElementMerger& merger = this->State.Merger;
    int side = first;
    int tried = ElementMerger::Border;
    do
    {
      const int neighbor = merger.GetGroupAcross(side);
      if (neighbor != ElementMerger::Border && neighbor != tried && !this->State.IsKept(neighbor) &&
        merger.Merge(group, neighbor) != ElementMerger::None)
      {
        return true;
      }
      tried = neighbor;
      side = merger.GetNextSide(side);
    } while (side != first);
    return false;
  }

  AgglomerationState& State;
  std::mt19937_64 Engine;
  std::vector<int> Candidates;
  std::vector<int> Waiting;
};

} // namespace

bool MergeAtRandom(AgglomerationState& state)
{
  return RandomMerger(state).Run();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "RandomNumbers.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pemesh
{

namespace
{

class RandomMerger
{
public:
  explicit RandomMerger(AgglomerationState& state)
    : State(state)
    , Random(static_cast<std::uint64_t>(state.Parameters.Get("seed")))
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
        this->DrawBatch();
        for (std::size_t i = 0; i < this->Batch.size() && !this->State.IsDone(); ++i)
        {
          if (!this->State.GoesOn())
          {
            return false;
          }
          merged = this->MergeOne(this->Batch[i]) || merged;
        }
      }
    }
    return true;
  }

private:
  /**
   * Takes some random candidates out. Each is somewhere else in memory, and they are fetched
   * together: one by one, waiting for memory takes most of the time. A batch is so small a share
   * that it is as good as drawing one after the other.
   */
  void DrawBatch()
  {
    constexpr std::size_t Largest = 64;
    constexpr std::size_t Share = 256;
    const std::size_t count =
      std::clamp(this->Candidates.size() / Share, std::size_t{ 1 }, Largest);
    this->Batch.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
      int& chosen = this->Candidates[static_cast<std::size_t>(
        this->Random.Below(static_cast<int>(this->Candidates.size())))];
      this->Batch.push_back(chosen);
      chosen = this->Candidates.back();
      this->Candidates.pop_back();
    }
    std::erase_if(this->Batch, [this](int group) { return !this->State.Merger.IsGroup(group); });
    for (const int group : this->Batch)
    {
      this->State.Merger.Prefetch(group);
    }
  }

  /** Merges with a random neighbour; a longer common boundary counts more. */
  bool MergeOne(int group)
  {
    ElementMerger& merger = this->State.Merger;
    if (!merger.IsGroup(group) || this->State.IsKept(group))
    {
      return false;
    }
    int side = merger.GetFirstSide(group);
    for (int i = this->Random.Below(merger.GetNumberOfSides(group)); i > 0; --i)
    {
      side = merger.GetNextSide(side);
    }
    if (!this->MergeAcrossSome(group, side))
    {
      this->Waiting.push_back(group);
      return false;
    }
    if (merger.IsGroup(group)) // or else the neighbour gave the name, which is listed already
    {
      this->Candidates.push_back(group);
    }
    return true;
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
  RandomNumbers Random;
  std::vector<int> Candidates;
  std::vector<int> Batch;
  std::vector<int> Waiting;
};

} // namespace

bool MergeAtRandom(AgglomerationState& state)
{
  return RandomMerger(state).Run();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PartMerger.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace pemesh
{

namespace
{

class PartMerger
{
public:
  PartMerger(
    AgglomerationState& state, std::vector<int>& part, int parts, const std::vector<int>& weights)
    : State(state)
    , Merger(state.Merger)
    , Part(part)
    , Members(static_cast<std::size_t>(parts))
    , Weights(weights.begin(), weights.end())
    , IsDone(part.size(), false)
    , IsFragment(part.size(), false)
  {
    for (int element = 0; element < static_cast<int>(part.size()); ++element)
    {
      if (part[element] >= 0)
      {
        this->Members[part[element]].push_back(element);
      }
    }
  }

  bool Run()
  {
    this->FillEmptyParts();
    for (const std::vector<int>& members : this->Members)
    {
      if (!this->GrowPart(members))
      {
        return false;
      }
    }
    return this->MergeLightest();
  }

private:
  void FillEmptyParts()
  {
    std::vector<int> empty;
    std::priority_queue<std::pair<std::size_t, int>> largest;
    for (int part = 0; part < static_cast<int>(this->Members.size()); ++part)
    {
      if (this->Members[part].empty())
      {
        empty.push_back(part);
      }
      else
      {
        largest.emplace(this->Members[part].size(), -part);
      }
    }
    for (const int part : empty)
    {
      const int whole = -largest.top().second;
      if (this->Members[whole].size() < 2)
      {
        return; // as many groups as elements
      }
      largest.pop();
      this->SplitPart(whole, part);
      largest.emplace(this->Members[whole].size(), -whole);
      largest.emplace(this->Members[part].size(), -part);
    }
  }

  /** The first half of a part, as a flood from its first element reaches it, becomes another. */
  void SplitPart(int whole, int part)
  {
    const std::vector<int> old = this->Members[whole];
    std::vector<int>& taken = this->Members[part];
    for (std::size_t start = 0, next = 0; taken.size() < old.size() / 2; ++start)
    {
      const auto take = [&](int element)
      {
        if (this->Part[element] == whole && taken.size() < old.size() / 2)
        {
          this->Part[element] = part;
          taken.push_back(element);
        }
      };
      take(old[start]);
      for (; next < taken.size(); ++next)
      {
        this->Merger.GetNeighbors(taken[next], this->Neighbors);
        std::for_each(this->Neighbors.begin(), this->Neighbors.end(), take);
      }
    }
    std::erase_if(this->Members[whole], [&](int element) { return this->Part[element] == part; });
  }

  bool GrowPart(const std::vector<int>& members)
  {
    int heaviest = ElementMerger::None;
    for (const int seed : members)
    {
      if (!this->State.GoesOn())
      {
        return false;
      }
      if (this->IsDone[seed])
      {
        continue;
      }
      const int group = this->GrowGroup(seed);
      this->IsFragment[group] = true;
      if (heaviest == ElementMerger::None || this->Weights[group] > this->Weights[heaviest])
      {
        heaviest = group;
      }
    }
    if (heaviest != ElementMerger::None)
    {
      this->IsFragment[heaviest] = false;
    }
    return true;
  }

  /** The group that a seed grows to within its part; elements are taken in layers. */
  int GrowGroup(int seed)
  {
    int group = seed;
    this->IsDone[seed] = true;
    this->Layer.clear();
    this->AddNeighbors(seed, this->Layer);
    bool grown = true;
    while (grown && !this->Layer.empty())
    {
      grown = false;
      this->NextLayer.clear();
      for (const int element : this->Layer)
      {
        if (this->IsDone[element])
        {
          continue;
        }
        this->Fresh.clear();
        this->AddNeighbors(element, this->Fresh);
        const int merged = this->Merge(group, element);
        if (merged == ElementMerger::None)
        {
          this->NextLayer.push_back(element);
          continue;
        }
        group = merged;
        grown = true;
        this->IsDone[element] = true;
        this->NextLayer.insert(this->NextLayer.end(), this->Fresh.begin(), this->Fresh.end());
      }
      this->Layer.swap(this->NextLayer);
    }
    return group;
  }

  /** Appends the elements of the same part that are not in a group yet. */
  void AddNeighbors(int element, std::vector<int>& layer)
  {
    this->Merger.GetNeighbors(element, this->Neighbors);
    for (const int neighbor : this->Neighbors)
    {
      if (this->Part[neighbor] == this->Part[element] && !this->IsDone[neighbor])
      {
        layer.push_back(neighbor);
      }
    }
  }

  int Merge(int a, int b)
  {
    const int merged = this->Merger.Merge(a, b);
    if (merged != ElementMerger::None)
    {
      this->Weights[merged] = this->Weights[a] + this->Weights[b];
    }
    return merged;
  }

  /** Fragments before others, light before heavy. */
  struct Entry
  {
    bool IsWhole;
    double Weight;
    int Group;

    bool operator<(const Entry& other) const // the top of a heap is the largest
    {
      return std::tie(this->IsWhole, this->Weight, this->Group) >
        std::tie(other.IsWhole, other.Weight, other.Group);
    }
  };

  bool IsCurrent(const Entry& entry) const
  {
    return this->Merger.IsGroup(entry.Group) && this->Weights[entry.Group] == entry.Weight &&
      this->IsFragment[entry.Group] != entry.IsWhole;
  }

  void Push(int group)
  {
    this->Heap.push({ !this->IsFragment[group], this->Weights[group], group });
  }

  bool MergeLightest()
  {
    if (this->State.IsDone())
    {
      return true;
    }
    this->IsParked.assign(this->Part.size(), false);
    for (int group = 0; group < static_cast<int>(this->Part.size()); ++group)
    {
      if (this->Merger.IsGroup(group) && !this->State.IsKept(group))
      {
        this->Push(group);
      }
    }
    while (!this->Heap.empty() && !this->State.IsDone())
    {
      if (!this->State.GoesOn())
      {
        return false;
      }
      const Entry lightest = this->Heap.top();
      this->Heap.pop();
      if (this->IsCurrent(lightest) && !this->IsParked[lightest.Group])
      {
        this->MergeIntoNeighbor(lightest.Group);
      }
    }
    return true;
  }

  void MergeIntoNeighbor(int group)
  {
    this->RankNeighbors(group);
    for (const auto& [sides, weight, neighbor] : this->Ranked)
    {
      const bool fragments = this->IsFragment[group] && this->IsFragment[neighbor];
      const int merged = this->Merge(group, neighbor);
      if (merged == ElementMerger::None)
      {
        continue;
      }
      this->IsFragment[merged] = fragments;
      this->IsParked[merged] = false;
      this->Push(merged);
      this->Merger.GetNeighbors(merged, this->Neighbors);
      for (const int other : this->Neighbors)
      {
        if (this->IsParked[other])
        {
          this->IsParked[other] = false;
          this->Push(other);
        }
      }
      return;
    }
    this->IsParked[group] = true;
  }

  /** Those with the most sides in common first, of equals the lightest. */
  void RankNeighbors(int group)
  {
    this->Merger.GetNeighbors(group, this->Neighbors);
    this->Ranked.clear();
    for (const int neighbor : this->Neighbors)
    {
      if (!this->State.IsKept(neighbor))
      {
        this->Ranked.emplace_back(0, this->Weights[neighbor], neighbor);
      }
    }
    const int first = this->Merger.GetFirstSide(group);
    int side = first;
    do
    {
      const int across = this->Merger.GetGroupAcross(side);
      for (auto& [sides, weight, neighbor] : this->Ranked)
      {
        sides -= neighbor == across ? 1 : 0;
      }
      side = this->Merger.GetNextSide(side);
    } while (side != first);
    std::sort(this->Ranked.begin(), this->Ranked.end());
  }

  AgglomerationState& State;
  ElementMerger& Merger;
  std::vector<int>& Part;
  std::vector<std::vector<int>> Members;
  std::vector<double> Weights; ///< of groups; integers, so that sums do not depend on order
  std::vector<bool> IsDone;
  std::vector<bool> IsFragment;
  std::vector<bool> IsParked;
  std::priority_queue<Entry> Heap;

  std::vector<int> Neighbors;
  std::vector<int> Layer;
  std::vector<int> NextLayer;
  std::vector<int> Fresh;
  std::vector<std::tuple<int, double, int>> Ranked;
};

} // namespace

bool MergeParts(
  AgglomerationState& state, std::vector<int>& part, int parts, const std::vector<int>& weights)
{
  return PartMerger(state, part, parts, weights).Run();
}

} // namespace pemesh

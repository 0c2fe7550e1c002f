// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RoundMerger.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pemesh
{

const double MergeCriterion::Refused = std::numeric_limits<double>::quiet_NaN();

namespace
{

/** Two bits behind the leading one: four steps from a number to its double. */
double CoarseRank(double rank)
{
  constexpr int DroppedBits = std::numeric_limits<double>::digits - 1 - 2;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(rank) >> DroppedBits << DroppedBits);
}

} // namespace

RoundMerger::RoundMerger(AgglomerationState& state, MergeCriterion& criterion)
  : State(state)
  , Merger(state.Merger)
  , Criterion(criterion)
  , Values(static_cast<std::size_t>(state.Merger.GetMesh().NumberOfElements()))
  , MergedIn(Values.size(), 0)
  , ListedIn(Values.size(), 0)
{
}

bool RoundMerger::Run()
{
  if (this->State.IsDone())
  {
    return true;
  }
  if (!this->MeasureElements())
  {
    return false;
  }
  for (this->Round = 1; !this->Active.empty() && !this->State.IsDone(); ++this->Round)
  {
    this->SortActive();
    if (!this->RunRound())
    {
      return false;
    }
    this->ListNextRound();
  }
  return true;
}

bool RoundMerger::MeasureElements()
{
  for (int element = 0; element < static_cast<int>(this->Values.size()); ++element)
  {
    if (!this->State.GoesOn())
    {
      return false;
    }
    if (!this->State.IsKept(element))
    {
      this->Values[element] = this->Criterion.ValueOf(element);
      this->Active.emplace_back(this->Criterion.RankOf(this->Values[element]), element);
    }
  }
  return true;
}

/** By rank, of equals along the curve. */
void RoundMerger::SortActive()
{
  const int groups = this->Merger.GetNumberOfGroups();
  const int mostMerges = std::min(groups / 2, static_cast<int>(this->Active.size()));
  if (groups - mostMerges > this->State.Target)
  {
    for (auto& [rank, group] : this->Active)
    {
      rank = CoarseRank(rank);
    }
  }
  std::sort(this->Active.begin(), this->Active.end());
}

bool RoundMerger::RunRound()
{
  this->MergedGroups.clear();
  for (const auto& [rank, group] : this->Active)
  {
    if (!this->State.GoesOn())
    {
      return false;
    }
    if (this->Merger.IsGroup(group) && this->MergedIn[group] != this->Round)
    {
      this->MergeWithBest(group);
    }
    if (this->State.IsDone())
    {
      break;
    }
  }
  return true;
}

void RoundMerger::MergeWithBest(int group)
{
  this->Merger.GetNeighbors(group, this->Neighbors);
  this->Criterion.Begin(group);
  this->Candidates.clear();
  for (const int neighbor : this->Neighbors)
  {
    if (this->State.IsKept(neighbor) || this->MergedIn[neighbor] == this->Round)
    {
      continue;
    }
    const double value =
      this->Criterion.Rate(neighbor, this->Values[group], this->Values[neighbor]);
    if (!std::isnan(value))
    {
      this->Candidates.emplace_back(value, neighbor);
    }
  }
  std::sort(this->Candidates.begin(), this->Candidates.end());
  for (const auto& [value, neighbor] : this->Candidates)
  {
    const int merged = this->Merger.Merge(group, neighbor);
    if (merged != ElementMerger::None)
    {
      this->Values[merged] = value;
      this->MergedIn[merged] = this->Round;
      this->MergedGroups.push_back(merged);
      return;
    }
  }
}

void RoundMerger::ListNextRound()
{
  this->Active.clear();
  const auto list = [this](int group)
  {
    if (this->ListedIn[group] != this->Round && !this->State.IsKept(group))
    {
      this->ListedIn[group] = this->Round;
      this->Active.emplace_back(this->Criterion.RankOf(this->Values[group]), group);
    }
  };
  for (const int group : this->MergedGroups)
  {
    list(group);
    this->Merger.GetNeighbors(group, this->Neighbors);
    std::for_each(this->Neighbors.begin(), this->Neighbors.end(), list);
  }
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "ElementGeometry.h"
#include "MetricRegistry.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pemesh
{

namespace
{

/**
 * The worst group first, taken from a heap whose outdated entries are recognized by the version of
 * the group. A group that no neighbour can take is parked until one of them has changed.
 */
class QualityMerger
{
public:
  explicit QualityMerger(AgglomerationState& state)
    : State(state)
    , Merger(state.Merger)
    , Sign(-state.Metric->Good)
    , Version(static_cast<std::size_t>(state.Merger.GetMesh().NumberOfElements()), 0)
    , Parked(Version.size(), false)
  {
    this->Heap.reserve(2 * this->Version.size());
  }

  bool Run()
  {
    for (int element = 0; element < static_cast<int>(this->Version.size()); ++element)
    {
      if (!this->State.GoesOn())
      {
        return false;
      }
      if (!this->State.IsKept(element))
      {
        this->Merger.GetVertices(element, this->Vertices);
        this->Heap.push_back({ this->Badness(), element, 0 });
      }
    }
    std::make_heap(this->Heap.begin(), this->Heap.end());
    while (!this->Heap.empty() && !this->State.IsDone())
    {
      if (!this->State.GoesOn())
      {
        return false;
      }
      std::pop_heap(this->Heap.begin(), this->Heap.end());
      const Entry worst = this->Heap.back();
      this->Heap.pop_back();
      if (this->Merger.IsGroup(worst.Group) && this->Version[worst.Group] == worst.Version)
      {
        this->MergeWithBest(worst);
      }
    }
    return true;
  }

private:
  struct Entry
  {
    double Badness;
    int Group;
    int Version;

    /** The worst on top of the heap, of equals the one of the smallest number. */
    bool operator<(const Entry& other) const
    {
      return this->Badness != other.Badness ? this->Badness < other.Badness
                                            : this->Group > other.Group;
    }
  };

  /** Of the polygon in Vertices: the larger the worse, infinite where the metric is undefined. */
  double Badness()
  {
    const double value = this->Geometry.SetVertices(this->Vertices)
      ? this->Sign * this->State.Metric->Function(this->Geometry)
      : std::numeric_limits<double>::infinity();
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }

  void MergeWithBest(const Entry& worst)
  {
    this->Merger.GetNeighbors(worst.Group, this->Neighbors);
    double least = 0.0;
    int best = ElementMerger::None;
    for (const int neighbor : this->Neighbors)
    {
      if (this->State.IsKept(neighbor) ||
        !this->Merger.GetUnion(worst.Group, neighbor, this->Vertices))
      {
        continue;
      }
      const double badness = this->Badness();
      if (best == ElementMerger::None || std::pair(badness, neighbor) < std::pair(least, best))
      {
        least = badness;
        best = neighbor;
      }
    }
    if (best == ElementMerger::None)
    {
      this->Parked[worst.Group] = true;
      return;
    }
    const int merged = this->Merger.Merge(worst.Group, best);
    this->Push(merged, least);
    this->Unpark(merged);
  }

  void Push(int group, double badness)
  {
    this->Parked[group] = false;
    this->Heap.push_back({ badness, group, ++this->Version[group] });
    std::push_heap(this->Heap.begin(), this->Heap.end());
  }

  void Unpark(int changed)
  {
    this->Merger.GetNeighbors(changed, this->Neighbors);
    for (const int neighbor : this->Neighbors)
    {
      if (this->Parked[neighbor])
      {
        this->Merger.GetVertices(neighbor, this->Vertices);
        this->Push(neighbor, this->Badness());
      }
    }
  }

  AgglomerationState& State;
  ElementMerger& Merger;
  double Sign;
  std::vector<int> Version;
  std::vector<bool> Parked;
  std::vector<Entry> Heap;

  ElementGeometry Geometry;
  std::vector<Point2> Vertices;
  std::vector<int> Neighbors;
};

} // namespace

bool MergeByQuality(AgglomerationState& state)
{
  return QualityMerger(state).Run();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "PointDistances.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pemesh
{

namespace
{

/** The smallest diameter of a placed polygon; infinite if there is none. */
double SmallestPlacedDiameter(const AgglomerationState& state)
{
  const PolygonMesh& mesh = state.Merger.GetMesh();
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    if (state.Placed[element])
    {
      mesh.GetVertices(element, vertices);
      smallest = std::min(smallest, Diameter(vertices));
    }
  }
  return smallest;
}

/**
 * Merges in rounds. In each round the smallest group comes first, and takes the neighbour with
 * which it makes the union of the smallest diameter; no group takes part in two merges of a round.
 * So groups grow evenly, all triangles are merged before any group comes near the bound, and hardly
 * one is left alone. Only groups that were merged in a round, and their neighbours, can do in the
 * next what they could not do before.
 */
class DiameterMerger
{
public:
  DiameterMerger(AgglomerationState& state, double largest)
    : State(state)
    , Merger(state.Merger)
    , LargestSquare(largest * largest)
    , Squares(static_cast<std::size_t>(state.Merger.GetMesh().NumberOfElements()))
    , MergedIn(Squares.size(), 0)
    , ListedIn(Squares.size(), 0)
    , Active(Squares.size())
  {
    for (std::size_t i = 0; i < this->Squares.size(); ++i)
    {
      this->Merger.GetVertices(static_cast<int>(i), this->Own);
      this->Squares[i] = this->OwnSquare();
    }
    std::iota(this->Active.begin(), this->Active.end(), 0);
  }

  bool Run()
  {
    for (this->Round = 1; !this->Active.empty() && !this->State.IsDone(); ++this->Round)
    {
      std::sort(this->Active.begin(), this->Active.end(),
        [this](int a, int b)
        { return std::pair(this->Squares[a], a) < std::pair(this->Squares[b], b); });
      this->MergedGroups.clear();
      for (const int group : this->Active)
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
          return true;
        }
      }
      this->ListNextRound();
    }
    return true;
  }

private:
  double OwnSquare() const
  {
    double square = 0.0;
    for (std::size_t i = 0; i < this->Own.size(); ++i)
    {
      square = std::max(square, this->FarthestSquare(this->Own[i], i));
    }
    return square;
  }

  /** The largest squared distance of a point from the first `count` vertices of the group. */
  double FarthestSquare(const Point2& point, std::size_t count) const
  {
    double square = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double dx = this->Own[i].x - point.x;
      const double dy = this->Own[i].y - point.y;
      square = std::max(square, dx * dx + dy * dy);
    }
    return square;
  }

  double UnionSquare(int group, int neighbor) const
  {
    double square = std::max(this->Squares[group], this->Squares[neighbor]);
    const int first = this->Merger.GetFirstSide(neighbor);
    int side = first;
    do
    {
      const Point2& point = this->Merger.GetMesh().Points[this->Merger.GetVertex(side)];
      square = std::max(square, this->FarthestSquare(point, this->Own.size()));
      side = this->Merger.GetNextSide(side);
    } while (side != first && square <= this->LargestSquare);
    return square;
  }

  void MergeWithBest(int group)
  {
    if (this->State.IsKept(group) || this->Squares[group] > this->LargestSquare)
    {
      return;
    }
    this->Merger.GetVertices(group, this->Own);
    this->Merger.GetNeighbors(group, this->Neighbors);
    this->Candidates.clear();
    for (const int neighbor : this->Neighbors)
    {
      if (this->State.IsKept(neighbor) || this->MergedIn[neighbor] == this->Round)
      {
        continue;
      }
      const double square = this->UnionSquare(group, neighbor);
      if (square <= this->LargestSquare)
      {
        this->Candidates.emplace_back(square, neighbor);
      }
    }
    std::sort(this->Candidates.begin(), this->Candidates.end());
    for (const auto& [square, neighbor] : this->Candidates)
    {
      const int merged = this->Merger.Merge(group, neighbor);
      if (merged != ElementMerger::None)
      {
        this->Squares[merged] = square;
        this->MergedIn[merged] = this->Round;
        this->MergedGroups.push_back(merged);
        return;
      }
    }
  }

  void ListNextRound()
  {
    this->Active.clear();
    const auto list = [this](int group)
    {
      if (this->ListedIn[group] != this->Round)
      {
        this->ListedIn[group] = this->Round;
        this->Active.push_back(group);
      }
    };
    for (const int group : this->MergedGroups)
    {
      list(group);
      this->Merger.GetNeighbors(group, this->Neighbors);
      std::for_each(this->Neighbors.begin(), this->Neighbors.end(), list);
    }
  }

  AgglomerationState& State;
  ElementMerger& Merger;
  double LargestSquare;
  std::vector<double> Squares; ///< of the diameter of a group
  std::vector<int> MergedIn;   ///< round
  std::vector<int> ListedIn;   ///< round
  std::vector<int> Active;
  std::vector<int> MergedGroups;
  int Round = 0;

  std::vector<Point2> Own;
  std::vector<int> Neighbors;
  std::vector<std::pair<double, int>> Candidates;
};

} // namespace

bool MergeByDiameter(AgglomerationState& state)
{
  double largest = state.Parameters.Get("max-diameter");
  if (largest == 0.0)
  {
    largest = SmallestPlacedDiameter(state);
    if (std::isinf(largest))
    {
      state.Problem =
        "The agglomeration rule \"diameter\" needs max-diameter where the mesh has no "
        "placed polygons.";
      return true;
    }
  }
  return DiameterMerger(state, largest).Run();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointDistances.h"
#include "RoundMerger.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
 * Squares of diameters; the smallest group first, and the union of the smallest diameter. All
 * triangles are merged before any group comes near the bound, so hardly one is left alone.
 */
class DiameterCriterion : public MergeCriterion
{
public:
  DiameterCriterion(ElementMerger& merger, double largest)
    : Merger(merger)
    , LargestSquare(largest * largest)
  {
  }

  double RankOf(double value) const override { return value; }

  double ValueOf(int element) override
  {
    this->Merger.GetVertices(element, this->Own);
    double square = 0.0;
    for (const Point2& point : this->Own)
    {
      square = std::max(square, this->FarthestSquare(point));
    }
    return square;
  }

  void Begin(int group) override { this->Merger.GetVertices(group, this->Own); }

  double Rate(int neighbor, double groupValue, double neighborValue) override
  {
    double square = std::max(groupValue, neighborValue);
    const int first = this->Merger.GetFirstSide(neighbor);
    int side = first;
    do
    {
      const Point2& point = this->Merger.GetMesh().Points[this->Merger.GetVertex(side)];
      square = std::max(square, this->FarthestSquare(point));
      side = this->Merger.GetNextSide(side);
    } while (side != first && square <= this->LargestSquare);
    return square <= this->LargestSquare ? square : Refused;
  }

private:
  /** The largest squared distance of a point from the vertices of the group. */
  double FarthestSquare(const Point2& point) const
  {
    double square = 0.0;
    for (const Point2& own : this->Own)
    {
      const double dx = own.x - point.x;
      const double dy = own.y - point.y;
      square = std::max(square, dx * dx + dy * dy);
    }
    return square;
  }

  ElementMerger& Merger;
  double LargestSquare;
  std::vector<Point2> Own;
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
  DiameterCriterion criterion(state.Merger, largest);
  return RoundMerger(state, criterion).Run();
}

} // namespace pemesh

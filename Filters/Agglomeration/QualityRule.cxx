// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementGeometry.h"
#include "MetricRegistry.h"
#include "RoundMerger.h"
#include "RuleFunctions.h"

#include <cmath>
#include <limits>
#include <vector>

namespace pemesh
{

namespace
{

/**
 * How bad a group is: the metric, with its sign turned where large values are good, and infinite
 * where it is undefined. The worst group first, and the union that is least bad.
 */
class QualityCriterion : public MergeCriterion
{
public:
  QualityCriterion(ElementMerger& merger, const Metric& metric)
    : Merger(merger)
    , Measured(metric)
  {
  }

  double RankOf(double value) const override { return -value; }

  double ValueOf(int element) override
  {
    this->Merger.GetVertices(element, this->Vertices);
    return this->Badness();
  }

  void Begin(int group) override { this->Group = group; }

  double Rate(int neighbor, double, double) override
  {
    return this->Merger.GetUnion(this->Group, neighbor, this->Vertices) ? this->Badness() : Refused;
  }

private:
  /** Of the polygon in Vertices. */
  double Badness()
  {
    const double value = this->Geometry.SetVertices(this->Vertices)
      ? -this->Measured.Good * this->Measured.Function(this->Geometry)
      : std::numeric_limits<double>::infinity();
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }

  ElementMerger& Merger;
  const Metric& Measured;
  ElementGeometry Geometry;
  std::vector<Point2> Vertices;
  int Group = ElementMerger::None;
};

} // namespace

bool MergeByQuality(AgglomerationState& state)
{
  QualityCriterion criterion(state.Merger, *state.Metric);
  return RoundMerger(state, criterion).Run();
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Agglomeration.h"

#include "AgglomerationInput.h"
#include "AgglomerationState.h"
#include "ElementMerger.h"
#include "MeshOrder.h"
#include "MetricRegistry.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

std::string WhyMetricUnusable(const AgglomerationOptions& options)
{
  const std::string rule = std::string("The agglomeration rule \"") + options.Rule->Name + "\" ";
  if (options.Rule->Metric == RuleMetric::WorstFirst)
  {
    if (!options.Metric)
    {
      return rule + "needs a metric.";
    }
    if (options.Metric->Good == 0)
    {
      return rule + "cannot use the metric " + options.Metric->Name +
        ", of which neither a large nor a small value is good.";
    }
  }
  return options.Metric && options.Rule->Metric == RuleMetric::None
    ? rule + "does not use a metric."
    : std::string();
}

std::string WhyMisconfigured(const PolygonMesh& mesh, const AgglomerationOptions& options)
{
  if (options.TargetElements < 0 ||
    !(options.TargetPercentage >= 0.0 && options.TargetPercentage <= 100.0))
  {
    return "The target of an agglomeration is at least one element, or up to 100 percent of them.";
  }
  if (options.TargetElements > 0 && options.TargetPercentage > 0.0)
  {
    return "An agglomeration has one target: a number of elements or a percentage.";
  }
  if (!options.Placed.empty() &&
    options.Placed.size() != static_cast<std::size_t>(mesh.NumberOfElements()))
  {
    return "It is not known of every element whether it is a placed polygon.";
  }
  return WhyMetricUnusable(options);
}

/** 0 if none applies. */
double FindPercentage(const AgglomerationOptions& options)
{
  return options.TargetPercentage > 0.0 ? options.TargetPercentage
                                        : options.Rule->DefaultPercentage;
}

int FindTarget(const PolygonMesh& mesh, const AgglomerationOptions& options)
{
  if (options.TargetElements > 0)
  {
    return options.TargetElements;
  }
  const double percentage = FindPercentage(options);
  return std::max(1, static_cast<int>(std::lround(percentage / 100.0 * mesh.NumberOfElements())));
}

/** The loops of the groups, with the numbers of the old mesh. */
void CollectMesh(const PolygonMesh& mesh, const OrderedMesh& ordered, ElementMerger& merger,
  AgglomerationResult& result)
{
  const auto elements = static_cast<std::size_t>(mesh.NumberOfElements());
  std::vector<int> groupOfOld(elements);
  for (std::size_t element = 0; element < elements; ++element)
  {
    groupOfOld[ordered.OldElement[element]] = merger.Find(static_cast<int>(element));
  }
  std::vector<int> number(elements, -1); // of groups
  result.Group.resize(elements);
  result.Mesh.Points = mesh.Points;
  result.Mesh.Offsets.reserve(static_cast<std::size_t>(merger.GetNumberOfGroups()) + 1);
  std::vector<int> vertices;
  for (std::size_t old = 0; old < elements; ++old)
  {
    const int group = groupOfOld[old];
    if (number[group] < 0)
    {
      number[group] = result.Mesh.NumberOfElements();
      vertices.clear();
      const int first = merger.GetFirstSide(group);
      int side = first;
      do
      {
        vertices.push_back(ordered.OldPoint[merger.GetVertex(side)]);
        side = merger.GetNextSide(side);
      } while (side != first);
      result.Mesh.AddElement(vertices);
    }
    result.Group[old] = number[group];
  }
}

/** What was placed, by the new numbers. */
std::vector<bool> ReorderPlaced(const std::vector<bool>& placed, const OrderedMesh& ordered)
{
  std::vector<bool> reordered(ordered.OldElement.size(), false);
  for (std::size_t element = 0; !placed.empty() && element < reordered.size(); ++element)
  {
    reordered[element] = placed[ordered.OldElement[element]];
  }
  return reordered;
}

} // namespace

AgglomerationOptions::AgglomerationOptions(const AgglomerationRule& rule)
  : Rule(&rule)
  , Parameters(rule.Parameters)
  , Metric(FindMetric(rule.DefaultMetric))
{
}

AgglomerationResult Agglomerate(const PolygonMesh& mesh, const AgglomerationOptions& options,
  const std::function<bool(double)>& progress)
{
  AgglomerationResult result;
  result.Message = WhyMisconfigured(mesh, options);
  if (!result.Message.empty())
  {
    result.Status = AgglomerationStatus::Misconfigured;
    return result;
  }
  OrderedMesh ordered;
  {
    const MeshAdjacency adjacency = FindAdjacency(mesh);
    result.Message = WhyNotAgglomerable(mesh, adjacency);
    if (!result.Message.empty())
    {
      result.Status = AgglomerationStatus::NotAgglomerable;
      return result;
    }
    ordered = OrderAlongCurve(mesh, adjacency);
  }
  const std::vector<bool> placed = ReorderPlaced(options.Placed, ordered);
  ElementMerger merger(ordered.Mesh, ordered.Adjacency);
  ordered.Adjacency = {}; // the merger has its own
  AgglomerationState state{ merger, placed, options.KeepPlaced, FindTarget(mesh, options),
    options.TargetElements > 0 || FindPercentage(options) > 0.0, options.Metric, options.Parameters,
    progress, {} };
  if (!options.Rule->Apply(state))
  {
    result.Status = AgglomerationStatus::Stopped;
    return result;
  }
  result.Message = state.Problem;
  if (!result.Message.empty())
  {
    result.Status = AgglomerationStatus::NotAgglomerable;
    return result;
  }
  CollectMesh(mesh, ordered, merger, result);
  result.MovedArea = RemoveStraightVertices(result.Mesh, options.StraightVertices);
  RemoveUnusedPoints(result.Mesh);
  return result;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "DualGraph.h"
#include "ElementGeometry.h"
#include "MetricRegistry.h"
#include "PartMerger.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pemesh
{

namespace
{

/** How many parts the elements that may be merged are to make. */
int CountParts(const AgglomerationState& state)
{
  const int elements = state.Merger.GetMesh().NumberOfElements();
  int kept = 0;
  for (int element = 0; element < elements; ++element)
  {
    kept += state.IsKept(element) ? 1 : 0;
  }
  return std::clamp(state.Target - kept, 1, std::max(1, elements - kept));
}

/** The metric of an element each; 0 where it is undefined or negative. */
std::vector<double> MeasureElements(const PolygonMesh& mesh, const Metric& metric)
{
  std::vector<double> values(static_cast<std::size_t>(mesh.NumberOfElements()), 0.0);
  ElementGeometry geometry;
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    mesh.GetVertices(element, vertices);
    const double value = geometry.SetVertices(vertices) ? metric.Function(geometry) : 0.0;
    values[element] = std::isfinite(value) ? std::max(value, 0.0) : 0.0;
  }
  return values;
}

/** Integers in proportion to the metric; their sum stays far below 2^31, as METIS needs it. */
std::vector<int> MakeWeights(const AgglomerationState& state)
{
  const PolygonMesh& mesh = state.Merger.GetMesh();
  std::vector<int> weights(static_cast<std::size_t>(mesh.NumberOfElements()), 1);
  if (!state.Metric)
  {
    return weights;
  }
  const std::vector<double> values = MeasureElements(mesh, *state.Metric);
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  const double resolution = std::min(5e8, 1000.0 * static_cast<double>(values.size()));
  for (std::size_t i = 0; sum > 0.0 && i < values.size(); ++i)
  {
    weights[i] = std::max(1, static_cast<int>(std::lround(values[i] / sum * resolution)));
  }
  return weights;
}

} // namespace

bool MergeByMetis(AgglomerationState& state)
{
  const int parts = CountParts(state);
  const std::vector<int> weights = MakeWeights(state);
  std::vector<int> part(weights.size(), -1);
  {
    DualGraph graph =
      MakeDualGraph(state.Merger, [&state](int element) { return state.IsKept(element); });
    if (state.Metric)
    {
      for (const int element : graph.Elements)
      {
        graph.Weights.push_back(weights[element]);
      }
    }
    // The partition takes most of the time; merges report the rest from the start again.
    const std::vector<int> found =
      PartitionByBlocks(graph, parts, state.Parameters.GetInteger("seed"),
        state.Progress ? [&state](double fraction) { return state.Progress(0.9 * fraction); }
                       : state.Progress);
    if (found.empty() && !graph.Elements.empty())
    {
      return false;
    }
    for (std::size_t node = 0; node < found.size(); ++node)
    {
      part[graph.Elements[node]] = found[node];
    }
  }
  return MergeParts(state, part, parts, weights);
}

bool MergeByCurve(AgglomerationState& state)
{
  const int elements = state.Merger.GetMesh().NumberOfElements();
  // Elements are numbered along the curve already: see AgglomerationState.
  std::vector<int> order;
  for (int element = 0; element < elements; ++element)
  {
    if (!state.IsKept(element))
    {
      order.push_back(element);
    }
  }
  const auto free = static_cast<std::int64_t>(order.size());
  if (!state.HasTarget)
  {
    const double blocks = static_cast<double>(free) / state.Parameters.Get("elements-per-block");
    state.Target =
      elements - static_cast<int>(free) + std::max(1, static_cast<int>(std::lround(blocks)));
  }
  const int parts = CountParts(state);
  std::vector<int> part(static_cast<std::size_t>(elements), -1);
  for (std::int64_t i = 0; i < free; ++i)
  {
    part[order[i]] = static_cast<int>(i * parts / free);
  }
  return MergeParts(state, part, parts, std::vector<int>(part.size(), 1));
}

} // namespace pemesh

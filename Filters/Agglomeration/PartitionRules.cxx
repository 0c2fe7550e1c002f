// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationState.h"
#include "DualGraph.h"
#include "ElementGeometry.h"
#include "HilbertCurve.h"
#include "MetricRegistry.h"
#include "PartMerger.h"
#include "PolygonMeasures.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

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

/** Where a double in [0, 1] falls in 2^31 cells. */
std::uint32_t CellOf(double fraction)
{
  return static_cast<std::uint32_t>(std::clamp(fraction, 0.0, 1.0) * 2147483647.0);
}

/** The elements that may be merged, along a Hilbert curve through their centroids. */
std::vector<int> SortAlongCurve(const AgglomerationState& state)
{
  const PolygonMesh& mesh = state.Merger.GetMesh();
  Point2 low = mesh.Points[mesh.Vertices[0]];
  Point2 high = low;
  for (const int vertex : mesh.Vertices)
  {
    const Point2& point = mesh.Points[vertex];
    low = { std::min(low.x, point.x), std::min(low.y, point.y) };
    high = { std::max(high.x, point.x), std::max(high.y, point.y) };
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  std::vector<std::pair<std::uint64_t, int>> keys;
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    if (!state.IsKept(element))
    {
      mesh.GetVertices(element, vertices);
      const Point2 center = Centroid(vertices);
      keys.emplace_back(
        HilbertKey(CellOf((center.x - low.x) / size), CellOf((center.y - low.y) / size)), element);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [key, element] : keys)
  {
    order.push_back(element);
  }
  return order;
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
  const std::vector<int> order = SortAlongCurve(state);
  const auto elements = static_cast<std::int64_t>(order.size());
  if (!state.HasTarget)
  {
    const double block = state.Parameters.Get("elements-per-block");
    const auto kept = state.Merger.GetMesh().NumberOfElements() - static_cast<int>(elements);
    state.Target =
      kept + std::max(1, static_cast<int>(std::lround(static_cast<double>(elements) / block)));
  }
  const int parts = CountParts(state);
  std::vector<int> part(static_cast<std::size_t>(state.Merger.GetMesh().NumberOfElements()), -1);
  for (std::int64_t i = 0; i < elements; ++i)
  {
    part[order[i]] = static_cast<int>(i * parts / elements);
  }
  return MergeParts(state, part, parts, std::vector<int>(part.size(), 1));
}

} // namespace pemesh

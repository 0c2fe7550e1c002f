// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The registry: every metric of an element is one entry of one table (MetricRegistry.cxx).
 *
 * Filters, command line, help and documentation read this table; adding a metric is adding an
 * entry. In the formulas an element has n vertices, area A, perimeter P, diameter h, shortest and
 * longest edge e_min and e_max, interior angles theta_i up to 2 pi, r the radius of the largest
 * circle inside, R of the smallest circle around it, A_K and r_K area and inscribed radius of its
 * kernel. Straight vertices count as vertices.
 */
#ifndef pemesh_MetricRegistry_h
#define pemesh_MetricRegistry_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

class ElementGeometry;

/** What a metric is computed from; each is computed once for an element, and only if asked for. */
enum MetricNeeds : unsigned int
{
  NeedsNothing = 0,
  NeedsArea = 1U << 0,
  NeedsEdges = 1U << 1,
  NeedsAngles = 1U << 2,
  NeedsDistances = 1U << 3, // diameter and closest pair
  NeedsEnclosingCircle = 1U << 4,
  NeedsInscribedCircle = 1U << 5,
  NeedsKernelArea = 1U << 6,
  NeedsKernelRadius = 1U << 7
};

struct Metric
{
  const char* Name;        // of the array: "KernelAreaRatio"
  const char* Symbol;      // of the literature: "KAR"
  const char* Label;       // for people: "Kernel-area ratio"
  const char* Formula;     // "A_K / A"
  const char* Description; // one or two sentences
  const char* Range;       // "[0, 1]"
  int Good;                // 1: larger is better, -1: smaller is better, 0: neither
  bool ScaleInvariant;
  const char* Unit; // "1", "rad", "length" or "length^2"
  const char* Reference;
  unsigned int Needs; // a sum of MetricNeeds
  double (*Function)(ElementGeometry&);
};

/** All metrics, in the order of columns and lists. */
PEMESHFILTERSMETRICS_EXPORT std::span<const Metric> Metrics();

/** By its name (upper and lower case differ); null if there is none. */
PEMESHFILTERSMETRICS_EXPORT const Metric* FindMetric(std::string_view name);

/** The names of all metrics, in the order of Metrics(). */
PEMESHFILTERSMETRICS_EXPORT std::vector<std::string> MetricNames();

/** One sentence for a name that is not in the registry, which tells the nearest one that is. */
PEMESHFILTERSMETRICS_EXPORT std::string DescribeUnknownMetric(std::string_view name);

} // namespace pemesh

#endif

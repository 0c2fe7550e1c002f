// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The registry: every metric of an element is one entry of one table.
 *
 * The tables are ElementMetrics.cxx (what an element measures), IndicatorMetrics.cxx (indicators of
 * the literature), NeighbourMetrics.cxx (an element and those around it) and SolverMetrics.cxx
 * (what its stiffness matrix says). Filters, command line, help and documentation read them; adding
 * a metric is adding an entry. In the formulas an element has n vertices, area A, perimeter P,
 * diameter h, shortest and longest edge e_min and e_max, interior angles theta_i up to 2 pi, r the
 * radius of the largest circle inside, R of the smallest circle around it, A_K and r_K area and
 * inscribed radius of its kernel. Straight vertices count as vertices.
 */
#ifndef pemesh_MetricRegistry_h
#define pemesh_MetricRegistry_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vtkType.h> // For vtkIdType

namespace pemesh
{

class ElementGeometry;
struct MeshSurroundings;

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
  NeedsKernelRadius = 1U << 7,
  NeedsCorners = 1U << 8,    // sines of the angles and shapes of the corners
  NeedsSides = 1U << 9,      // edges on one straight line
  NeedsBox = 1U << 10,       // axis-parallel bounding box
  NeedsStiffness = 1U << 11, // element matrices of the virtual element method
  NeedsMesh = 1U << 12,      // a value of all elements of the mesh
  NeedsNeighbours = 1U << 13
};

/** The words for a sum of MetricNeeds: {"area", "edges"}. */
PEMESHFILTERSMETRICS_EXPORT std::vector<std::string> DescribeNeeds(unsigned int needs);

/** The table a metric is in. Those of the first two are "all", the others are asked for by name. */
enum class MetricSet
{
  Measure,
  Indicator,
  Neighbourhood,
  Jump,
  Solver
};

struct Metric
{
  const char* Name = "";        // of the array: "KernelAreaRatio"
  const char* Symbol = "";      // of the literature: "KAR"
  const char* Label = "";       // for people: "Kernel-area ratio"
  const char* Formula = "";     // "A_K / A"
  const char* Tex = "";         // the same for TeX, without the dollar signs
  const char* Description = ""; // one or two sentences
  const char* Range = "";       // "[0, 1]"
  int Good = 0;                 // 1: larger is better, -1: smaller is better, 0: neither
  bool ScaleInvariant = true;
  bool RotationInvariant = true;
  const char* Unit = "1"; // "1", "rad", "length" or "length^2"
  const char* Reference = "";
  unsigned int Needs = NeedsNothing; // a sum of MetricNeeds
  const char* Alias = "";            // another name it is known by, or empty
  /** Of an element alone; null for a metric that needs the mesh. */
  double (*Function)(ElementGeometry&) = nullptr;
  /** Of an element of a mesh, from the values of the metric named by Base (or of none). */
  double (*InMesh)(const MeshSurroundings&, vtkIdType element) = nullptr;
  const char* Base = "";
  MetricSet Set = MetricSet::Measure;
};

/** All metrics, in the order of columns and lists. */
PEMESHFILTERSMETRICS_EXPORT std::span<const Metric> Metrics();

/** By its name or its alias (upper and lower case differ); null if there is none. */
PEMESHFILTERSMETRICS_EXPORT const Metric* FindMetric(std::string_view name);

/** The same, but null as well for a metric that needs more than the element. */
PEMESHFILTERSMETRICS_EXPORT const Metric* FindElementMetric(std::string_view name);

/** The names of the metrics that "all" stands for, in the order of Metrics(). */
PEMESHFILTERSMETRICS_EXPORT std::vector<std::string> MetricNames();

/** A word that stands for several metrics: "all", "neighbourhood", "jumps", "solver". */
struct MetricCollection
{
  const char* Name;
  const char* Description;
  bool (*Contains)(const Metric&);
};
PEMESHFILTERSMETRICS_EXPORT std::span<const MetricCollection> MetricCollections();

/** The test that compares a metric with values known from elsewhere: the name given to ctest. */
PEMESHFILTERSMETRICS_EXPORT std::string MetricTest(const Metric& metric);

/** One sentence for a name that is not in the registry, which tells the nearest one that is. */
PEMESHFILTERSMETRICS_EXPORT std::string DescribeUnknownMetric(std::string_view name);

} // namespace pemesh

#endif

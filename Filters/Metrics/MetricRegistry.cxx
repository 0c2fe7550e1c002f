// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricRegistry.h"

#include "ElementGeometry.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <numeric>

namespace pemesh
{

namespace
{

constexpr const char* Attene2021 =
  "M. Attene et al., Benchmarking the geometrical robustness of a Virtual Element Poisson solver, "
  "Math. Comput. Simul. 190 (2021) 1392-1414, doi 10.1016/j.matcom.2021.07.018";
constexpr const char* Lee1979 =
  "D. T. Lee, F. P. Preparata, An optimal algorithm for finding the kernel of a polygon, J. ACM 26 "
  "(1979) 415-421, doi 10.1145/322139.322142";
constexpr const char* Osserman1978 =
  "R. Osserman, The isoperimetric inequality, Bull. Amer. Math. Soc. 84 (1978) 1182-1238, "
  "doi 10.1090/S0002-9904-1978-14553-4";

// One entry a metric, in the order of columns. The kernels behind are those of ElementGeometry.
constexpr Metric Table[] = {
  { "NumberOfEdges", "nE", "Number of edges", "n",
    "Edges of the element; a side with a hanging vertex counts as two.", "[3, inf)", 0, true, "1",
    Attene2021, NeedsNothing,
    [](ElementGeometry& e) { return static_cast<double>(e.GetVertices().size()); } },
  { "InscribedRadius", "IC", "Inscribed radius", "r",
    "Radius of the largest circle inside the element itself, not its convex hull.", "(0, inf)", 0,
    false, "length", Attene2021, NeedsInscribedCircle,
    [](ElementGeometry& e) { return e.GetInscribedRadius(); } },
  { "CircumscribedRadius", "CC", "Circumscribed radius", "R",
    "Radius of the smallest circle around the element.", "(0, inf)", 0, false, "length", Attene2021,
    NeedsEnclosingCircle, [](ElementGeometry& e) { return e.GetEnclosingRadius(); } },
  { "CircleRatio", "CR", "Circle ratio", "r / R",
    "Inscribed over circumscribed radius; near 1 for round elements.", "(0, 1)", 1, true, "1",
    Attene2021, NeedsInscribedCircle | NeedsEnclosingCircle,
    [](ElementGeometry& e) { return e.GetInscribedRadius() / e.GetEnclosingRadius(); } },
  { "Area", "AR", "Area", "A", "Area of the element.", "(0, inf)", 0, false, "length^2", Attene2021,
    NeedsArea, [](ElementGeometry& e) { return e.GetArea(); } },
  { "KernelArea", "KE", "Kernel area", "A_K",
    "Area of the kernel, the points that see the whole element; 0 if it is not star-shaped.",
    "[0, inf)", 0, false, "length^2", Lee1979, NeedsKernelArea,
    [](ElementGeometry& e) { return e.GetKernelArea(); } },
  { "KernelAreaRatio", "KAR", "Kernel-area ratio", "A_K / A",
    "Share of the element that sees all of it; exactly 1 for convex elements.", "[0, 1]", 1, true,
    "1", Attene2021, NeedsKernelArea | NeedsArea,
    [](ElementGeometry& e) { return e.GetKernelArea() / e.GetArea(); } },
  { "AreaPerimeterRatio", "APR", "Area-perimeter ratio", "4 pi A / P^2",
    "Isoperimetric quotient, 1 only for a disc. Also known as PAR; other programs print A / P^2 or "
    "2 pi A / P^2, the same order on another scale.",
    "(0, 1)", 1, true, "1", Osserman1978, NeedsArea | NeedsEdges,
    [](ElementGeometry& e)
    {
      const double perimeter = e.GetEdges().Perimeter;
      return 4.0 * std::numbers::pi * e.GetArea() / (perimeter * perimeter);
    } },
  { "MinAngle", "MA", "Minimum angle", "min theta_i", "Smallest interior angle.", "(0, pi)", 1,
    true, "rad", Attene2021, NeedsAngles,
    [](ElementGeometry& e) { return e.GetAngles().Smallest; } },
  { "MaxAngle", "mA", "Maximum angle", "max theta_i",
    "Largest interior angle; reflex angles count.", "[pi/3, 2 pi)", -1, true, "rad", Attene2021,
    NeedsAngles, [](ElementGeometry& e) { return e.GetAngles().Largest; } },
  { "AngleRatio", "MA/mA", "Angle ratio", "min theta / max theta",
    "Smallest over largest interior angle; 1 for equiangular elements.", "(0, 1]", 1, true, "1",
    Attene2021, NeedsAngles,
    [](ElementGeometry& e) { return e.GetAngles().Smallest / e.GetAngles().Largest; } },
  { "ShortestEdge", "SE", "Shortest edge", "e_min", "Length of the shortest edge.", "(0, inf)", 0,
    false, "length", Attene2021, NeedsEdges,
    [](ElementGeometry& e) { return e.GetEdges().Shortest; } },
  { "EdgeRatio", "ER", "Edge ratio", "e_min / e_max", "Shortest over longest edge.", "(0, 1]", 1,
    true, "1", Attene2021, NeedsEdges,
    [](ElementGeometry& e) { return e.GetEdges().Shortest / e.GetEdges().Longest; } },
  { "MinPointDistance", "MPD", "Minimum point distance", "min |v_i - v_j|",
    "Least distance of two vertices, neighbours or not; at most the shortest edge.", "(0, inf)", 0,
    false, "length", Attene2021, NeedsDistances,
    [](ElementGeometry& e) { return e.GetClosestPairDistance(); } },
  { "NormalizedPointDistance", "NPD", "Normalized point distance", "min |v_i - v_j| / h",
    "Least over largest distance of two vertices; 1 for the equilateral triangle.", "(0, 1]", 1,
    true, "1", Attene2021, NeedsDistances,
    [](ElementGeometry& e) { return e.GetClosestPairDistance() / e.GetDiameter(); } },
  { "ShapeRegularity", "SRG", "Shape regularity", "r_K / R",
    "Radius of the largest circle in the kernel over that of the smallest around the element; 0 if "
    "the element is not star-shaped.",
    "[0, 1)", 1, true, "1", Attene2021, NeedsKernelRadius | NeedsEnclosingCircle,
    [](ElementGeometry& e) { return e.GetKernelRadius() / e.GetEnclosingRadius(); } },
};

/** Number of letters to change, add or take away (V. I. Levenshtein), case aside. */
std::size_t EditDistance(std::string_view a, std::string_view b)
{
  const auto Lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t change = diagonal + (Lower(a[i]) == Lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ change, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

} // namespace

std::span<const Metric> Metrics()
{
  return Table;
}

const Metric* FindMetric(std::string_view name)
{
  const auto found = std::find_if(std::begin(Table), std::end(Table),
    [name](const Metric& metric) { return name == metric.Name; });
  return found == std::end(Table) ? nullptr : &*found;
}

std::vector<std::string> MetricNames()
{
  std::vector<std::string> names;
  for (const Metric& metric : Table)
  {
    names.emplace_back(metric.Name);
  }
  return names;
}

std::string DescribeUnknownMetric(std::string_view name)
{
  // A symbol ("KAR") is a likely thing to type for a name, so it counts as near.
  const auto Distance = [name](const Metric& metric)
  { return name == metric.Symbol ? std::size_t{ 0 } : EditDistance(name, metric.Name); };
  const auto nearest = std::min_element(std::begin(Table), std::end(Table),
    [&](const Metric& a, const Metric& b) { return Distance(a) < Distance(b); });
  return "There is no metric \"" + std::string(name) + "\"; the nearest is \"" + nearest->Name +
    "\".";
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * An element and the elements that share an edge with it.
 */
#include "CornerMeasures.h"
#include "MeshSurroundings.h"
#include "MetricTables.h"
#include "SummaryTitles.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

namespace pemesh
{

namespace
{

constexpr const char* OwnDefinition = "PEMesh, Filters/Metrics/README.md";

struct FractionRange
{
  double Smallest = std::numeric_limits<double>::quiet_NaN();
  double Largest = std::numeric_limits<double>::quiet_NaN();
};

/** Of the lengths shared with each neighbour, over the perimeter. */
FractionRange SharedFractions(const MeshSurroundings& mesh, vtkIdType element)
{
  FractionRange range;
  const auto shared = mesh.Neighbours->GetShared(element);
  if (!shared.empty())
  {
    const auto Shorter = [](const SharedLength& a, const SharedLength& b)
    { return a.Length < b.Length; };
    const auto [least, most] = std::ranges::minmax_element(shared, Shorter);
    const double perimeter = mesh.Neighbours->GetPerimeter(element);
    range = { std::min(1.0, least->Length / perimeter), std::min(1.0, most->Length / perimeter) };
  }
  return range;
}

double BoundaryFraction(const MeshSurroundings& mesh, vtkIdType element)
{
  return std::min(
    1.0, mesh.Neighbours->GetBorderLength(element) / mesh.Neighbours->GetPerimeter(element));
}

double CountHangingVertices(const MeshSurroundings& mesh, vtkIdType element)
{
  return static_cast<double>(
    mesh.Neighbours->CountHangingVertices(element, StraightTolerance * mesh.Base[element]));
}

/** The largest value of `Compare` of the element and a neighbour; undefined without neighbours. */
template <typename Comparison>
double LargestJump(const MeshSurroundings& mesh, vtkIdType element, const Comparison& compare)
{
  double largest = std::numeric_limits<double>::quiet_NaN();
  const double own = mesh.Base[element];
  for (const int neighbour : mesh.Neighbours->GetTwinElements(element))
  {
    const double jump = neighbour < 0 ? largest : compare(own, mesh.Base[neighbour]);
    largest = jump > largest || std::isnan(largest) ? jump : largest;
  }
  return largest;
}

double LargestRatio(const MeshSurroundings& mesh, vtkIdType element)
{
  return LargestJump(mesh, element,
    [](double a, double b)
    {
      const bool isDefined = a > 0.0 && b > 0.0;
      return isDefined ? std::max(a, b) / std::min(a, b) : std::numeric_limits<double>::quiet_NaN();
    });
}

double LargestDifference(const MeshSurroundings& mesh, vtkIdType element)
{
  return LargestJump(mesh, element, [](double a, double b) { return std::abs(a - b); });
}

/** A text that lives as long as the registry. */
const char* Keep(std::string text)
{
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text)).c_str();
}

constexpr Metric Table[] = {
  { .Name = "NumberOfNeighbours",
    .Symbol = "nN",
    .Label = "Number of neighbours",
    .Formula = "number of E' that share an edge with E",
    .Tex = R"(|\{E' : |\partial E \cap \partial E'| > 0\}|)",
    .Description = "Elements that share at least one edge with the element.",
    .Range = "[0, inf)",
    .Reference = OwnDefinition,
    .Needs = NeedsNeighbours,
    .InMesh = [](const MeshSurroundings& mesh, vtkIdType element)
    { return static_cast<double>(mesh.Neighbours->GetShared(element).size()); } },
  { .Name = "HangingVertices",
    .Symbol = "nH",
    .Label = "Hanging vertices",
    .Formula = "number of straight vertices where the neighbour changes",
    .Tex = R"(|\{v \in E \text{ straight} : E'_- (v) \ne E'_+ (v)\}|)",
    .Description =
      "Straight vertices (see VEMRho4) at which an edge of a neighbour ends: the edges before and "
      "after belong to different neighbours, or one of them to the boundary.",
    .Range = "[0, inf)",
    .Good = -1,
    .Reference = OwnDefinition,
    .Needs = NeedsNeighbours | NeedsSides,
    .InMesh = CountHangingVertices,
    .Base = "Diameter" },
  { .Name = "LargestSharedFraction",
    .Symbol = "sM",
    .Label = "Largest shared fraction",
    .Formula = "max over E' of |E and E'| / P",
    .Tex = R"(\max_{E'} \frac{|\partial E \cap \partial E'|}{P})",
    .Description = "Longest length shared with one neighbour, as a part of the perimeter; "
                   "undefined without neighbours.",
    .Range = "(0, 1]",
    .Reference = OwnDefinition,
    .Needs = NeedsNeighbours | NeedsEdges,
    .InMesh = [](const MeshSurroundings& mesh, vtkIdType element)
    { return SharedFractions(mesh, element).Largest; } },
  { .Name = "SmallestSharedFraction",
    .Symbol = "sm",
    .Label = "Smallest shared fraction",
    .Formula = "min over E' of |E and E'| / P",
    .Tex = R"(\min_{E'} \frac{|\partial E \cap \partial E'|}{P})",
    .Description = "Shortest length shared with one neighbour, as a part of the perimeter; "
                   "undefined without neighbours.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = OwnDefinition,
    .Needs = NeedsNeighbours | NeedsEdges,
    .InMesh = [](const MeshSurroundings& mesh, vtkIdType element)
    { return SharedFractions(mesh, element).Smallest; } },
  { .Name = "BoundaryFraction",
    .Symbol = "bF",
    .Label = "Boundary fraction",
    .Formula = "length of the edges on the boundary / P",
    .Tex = R"(\frac{|\partial E \cap \partial \Omega|}{P})",
    .Description = "Part of the perimeter that is on the boundary of the mesh.",
    .Range = "[0, 1]",
    .Reference = OwnDefinition,
    .Needs = NeedsNeighbours | NeedsEdges,
    .InMesh = BoundaryFraction },
};

} // namespace

Metric MakeJumpMetric(const Metric& metric)
{
  const std::string symbol = metric.Symbol;
  const std::string tex = metric.Tex;
  Metric jump;
  jump.Name = Keep(std::string(metric.Name) + "Jump");
  jump.Symbol = Keep("J(" + symbol + ")");
  jump.Label = Keep("Jump of " + LowerFirst(metric.Label));
  jump.Reference = OwnDefinition;
  jump.Good = -1;
  jump.RotationInvariant = metric.RotationInvariant;
  jump.Needs = metric.Needs | NeedsNeighbours;
  jump.Base = metric.Name;
  if (metric.ScaleInvariant)
  {
    jump.Formula = Keep("max over E' of |" + symbol + "(E) - " + symbol + "(E')|");
    jump.Tex = Keep(R"(\max_{E'} |q(E) - q(E')|, \quad q = )" + tex);
    jump.Description = "Largest difference to a neighbour; undefined without neighbours.";
    jump.Range = "[0, inf)";
    jump.Unit = metric.Unit;
    jump.InMesh = LargestDifference;
  }
  else
  {
    jump.Formula =
      Keep("max over E' of the larger over the smaller of " + symbol + "(E), " + symbol + "(E')");
    jump.Tex = Keep(R"(\max_{E'} \frac{\max(q(E), q(E'))}{\min(q(E), q(E'))}, \quad q = )" + tex);
    jump.Description = "Largest ratio to a neighbour; undefined without neighbours or where one of "
                       "the two is zero.";
    jump.Range = "[1, inf)";
    jump.InMesh = LargestRatio;
  }
  return jump;
}

std::span<const Metric> NeighbourMetricTable()
{
  return Table;
}

} // namespace pemesh

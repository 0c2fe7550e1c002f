// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What an element measures: the metrics of M. Attene et al. (2021).
 */
#include "ElementGeometry.h"
#include "MetricTables.h"

#include <numbers>

namespace pemesh
{

namespace
{

constexpr const char* Lee1979 =
  "D. T. Lee, F. P. Preparata, An optimal algorithm for finding the kernel of a polygon, J. ACM 26 "
  "(1979) 415-421, doi 10.1145/322139.322142";
constexpr const char* Osserman1978 =
  "R. Osserman, The isoperimetric inequality, Bull. Amer. Math. Soc. 84 (1978) 1182-1238, "
  "doi 10.1090/S0002-9904-1978-14553-4";

constexpr Metric Table[] = {
  { .Name = "NumberOfEdges",
    .Symbol = "nE",
    .Label = "Number of edges",
    .Formula = "n",
    .Tex = R"(n)",
    .Description = "Edges of the element; a side with a hanging vertex counts as two.",
    .Range = "[3, inf)",
    .Reference = Attene2021,
    .Function = [](ElementGeometry& e) { return static_cast<double>(e.GetVertices().size()); } },
  { .Name = "InscribedRadius",
    .Symbol = "IC",
    .Label = "Inscribed radius",
    .Formula = "r",
    .Tex = R"(r)",
    .Description = "Radius of the largest circle inside the element itself, not its convex hull.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length",
    .Reference = Attene2021,
    .Needs = NeedsInscribedCircle,
    .Function = [](ElementGeometry& e) { return e.GetInscribedRadius(); } },
  { .Name = "CircumscribedRadius",
    .Symbol = "CC",
    .Label = "Circumscribed radius",
    .Formula = "R",
    .Tex = R"(R)",
    .Description = "Radius of the smallest circle around the element.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length",
    .Reference = Attene2021,
    .Needs = NeedsEnclosingCircle,
    .Function = [](ElementGeometry& e) { return e.GetEnclosingRadius(); } },
  { .Name = "CircleRatio",
    .Symbol = "CR",
    .Label = "Circle ratio",
    .Formula = "r / R",
    .Tex = R"(\frac{r}{R})",
    .Description =
      "Inscribed over circumscribed radius; near 1 for round elements. Also known as CIR.",
    .Range = "(0, 1)",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsInscribedCircle | NeedsEnclosingCircle,
    .Function = [](ElementGeometry& e)
    { return e.GetInscribedRadius() / e.GetEnclosingRadius(); } },
  { .Name = "Area",
    .Symbol = "AR",
    .Label = "Area",
    .Formula = "A",
    .Tex = R"(A)",
    .Description = "Area of the element.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length^2",
    .Reference = Attene2021,
    .Needs = NeedsArea,
    .Function = [](ElementGeometry& e) { return e.GetArea(); } },
  { .Name = "KernelArea",
    .Symbol = "KE",
    .Label = "Kernel area",
    .Formula = "A_K",
    .Tex = R"(A_K)",
    .Description =
      "Area of the kernel, the points that see the whole element; 0 if it is not star-shaped.",
    .Range = "[0, inf)",
    .ScaleInvariant = false,
    .Unit = "length^2",
    .Reference = Lee1979,
    .Needs = NeedsKernelArea,
    .Function = [](ElementGeometry& e) { return e.GetKernelArea(); } },
  { .Name = "KernelAreaRatio",
    .Symbol = "KAR",
    .Label = "Kernel-area ratio",
    .Formula = "A_K / A",
    .Tex = R"(\frac{A_K}{A})",
    .Description = "Share of the element that sees all of it; exactly 1 for convex elements.",
    .Range = "[0, 1]",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsKernelArea | NeedsArea,
    .Function = [](ElementGeometry& e) { return e.GetKernelArea() / e.GetArea(); } },
  { .Name = "AreaPerimeterRatio",
    .Symbol = "APR",
    .Label = "Area-perimeter ratio",
    .Formula = "4 pi A / P^2",
    .Tex = R"(\frac{4 \pi A}{P^2})",
    .Description = "Isoperimetric quotient, 1 only for a disc. Also known as PAR; other programs "
                   "print A / P^2 or 2 pi A / P^2, the same order on another scale.",
    .Range = "(0, 1)",
    .Good = 1,
    .Reference = Osserman1978,
    .Needs = NeedsArea | NeedsEdges,
    .Function =
      [](ElementGeometry& e)
    {
      const double perimeter = e.GetEdges().Perimeter;
      return 4.0 * std::numbers::pi * e.GetArea() / (perimeter * perimeter);
    } },
  { .Name = "MinAngle",
    .Symbol = "MA",
    .Label = "Minimum angle",
    .Formula = "min theta_i",
    .Tex = R"(\min_i \theta_i)",
    .Description = "Smallest interior angle.",
    .Range = "(0, pi)",
    .Good = 1,
    .Unit = "rad",
    .Reference = Attene2021,
    .Needs = NeedsAngles,
    .Function = [](ElementGeometry& e) { return e.GetAngles().Smallest; } },
  { .Name = "MaxAngle",
    .Symbol = "mA",
    .Label = "Maximum angle",
    .Formula = "max theta_i",
    .Tex = R"(\max_i \theta_i)",
    .Description = "Largest interior angle; reflex angles count.",
    .Range = "[pi/3, 2 pi)",
    .Good = -1,
    .Unit = "rad",
    .Reference = Attene2021,
    .Needs = NeedsAngles,
    .Function = [](ElementGeometry& e) { return e.GetAngles().Largest; } },
  { .Name = "AngleRatio",
    .Symbol = "MA/mA",
    .Label = "Angle ratio",
    .Formula = "min theta / max theta",
    .Tex = R"(\frac{\min_i \theta_i}{\max_i \theta_i})",
    .Description =
      "Smallest over largest interior angle; 1 for equiangular elements. Also known as ANR.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsAngles,
    .Function = [](ElementGeometry& e) { return e.GetAngles().Smallest / e.GetAngles().Largest; } },
  { .Name = "ShortestEdge",
    .Symbol = "SE",
    .Label = "Shortest edge",
    .Formula = "e_min",
    .Tex = R"(e_{\min})",
    .Description = "Length of the shortest edge.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length",
    .Reference = Attene2021,
    .Needs = NeedsEdges,
    .Function = [](ElementGeometry& e) { return e.GetEdges().Shortest; } },
  { .Name = "EdgeRatio",
    .Symbol = "ER",
    .Label = "Edge ratio",
    .Formula = "e_min / e_max",
    .Tex = R"(\frac{e_{\min}}{e_{\max}})",
    .Description = "Shortest over longest edge.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsEdges,
    .Function = [](ElementGeometry& e) { return e.GetEdges().Shortest / e.GetEdges().Longest; } },
  { .Name = "MinPointDistance",
    .Symbol = "MPD",
    .Label = "Minimum point distance",
    .Formula = "min |v_i - v_j|",
    .Tex = R"(\min_{i \ne j} |v_i - v_j|)",
    .Description = "Least distance of two vertices, neighbours or not; at most the shortest edge.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length",
    .Reference = Attene2021,
    .Needs = NeedsDistances,
    .Function = [](ElementGeometry& e) { return e.GetClosestPairDistance(); } },
  { .Name = "NormalizedPointDistance",
    .Symbol = "NPD",
    .Label = "Normalized point distance",
    .Formula = "min |v_i - v_j| / h",
    .Tex = R"(\frac{\min_{i \ne j} |v_i - v_j|}{h})",
    .Description = "Least over largest distance of two vertices; 1 for the equilateral triangle.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsDistances,
    .Function = [](ElementGeometry& e) { return e.GetClosestPairDistance() / e.GetDiameter(); } },
  { .Name = "ShapeRegularity",
    .Symbol = "SRG",
    .Label = "Shape regularity",
    .Formula = "r_K / R",
    .Tex = R"(\frac{r_K}{R})",
    .Description = "Radius of the largest circle in the kernel over that of the smallest around "
                   "the element; 0 if the element is not star-shaped. Also known as KRR.",
    .Range = "[0, 1)",
    .Good = 1,
    .Reference = Attene2021,
    .Needs = NeedsKernelRadius | NeedsEnclosingCircle,
    .Alias = "KernelRadiusRatio",
    .Function = [](ElementGeometry& e) { return e.GetKernelRadius() / e.GetEnclosingRadius(); } },
};

} // namespace

std::span<const Metric> ElementMetricTable()
{
  return Table;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Indicators of the literature after M. Attene et al. (2021).
 */
#include "ElementGeometry.h"
#include "MeshSurroundings.h"
#include "MetricTables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr const char* Gillette2012 =
  "A. Gillette, A. Rand, C. Bajaj, Error estimates for generalized barycentric interpolation, "
  "Adv. Comput. Math. 37 (2012) 417-439, doi 10.1007/s10444-011-9218-z";
constexpr const char* Stimpson2007 = "C. J. Stimpson et al., The Verdict geometric quality "
                                     "library, Sandia report SAND2007-1751 (2007)";
constexpr const char* Knupp2000 =
  "P. M. Knupp, Achieving finite element mesh quality via optimization of the Jacobian matrix norm "
  "and associated quantities. Part I, Int. J. Numer. Methods Eng. 48 (2000) 401-420, doi "
  "10.1002/(SICI)1097-0207(20000530)48:3<401::AID-NME880>3.0.CO;2-D";
constexpr const char* Knupp2001 =
  "P. M. Knupp, Algebraic mesh quality metrics, SIAM J. Sci. Comput. 23 (2001) 193-218, "
  "doi 10.1137/S1064827500371499";
constexpr const char* Antonietti2025 =
  "P. F. Antonietti et al., MAGNET: an open-source library for mesh agglomeration by graph neural "
  "networks, arXiv 2504.21780 (2025)";
constexpr const char* Polydeal =
  "polyDEAL, polytopal discontinuous Galerkin methods in deal.II, github.com/fdrmrc/Polydeal";

constexpr const char* Cabiddu2021 =
  "D. Cabiddu, G. Patane, M. Spagnuolo, A graphical framework to study the correlation between "
  "geometric design and simulation, arXiv 2102.11578 (2021), and its program of 2022";

/** The lesser of two sizes of an element: the side of a square of its area, its shortest edge. */
double SmallestLength(ElementGeometry& e)
{
  return std::min(std::sqrt(e.GetArea()), e.GetEdges().Shortest);
}

constexpr Metric Table[] = {
  { .Name = "Diameter",
    .Symbol = "h",
    .Label = "Diameter",
    .Formula = "h",
    .Tex = R"(h)",
    .Description = "Largest distance of two vertices.",
    .Range = "(0, inf)",
    .ScaleInvariant = false,
    .Unit = "length",
    .Reference = Sorgente2022,
    .Needs = NeedsDistances,
    .Function = [](ElementGeometry& e) { return e.GetDiameter(); } },
  { .Name = "InradiusRatio",
    .Symbol = "INR",
    .Label = "Inradius ratio",
    .Formula = "2 r / h",
    .Tex = R"(\frac{2 r}{h})",
    .Description = "Diameter of the largest circle inside over the diameter of the element.",
    .Range = "(0, 1)",
    .Good = 1,
    .Reference = Gillette2012,
    .Needs = NeedsInscribedCircle | NeedsDistances,
    .Function = [](ElementGeometry& e) { return 2.0 * e.GetInscribedRadius() / e.GetDiameter(); } },
  { .Name = "OutradiusRatio",
    .Symbol = "OUR",
    .Label = "Outradius ratio",
    .Formula = "h / (2 R)",
    .Tex = R"(\frac{h}{2 R})",
    .Description = "Diameter of the element over that of the smallest circle around it; sqrt(3)/2 "
                   "for the equilateral triangle (H. Jung's theorem).",
    .Range = "[sqrt(3)/2, 1]",
    .Reference = Gillette2012,
    .Needs = NeedsEnclosingCircle | NeedsDistances,
    .Function = [](ElementGeometry& e)
    { return std::min(1.0, 0.5 * e.GetDiameter() / e.GetEnclosingRadius()); } },
  { .Name = "MinAngleFraction",
    .Symbol = "MIA",
    .Label = "Minimum angle fraction",
    .Formula = "min theta_i / (2 pi)",
    .Tex = R"(\frac{\min_i \theta_i}{2 \pi})",
    .Description = "Smallest interior angle as a part of a full turn.",
    .Range = "(0, 1/2)",
    .Good = 1,
    .Reference = Stimpson2007,
    .Needs = NeedsAngles,
    .Function = [](ElementGeometry& e)
    { return e.GetAngles().Smallest / (2.0 * std::numbers::pi); } },
  { .Name = "MaxAngleFraction",
    .Symbol = "MAA",
    .Label = "Maximum angle fraction",
    .Formula = "1 - max theta_i / (2 pi)",
    .Tex = R"(1 - \frac{\max_i \theta_i}{2 \pi})",
    .Description =
      "What the largest interior angle leaves of a full turn; 5/6 for the equilateral triangle.",
    .Range = "(0, 5/6]",
    .Good = 1,
    .Reference = Stimpson2007,
    .Needs = NeedsAngles,
    .Function = [](ElementGeometry& e)
    { return 1.0 - e.GetAngles().Largest / (2.0 * std::numbers::pi); } },
  { .Name = "ScaledJacobian",
    .Symbol = "JAC",
    .Label = "Scaled Jacobian",
    .Formula = "max(0, min sin theta_i)",
    .Tex = R"(\max(0, \min_i \sin \theta_i))",
    .Description = "Least sine of an interior angle, of a reflex one negative; 0 for elements that "
                   "are not convex or have straight vertices.",
    .Range = "[0, 1]",
    .Good = 1,
    .Reference = Knupp2000,
    .Needs = NeedsCorners,
    .Function = [](ElementGeometry& e) { return std::max(0.0, e.GetCorners().SmallestSine); } },
  { .Name = "FrobeniusRatio",
    .Symbol = "FRO",
    .Label = "Frobenius ratio",
    .Formula = "min 2 / kappa_i",
    .Tex = R"(\min_i \frac{2}{\kappa_i}, \quad \kappa_i = \|J_i\|_F \|J_i^{-1}\|_F)",
    .Description = "kappa_i is the condition number, in the Frobenius norm, of the matrix J_i of "
                   "the two edges at vertex i; 0 at a straight vertex.",
    .Range = "[0, 1]",
    .Good = 1,
    .Reference = Knupp2001,
    .Needs = NeedsCorners,
    .Function = [](ElementGeometry& e) { return e.GetCorners().SmallestFrobeniusRatio; } },
  { .Name = "VEMRho1",
    .Symbol = "rho_1",
    .Label = "VEM indicator 1 (kernel)",
    .Formula = "A_K / A",
    .Tex = R"(\varrho_1 = \frac{A_K}{A})",
    .Description = "Star-shapedness: the kernel-area ratio.",
    .Range = "[0, 1]",
    .Good = 1,
    .Reference = Sorgente2022,
    .Needs = NeedsKernelArea | NeedsArea,
    .Function = [](ElementGeometry& e) { return e.GetKernelArea() / e.GetArea(); } },
  { .Name = "VEMRho2",
    .Symbol = "rho_2",
    .Label = "VEM indicator 2 (size)",
    .Formula = "min(sqrt A, e_min) / h",
    .Tex = R"(\varrho_2 = \frac{\min(\sqrt{A}, e_{\min})}{h})",
    .Description = "Comparability of area, shortest edge and diameter.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Sorgente2022,
    .Needs = NeedsArea | NeedsEdges | NeedsDistances,
    .Function = [](ElementGeometry& e) { return SmallestLength(e) / e.GetDiameter(); } },
  { .Name = "VEMRho3",
    .Symbol = "rho_3",
    .Label = "VEM indicator 3 (edges)",
    .Formula = "3 / n",
    .Tex = R"(\varrho_3 = \frac{3}{n})",
    .Description = "Boundedness of the number of edges.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Sorgente2022,
    .Function = [](ElementGeometry& e)
    { return 3.0 / static_cast<double>(e.GetVertices().size()); } },
  { .Name = "VEMRho4",
    .Symbol = "rho_4",
    .Label = "VEM indicator 4 (sides)",
    .Formula = "min over straight sides of shortest / longest of its edges",
    .Tex = R"(\varrho_4 = \min_s \frac{\min_{e \subset s} |e|}{\max_{e \subset s} |e|})",
    .Description = "Uniformity of the edges of one straight side; 1 where no side is split. A "
                   "vertex is straight if it is at most 1e-10 h from the line through the vertices "
                   "before and after it, and between them.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Sorgente2022,
    .Needs = NeedsSides,
    .Function = [](ElementGeometry& e) { return e.GetSideRatio(); } },
  { .Name = "VEMIndicator",
    .Symbol = "VEM",
    .Label = "VEM indicator",
    .Formula = "sqrt(rho_1 (rho_2 + rho_3 + rho_4) / 3)",
    .Tex = R"(\sqrt{\frac{\varrho_1 \varrho_2 + \varrho_1 \varrho_3 + \varrho_1 \varrho_4}{3}})",
    .Description = "Quality of an element for the virtual element method. No polygon reaches 1: "
                   "the equilateral triangle has 0.9413.",
    .Range = "[0, 1]",
    .Good = 1,
    .Reference = Sorgente2022,
    .Needs = NeedsKernelArea | NeedsArea | NeedsEdges | NeedsDistances | NeedsSides,
    .Function =
      [](ElementGeometry& e)
    {
      const double rho1 = e.GetKernelArea() / e.GetArea();
      const double rho2 = SmallestLength(e) / e.GetDiameter();
      const double rho3 = 3.0 / static_cast<double>(e.GetVertices().size());
      return std::sqrt(rho1 * (rho2 + rho3 + e.GetSideRatio()) / 3.0);
    } },
  { .Name = "VEMRatio",
    .Symbol = "1/rho_2",
    .Label = "VEM ratio",
    .Formula = "h / min(sqrt A, e_min)",
    .Tex = R"(\frac{h}{\min(\sqrt{A}, e_{\min})})",
    .Description = "The inverse of rho_2, unbounded for elements with short edges.",
    .Range = "(2/sqrt(pi), inf)",
    .Good = -1,
    .Reference = Cabiddu2021,
    .Needs = NeedsArea | NeedsEdges | NeedsDistances,
    .Function = [](ElementGeometry& e) { return e.GetDiameter() / SmallestLength(e); } },
  { .Name = "MinSideRadiusRatio",
    .Symbol = "MDR",
    .Label = "Shortest edge over inscribed radius",
    .Formula = "e_min / r",
    .Tex = R"(\frac{e_{\min}}{r})",
    .Description = "Length of the shortest edge over the radius of the largest circle inside.",
    .Range = "(0, inf)",
    .Reference = Cabiddu2021,
    .Needs = NeedsEdges | NeedsInscribedCircle,
    .Function = [](ElementGeometry& e) { return e.GetEdges().Shortest / e.GetInscribedRadius(); } },
  { .Name = "UniformityFactor",
    .Symbol = "UF",
    .Label = "Uniformity factor",
    .Formula = "h / max h of the mesh",
    .Tex = R"(\frac{h}{\max_{E'} h_{E'}})",
    .Description = "Diameter over the largest diameter of the mesh.",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Antonietti2025,
    .Needs = NeedsMesh,
    .InMesh = [](const MeshSurroundings& mesh, vtkIdType element)
    { return mesh.Base[element] / mesh.LargestBase; },
    .Base = "Diameter" },
  { .Name = "BoxRatio",
    .Symbol = "BR",
    .Label = "Box ratio",
    .Formula = "A / area of the bounding box",
    .Tex = R"(\frac{A}{(x_{\max} - x_{\min}) (y_{\max} - y_{\min})})",
    .Description = "Share of the axis-parallel bounding box that the element fills; changes when "
                   "the element is turned.",
    .Range = "(0, 1]",
    .Good = 1,
    .RotationInvariant = false,
    .Reference = Polydeal,
    .Needs = NeedsArea | NeedsBox,
    .Function = [](ElementGeometry& e) { return std::min(1.0, e.GetArea() / e.GetBoxArea()); } },
};

} // namespace

std::span<const Metric> IndicatorMetricTable()
{
  return Table;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the stiffness matrix of an element says. They cost several times as much as all other
 * metrics, and are computed only when named.
 */
#include "ElementGeometry.h"
#include "MetricTables.h"

namespace pemesh
{

namespace
{

constexpr const char* Rangarajan2025 =
  "R. Rangarajan, N. Sukumar, CutVEM: conforming virtual element method on embedded domains with "
  "shape-agnostic element agglomeration, arXiv 2508.10570 (2025)";
constexpr const char* PolyDim = "S. Berrone et al., POLYDIM: a C++ library for polytopal "
                                "discretization methods, arXiv 2505.14063 "
                                "(2025)";

constexpr Metric Table[] = {
  { .Name = "StabilityRatio",
    .Symbol = "sR",
    .Label = "Stability ratio",
    .Formula = "lambda_2 / lambda_n",
    .Tex = R"(\frac{\lambda_2}{\lambda_n})",
    .Description =
      "Second smallest over largest eigenvalue of the stiffness matrix of the lowest-order virtual "
      "element method (the projection keeps the mean of the vertices, dofi-dofi stabilisation).",
    .Range = "(0, 1]",
    .Good = 1,
    .Reference = Rangarajan2025,
    .Needs = NeedsStiffness,
    .Function = [](ElementGeometry& e) { return e.GetStiffness().StabilityRatio; } },
  { .Name = "ProjectionCondition",
    .Symbol = "cP",
    .Label = "Condition of the projection",
    .Formula = "sigma_1 / sigma_3 of Pi",
    .Tex = R"(\frac{\sigma_1(\Pi)}{\sigma_3(\Pi)})",
    .Description =
      "Condition number of the matrix Pi, 3 by n, that takes the values at the vertices to the "
      "coefficients of the projection onto 1, (x - x_c) / h, (y - y_c) / h.",
    .Range = "[1, inf)",
    .Good = -1,
    .Reference = PolyDim,
    .Needs = NeedsStiffness,
    .Function = [](ElementGeometry& e) { return e.GetStiffness().ProjectionCondition; } },
};

} // namespace

std::span<const Metric> SolverMetricTable()
{
  return Table;
}

} // namespace pemesh

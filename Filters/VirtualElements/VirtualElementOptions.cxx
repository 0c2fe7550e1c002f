// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementOptions.h"

#include <algorithm>
#include <array>

namespace pemesh
{

namespace
{

constexpr const char* Guide = "L. Beirao da Veiga, F. Brezzi, L. D. Marini, A. Russo, The "
                              "hitchhiker's guide to the virtual element method, Math. Models "
                              "Methods Appl. Sci. 24 (2014) 1541-1573";

constexpr std::array Bases = {
  BasisRule{ "orthonormal", "Orthonormal",
    "orthonormal in L2, from the inertial monomials by "
    "modified Gram-Schmidt, twice",
    "S. Berrone, A. Borio, Orthogonal polynomials in badly shaped polygonal elements for the "
    "virtual element method, Finite Elem. Anal. Des. 129 (2017) 14-31",
    true, true },
  BasisRule{ "inertia", "Inertial monomials",
    "monomials along the axes of inertia, scaled so that "
    "the element is round",
    "S. Berrone, G. Teora, F. Vicini, Improving high-order VEM stability on badly-shaped elements, "
    "arXiv 2302.11284 (2023)",
    true, false },
  BasisRule{ "monomial", "Scaled monomials",
    "monomials of (x - centroid) / diameter; fails on slivers from order 3 on", Guide, false,
    false },
};

constexpr std::array Stabilisations = {
  StabilisationRule{ "dofi-dofi", "dofi-dofi", "mean diffusion", Guide,
    [](const StabilisationInput& input) { return input.MeanDiffusion; } },
  StabilisationRule{ "D-recipe", "D-recipe", "max(mean diffusion, diagonal of the consistent part)",
    "L. Beirao da Veiga, F. Dassi, A. Russo, High-order virtual element method on polyhedral "
    "meshes, Comput. Math. Appl. 74 (2017) 1110-1122",
    [](const StabilisationInput& input)
    { return std::max(input.MeanDiffusion, input.Consistency); } },
  StabilisationRule{ "trace", "Scaled by the trace",
    "trace of the consistent part / number of degrees of freedom",
    "L. Mascotto, Ill-conditioning in the virtual element method: stabilizations and bases, Numer. "
    "Methods Partial Differ. Equ. 34 (2018) 1258-1281",
    [](const StabilisationInput& input) { return input.MeanDiagonal; } },
  StabilisationRule{ "boundary", "Boundary values only",
    "mean diffusion on the boundary of the element, 0 for the moments",
    "L. Beirao da Veiga, C. Lovadina, A. Russo, Stability analysis for the virtual element method, "
    "Math. Models Methods Appl. Sci. 27 (2017) 2557-2594",
    [](const StabilisationInput& input) { return input.OnBoundary ? input.MeanDiffusion : 0.0; } },
  StabilisationRule{ "none", "None (enlarged projection)",
    "0, with gradients projected on degree l: (l + 1) (l + 2) >= degrees of freedom - 1",
    "for order 1 S. Berrone, A. Borio, F. Marcon, Lowest order stabilization free virtual element "
    "method for the 2D Poisson equation, arXiv 2103.16896 (2021); the same count is used above",
    nullptr },
};

constexpr std::array Constants = {
  NamedChoice<ProjectionConstant>{
    "boundary", "the mean over the boundary of the element", ProjectionConstant::BoundaryMean },
  NamedChoice<ProjectionConstant>{
    "vertex", "the mean over its vertices", ProjectionConstant::VertexMean },
};

constexpr std::array Loads = {
  NamedChoice<LoadProjection>{
    "pi0", "their L2 projections of degree order - 1", LoadProjection::LowerDegree },
  NamedChoice<LoadProjection>{
    "pinabla", "their gradient projections, for orders 1 and 2", LoadProjection::Gradient },
  NamedChoice<LoadProjection>{
    "pi0-k", "their L2 projections of the degree of the order", LoadProjection::SameDegree },
};

constexpr std::array Solvers = {
  NamedChoice<SolverKind>{
    "auto", "direct if the factor fits into memory, else iterative", SolverKind::Automatic },
  NamedChoice<SolverKind>{ "direct",
    "sparse Cholesky, or LU where there is advection or a negative reaction", SolverKind::Direct },
  NamedChoice<SolverKind>{ "iterative",
    "conjugate gradients with incomplete Cholesky, or BiCGSTAB with incomplete LU",
    SolverKind::Iterative },
};

} // namespace

std::span<const BasisRule> BasisRules()
{
  return Bases;
}

std::span<const StabilisationRule> StabilisationRules()
{
  return Stabilisations;
}

std::span<const NamedChoice<ProjectionConstant>> ProjectionConstants()
{
  return Constants;
}

std::span<const NamedChoice<LoadProjection>> LoadProjections()
{
  return Loads;
}

std::span<const NamedChoice<SolverKind>> SolverKinds()
{
  return Solvers;
}

} // namespace pemesh

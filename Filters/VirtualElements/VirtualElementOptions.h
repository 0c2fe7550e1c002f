// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The variants of the virtual element method: what a run may choose, each choice an entry of a
 * table that commands, descriptions and documents read.
 */
#ifndef pemesh_VirtualElementOptions_h
#define pemesh_VirtualElementOptions_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>

namespace pemesh
{

/** What fixes the constant of the projection at order 1; from order 2 on the mean inside does. */
enum class ProjectionConstant
{
  BoundaryMean, ///< the mean over the boundary of the element ("boundary")
  VertexMean    ///< the mean of the values at the vertices ("vertex")
};

/** The test functions that f is integrated against. */
enum class LoadProjection
{
  LowerDegree, ///< their L2 projections on the polynomials of degree k - 1 ("pi0")
  Gradient,    ///< their gradient projections, of degree k ("pinabla"); for orders 1 and 2
  SameDegree   ///< their L2 projections, of degree k ("pi0-k")
};

/** A basis of the polynomials on an element. */
struct BasisRule
{
  const char* Name;
  const char* Label;
  const char* Description;
  const char* Reference;
  bool AlongAxesOfInertia;
  bool Orthonormal;
};

/** What the weight of a degree of freedom in the stabilisation may depend on. */
struct StabilisationInput
{
  double Consistency;   ///< the diagonal entry of the consistent part of the stiffness matrix
  double MeanDiagonal;  ///< the mean of all of them
  double MeanDiffusion; ///< of the coefficient over the element
  bool OnBoundary;      ///< a value on the boundary, not a moment
};

/**
 * The stabilisation is the sum over the degrees of freedom i of Weight_i dof_i(u - Pi u) dof_i(v -
 * Pi v), with Pi the gradient projection.
 */
struct StabilisationRule
{
  const char* Name;
  const char* Label;
  const char* Formula;
  const char* Reference;
  /** Null: none. Gradients are then projected on polynomials of so high a degree that none is
   * needed. */
  double (*Weight)(const StabilisationInput& input);
};

/** How the linear system is solved. */
enum class SolverKind
{
  Automatic, ///< direct if the factor fits into memory, else iterative ("auto")
  Direct,    ///< Cholesky, or LU with advection ("direct")
  Iterative  ///< conjugate gradients, or BiCGSTAB with advection ("iterative")
};

/** A word of the command line and what it chooses. */
template <typename Value>
struct NamedChoice
{
  const char* Name;
  const char* Description;
  Value Choice;
};

PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const BasisRule> BasisRules();
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const StabilisationRule> StabilisationRules();
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const NamedChoice<ProjectionConstant>>
ProjectionConstants();
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const NamedChoice<LoadProjection>> LoadProjections();
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::span<const NamedChoice<SolverKind>> SolverKinds();

/** The entry of that name, or null. */
template <typename Entry>
const Entry* FindByName(std::span<const Entry> table, std::string_view name)
{
  for (const Entry& entry : table)
  {
    if (name == entry.Name)
    {
      return &entry;
    }
  }
  return nullptr;
}

/** The names of a table: "one, two or three". */
template <typename Entry>
std::string ListNames(std::span<const Entry> table)
{
  std::string list;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    list += i == 0 ? "" : i + 1 == table.size() ? " or " : ", ";
    list += table[i].Name;
  }
  return list;
}

inline constexpr int LargestOrder = 6;

struct VirtualElementOptions
{
  int Order = 1; ///< k, 1 … LargestOrder
  ProjectionConstant Constant = ProjectionConstant::BoundaryMean;
  LoadProjection Load = LoadProjection::LowerDegree;
  const BasisRule* Basis = &BasisRules().front();                         ///< orthonormal
  const StabilisationRule* Stabilisation = &StabilisationRules().front(); ///< dofi-dofi
  SolverKind Solver = SolverKind::Automatic;
  /**
   * Also what costs more than solving: spectral condition number, iterations of conjugate
   * gradients, conditions and checks of the elements. Else these are NaN.
   */
  bool Details = false;
};

} // namespace pemesh

#endif

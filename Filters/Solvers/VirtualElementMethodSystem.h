// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The linear system of the virtual element method: element matrices and loads, the unknowns, and
 * the sparse matrix assembled from them. Private to the module.
 */
#ifndef pemesh_VirtualElementMethodSystem_h
#define pemesh_VirtualElementMethodSystem_h

#include "SparseCholesky.h"
#include "VirtualElementMethod.h"
#include "VirtualElementMethodMesh.h"

#include <span>
#include <vector>

namespace pemesh
{

/** What the elements contribute. */
struct VirtualElementParts
{
  std::vector<std::size_t> StiffnessOffset; ///< of each element in Stiffness
  std::vector<double> Stiffness;            ///< packed lower triangles
  std::vector<double> Load;                 ///< one number a corner of an element
  std::vector<double> Diameter;             ///< one number an element

  std::span<const double> StiffnessOf(vtkIdType element) const
  {
    const std::size_t i = static_cast<std::size_t>(element);
    return { this->Stiffness.data() + this->StiffnessOffset[i],
      this->StiffnessOffset[i + 1] - this->StiffnessOffset[i] };
  }
};

/** Entry (i, j) of a packed lower triangle of a symmetric matrix. */
inline double PackedEntry(std::span<const double> packed, std::size_t i, std::size_t j)
{
  return i >= j ? packed[i * (i + 1) / 2 + j] : packed[j * (j + 1) / 2 + i];
}

VirtualElementParts ComputeElementParts(
  const VirtualElementMesh& mesh, const TestProblem& problem, const VirtualElementOptions& options);

struct VirtualElementSystem
{
  std::vector<int> Unknown;       ///< of each point; -1 where the value is known
  std::vector<vtkIdType> PointOf; ///< of each unknown
  SymmetricMatrix Matrix;
  std::vector<double> RightHandSide;
};

/** `known` holds the values at the points where they are given; the others are not looked at. */
VirtualElementSystem AssembleSystem(
  const VirtualElementMesh& mesh, const VirtualElementParts& parts, std::span<const double> known);

} // namespace pemesh

#endif

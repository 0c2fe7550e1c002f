// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The linear system of the virtual element method: element matrices and loads with the moments
 * inside eliminated, the unknowns, and the sparse matrix assembled from them. Private to the
 * module.
 */
#ifndef pemesh_VirtualElementMethodSystem_h
#define pemesh_VirtualElementMethodSystem_h

#include "DegreesOfFreedom.h"
#include "SparseMatrix.h"
#include "VirtualElementMethod.h"
#include "VirtualElementMethodMesh.h"

#include <functional>
#include <span>
#include <vector>

namespace pemesh
{

class SolveReport;

/** What the elements contribute; the moments inside are eliminated (static condensation). */
struct VirtualElementParts
{
  bool Symmetric = true;
  bool Definite = true;                  ///< no reaction, which may be negative
  std::vector<std::size_t> MatrixOffset; ///< of each element in Matrix
  std::vector<double> Matrix;            ///< packed lower triangles, or whole matrices by rows
  std::vector<double> Load;              ///< one number for each of DegreesOfFreedom::Ids
  std::vector<double> MomentLoad;        ///< of the moments, element after element
  std::vector<double> Diameter;          ///< one number an element

  /** Entry (i, j) of the matrix of an element. */
  double Entry(vtkIdType element, std::size_t i, std::size_t j, std::size_t n) const
  {
    const double* matrix = this->Matrix.data() + this->MatrixOffset[element];
    if (!this->Symmetric)
    {
      return matrix[i * n + j];
    }
    return i >= j ? matrix[i * (i + 1) / 2 + j] : matrix[j * (j + 1) / 2 + i];
  }

  /** v^T K v with the matrix of an element. */
  double Form(vtkIdType element, std::span<const double> v) const;
};

/**
 * Calls body(first, last) in parallel for the elements, and asks now and then whether to go on.
 * Throws SolveAborted where not.
 */
void ForElements(
  vtkIdType elements, SolveReport& report, const std::function<void(vtkIdType, vtkIdType)>& body);

VirtualElementParts ComputeElementParts(const VirtualElementMesh& mesh,
  const DegreesOfFreedom& dofs, const EllipticProblem& problem,
  const VirtualElementOptions& options, SolveReport& report);

struct VirtualElementSystem
{
  std::vector<int> Unknown;     ///< of each degree of freedom; -1 where the value is known
  std::vector<vtkIdType> DofOf; ///< of each unknown
  SparseMatrix Matrix;
  std::vector<double> RightHandSide;
};

/** `known` holds the values where they are given; the others are not looked at. */
VirtualElementSystem AssembleSystem(
  const DegreesOfFreedom& dofs, const VirtualElementParts& parts, std::span<const double> known);

} // namespace pemesh

#endif

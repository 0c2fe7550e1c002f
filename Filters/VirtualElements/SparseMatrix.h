// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Sparse matrices by columns, and what solves with them.
 */
#ifndef pemesh_SparseMatrix_h
#define pemesh_SparseMatrix_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

struct SparseMatrix
{
  bool Symmetric = true;                ///< then only the lower triangle is stored
  bool Definite = true;                 ///< with Symmetric: positive definite but for rounding
  std::vector<int> ColumnStart = { 0 }; ///< one more than there are columns
  std::vector<int> Row;                 ///< ascending in a column; the diagonal always there
  std::vector<double> Value;

  int Size() const { return static_cast<int>(this->ColumnStart.size()) - 1; }
};

/** The largest column sum of absolute values, of the whole matrix. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double OneNorm(const SparseMatrix& matrix);

/** How many entries the whole matrix has. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT double CountNonzeros(const SparseMatrix& matrix);

///@{
/** result = matrix x, or the transposed matrix times x. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT void Multiply(
  const SparseMatrix& matrix, std::span<const double> x, std::span<double> result);
PEMESHFILTERSVIRTUALELEMENTS_EXPORT void MultiplyTransposed(
  const SparseMatrix& matrix, std::span<const double> x, std::span<double> result);
PEMESHFILTERSVIRTUALELEMENTS_EXPORT std::vector<double> Multiply(
  const SparseMatrix& matrix, std::span<const double> x);
///@}

/** The same matrix with both triangles stored. */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT SparseMatrix WithBothTriangles(const SparseMatrix& matrix);

/** A matrix factorised, so that systems with it are quickly solved. */
class PEMESHFILTERSVIRTUALELEMENTS_EXPORT Factorization
{
public:
  virtual ~Factorization();
  virtual int Size() const = 0;

  ///@{
  /** Solves for `columns` right-hand sides, stored one after the other. */
  virtual std::vector<double> Solve(
    std::span<const double> rightHandSides, int columns = 1) const = 0;
  virtual std::vector<double> SolveTransposed(
    std::span<const double> rightHandSides, int columns = 1) const = 0;
  ///@}
};

} // namespace pemesh

#endif

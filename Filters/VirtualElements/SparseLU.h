// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Direct solution of sparse systems that are not symmetric: UMFPACK (T. A. Davis, Algorithm 832,
 * ACM Trans. Math. Softw. 30 (2004) 196-199).
 */
#ifndef pemesh_SparseLU_h
#define pemesh_SparseLU_h

#include "SparseMatrix.h"

#include <memory>

namespace pemesh
{

class PEMESHFILTERSVIRTUALELEMENTS_EXPORT SparseLU : public Factorization
{
public:
  /**
   * Factorises a matrix, which must live as long as this object. Throws std::runtime_error if it
   * is singular in double precision: a pivot is below the machine epsilon times the largest one.
   * `memoryLimit`, in bytes: throws std::bad_alloc where the estimate is above.
   */
  explicit SparseLU(const SparseMatrix& matrix, double memoryLimit);
  ~SparseLU() override;

  int Size() const override;
  std::vector<double> Solve(std::span<const double> rightHandSides, int columns = 1) const override;
  std::vector<double> SolveTransposed(
    std::span<const double> rightHandSides, int columns = 1) const override;

private:
  std::vector<double> SolveSystem(
    int system, std::span<const double> rightHandSides, int columns) const;

  struct Internals;
  std::unique_ptr<Internals> Factor;
};

} // namespace pemesh

#endif

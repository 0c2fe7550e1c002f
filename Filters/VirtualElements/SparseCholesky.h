// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Direct solution of sparse symmetric positive definite systems: CHOLMOD's supernodal Cholesky
 * factorisation (Y. Chen, T. A. Davis, W. W. Hager, S. Rajamanickam, ACM Trans. Math. Softw. 35
 * (2008) 22:1-22:14), ordered by approximate minimum degree.
 *
 * The dense kernels underneath run on one thread while a SparseCholesky works, because with more
 * their rounding would depend on the number of threads.
 */
#ifndef pemesh_SparseCholesky_h
#define pemesh_SparseCholesky_h

#include "SparseMatrix.h"

#include <limits>
#include <memory>
#include <stdexcept>

namespace pemesh
{

class NotPositiveDefinite : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class PEMESHFILTERSVIRTUALELEMENTS_EXPORT SparseCholesky : public Factorization
{
public:
  /**
   * Factorises a symmetric matrix. Throws NotPositiveDefinite if it is not positive definite in
   * double precision (singular, indefinite, or too badly conditioned), and std::bad_alloc if memory
   * does not suffice, or the factor would take more bytes than `memoryLimit`.
   */
  explicit SparseCholesky(
    const SparseMatrix& matrix, double memoryLimit = std::numeric_limits<double>::infinity());
  ~SparseCholesky() override;

  int Size() const override;
  std::vector<double> Solve(std::span<const double> rightHandSides, int columns = 1) const override;
  std::vector<double> SolveTransposed(
    std::span<const double> rightHandSides, int columns = 1) const override;

private:
  struct Internals;
  std::unique_ptr<Internals> Factor;
};

} // namespace pemesh

#endif

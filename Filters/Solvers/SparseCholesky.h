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

#include "pemeshFiltersSolversModule.h" // For export macro

#include <memory>
#include <span>
#include <vector>

namespace pemesh
{

/** The lower triangle by columns, the rows of a column ascending, the diagonal always there. */
struct SymmetricMatrix
{
  std::vector<int> ColumnStart = { 0 }; ///< one more than there are columns
  std::vector<int> Row;
  std::vector<double> Value;

  int Size() const { return static_cast<int>(this->ColumnStart.size()) - 1; }
};

/** The largest column sum of absolute values, of the whole matrix. */
PEMESHFILTERSSOLVERS_EXPORT double OneNorm(const SymmetricMatrix& matrix);

/** result = matrix x. */
PEMESHFILTERSSOLVERS_EXPORT std::vector<double> Multiply(
  const SymmetricMatrix& matrix, std::span<const double> x);

class PEMESHFILTERSSOLVERS_EXPORT SparseCholesky
{
public:
  /**
   * Factorises. Throws std::runtime_error if the matrix is not positive definite in double
   * precision (singular, indefinite, or too badly conditioned), or memory does not suffice.
   */
  explicit SparseCholesky(const SymmetricMatrix& matrix);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  int Size() const;

  /** Solves for `columns` right-hand sides, stored one after the other. */
  std::vector<double> Solve(std::span<const double> rightHandSides, int columns = 1) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Factor;
};

} // namespace pemesh

#endif

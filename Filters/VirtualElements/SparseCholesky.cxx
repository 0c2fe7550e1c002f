// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SparseCholesky.h"

#include "SingleThreadedBlas.h"

#include <cholmod.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace pemesh
{

namespace
{

// CHOLMOD's view of our arrays; it only reads them.
cholmod_sparse ViewOf(const SparseMatrix& matrix)
{
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.Size());
  view.nzmax = matrix.Row.size();
  view.p = const_cast<int*>(matrix.ColumnStart.data());
  view.i = const_cast<int*>(matrix.Row.data());
  view.x = const_cast<double*>(matrix.Value.data());
  view.stype = -1; // the lower triangle
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

// A pivot that is so much smaller than the diagonal entry it comes from has no correct digit.
constexpr double LeastPivot = 8.0 * std::numeric_limits<double>::epsilon();

// Whether all pivots are good, relative to their entries of the diagonal: unlike the ratio of the
// smallest and the largest pivot that does not mind coefficients of very different sizes.
bool HasGoodPivots(const SparseMatrix& matrix, const cholmod_factor& factor)
{
  const auto* columns = static_cast<const int*>(factor.super);
  const auto* rows = static_cast<const int*>(factor.pi);
  const auto* places = static_cast<const int*>(factor.px);
  const auto* order = static_cast<const int*>(factor.Perm);
  const auto* values = static_cast<const double*>(factor.x);
  for (std::size_t block = 0; block < factor.nsuper; ++block)
  {
    const int step = rows[block + 1] - rows[block] + 1; // from diagonal entry to diagonal entry
    for (int column = columns[block]; column < columns[block + 1]; ++column)
    {
      const double root = values[places[block] + (column - columns[block]) * step];
      // The lower triangle starts with the diagonal.
      const double entry = matrix.Value[matrix.ColumnStart[order[column]]];
      if (!(root * root > LeastPivot * entry))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

struct SparseCholesky::Internals
{
  SingleThreadedBlas Blas;
  mutable cholmod_common Common;
  cholmod_factor* Lower = nullptr;

  Internals()
  {
    cholmod_start(&this->Common);
    this->Common.print = 0;
    this->Common.error_handler = nullptr;
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = CHOLMOD_AMD;
    this->Common.postorder = 1;
  }
  ~Internals()
  {
    cholmod_free_factor(&this->Lower, &this->Common);
    cholmod_finish(&this->Common);
  }
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  void CheckStatus() const
  {
    if (this->Common.status == CHOLMOD_OUT_OF_MEMORY || this->Common.status == CHOLMOD_TOO_LARGE)
    {
      throw std::bad_alloc();
    }
    if (this->Common.status < CHOLMOD_OK)
    {
      throw std::runtime_error("The factorisation failed with CHOLMOD's error " +
        std::to_string(this->Common.status) + ".");
    }
  }
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix, double memoryLimit)
  : Factor(std::make_unique<Internals>())
{
  cholmod_common* common = &this->Factor->Common;
  cholmod_sparse view = ViewOf(matrix);
  this->Factor->Lower = cholmod_analyze(&view, common);
  this->Factor->CheckStatus();
  if (common->lnz * static_cast<double>(sizeof(double)) > memoryLimit)
  {
    throw std::bad_alloc();
  }
  cholmod_factorize(&view, this->Factor->Lower, common);
  this->Factor->CheckStatus();
  if (common->status == CHOLMOD_NOT_POSDEF || this->Factor->Lower->minor < view.ncol ||
    !HasGoodPivots(matrix, *this->Factor->Lower))
  {
    throw NotPositiveDefinite("The stiffness matrix is singular or indefinite in double precision: "
                              "an element may be flat, or the mesh not connected to its boundary.");
  }
}

SparseCholesky::~SparseCholesky() = default;

int SparseCholesky::Size() const
{
  return static_cast<int>(this->Factor->Lower->n);
}

std::vector<double> SparseCholesky::Solve(std::span<const double> rightHandSides, int columns) const
{
  const std::size_t rows = this->Factor->Lower->n;
  cholmod_dense view{};
  view.nrow = view.d = rows;
  view.ncol = static_cast<std::size_t>(columns);
  view.nzmax = rightHandSides.size();
  view.x = const_cast<double*>(rightHandSides.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  cholmod_common* common = &this->Factor->Common;
  const auto free = [common](cholmod_dense* dense) { cholmod_free_dense(&dense, common); };
  const std::unique_ptr<cholmod_dense, decltype(free)> solution(
    cholmod_solve(CHOLMOD_A, this->Factor->Lower, &view, common), free);
  this->Factor->CheckStatus();
  const double* values = static_cast<const double*>(solution->x);
  return { values, values + rightHandSides.size() };
}

std::vector<double> SparseCholesky::SolveTransposed(
  std::span<const double> rightHandSides, int columns) const
{
  return this->Solve(rightHandSides, columns);
}

} // namespace pemesh

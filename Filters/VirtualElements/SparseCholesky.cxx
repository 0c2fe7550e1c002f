// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SparseCholesky.h"

#include "SingleThreadedBlas.h"

#include <cholmod.h>

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
    !(cholmod_rcond(this->Factor->Lower, common) > 0.0))
  {
    throw std::runtime_error("The stiffness matrix is singular or indefinite in double precision: "
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

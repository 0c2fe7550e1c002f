// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SparseCholesky.h"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

// There when the BLAS below CHOLMOD is OpenBLAS, null when it is another (the reference BLAS has
// no threads).
extern "C"
{
  void openblas_set_num_threads(int) __attribute__((weak));
  int openblas_get_num_threads(void) __attribute__((weak));
}

namespace pemesh
{

namespace
{

// One thread for the BLAS while any object of this class lives; then as many as there were.
class SingleThreadedBlas
{
public:
  SingleThreadedBlas()
  {
    const std::scoped_lock lock(Mutex);
    if (Users++ == 0 && openblas_get_num_threads && openblas_set_num_threads)
    {
      Threads = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }
  ~SingleThreadedBlas()
  {
    const std::scoped_lock lock(Mutex);
    if (--Users == 0 && openblas_get_num_threads && openblas_set_num_threads)
    {
      openblas_set_num_threads(Threads);
    }
  }
  SingleThreadedBlas(const SingleThreadedBlas&) = delete;
  SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;

private:
  static inline std::mutex Mutex;
  static inline int Users = 0;
  static inline int Threads = 1;
};

// CHOLMOD's view of our arrays; it only reads them.
cholmod_sparse ViewOf(const SymmetricMatrix& matrix)
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

double OneNorm(const SymmetricMatrix& matrix)
{
  std::vector<double> sums(matrix.Size(), 0.0);
  for (int column = 0; column < matrix.Size(); ++column)
  {
    for (int k = matrix.ColumnStart[column]; k < matrix.ColumnStart[column + 1]; ++k)
    {
      sums[column] += std::abs(matrix.Value[k]);
      if (matrix.Row[k] != column)
      {
        sums[matrix.Row[k]] += std::abs(matrix.Value[k]);
      }
    }
  }
  return sums.empty() ? 0.0 : *std::max_element(sums.begin(), sums.end());
}

std::vector<double> Multiply(const SymmetricMatrix& matrix, std::span<const double> x)
{
  std::vector<double> result(matrix.Size(), 0.0);
  for (int column = 0; column < matrix.Size(); ++column)
  {
    for (int k = matrix.ColumnStart[column]; k < matrix.ColumnStart[column + 1]; ++k)
    {
      const int row = matrix.Row[k];
      result[row] += matrix.Value[k] * x[column];
      if (row != column)
      {
        result[column] += matrix.Value[k] * x[row];
      }
    }
  }
  return result;
}

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
      throw std::runtime_error(
        "The system does not fit into memory: a mesh with fewer vertices is needed.");
    }
    if (this->Common.status < CHOLMOD_OK)
    {
      throw std::runtime_error("The factorisation failed with CHOLMOD's error " +
        std::to_string(this->Common.status) + ".");
    }
  }
};

SparseCholesky::SparseCholesky(const SymmetricMatrix& matrix)
  : Factor(std::make_unique<Internals>())
{
  cholmod_common* common = &this->Factor->Common;
  cholmod_sparse view = ViewOf(matrix);
  this->Factor->Lower = cholmod_analyze(&view, common);
  this->Factor->CheckStatus();
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
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, this->Factor->Lower, &view, common);
  this->Factor->CheckStatus();
  const double* values = static_cast<const double*>(solution->x);
  std::vector<double> result(values, values + rightHandSides.size());
  cholmod_free_dense(&solution, common);
  return result;
}

} // namespace pemesh

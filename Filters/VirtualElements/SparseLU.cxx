// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SparseLU.h"

#include "SingleThreadedBlas.h"

#include <umfpack.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace pemesh
{

struct SparseLU::Internals
{
  SingleThreadedBlas Blas;
  SparseMatrix Full; // where both triangles have to be made
  const SparseMatrix& Matrix;
  double Control[UMFPACK_CONTROL];
  void* Symbolic = nullptr;
  void* Numeric = nullptr;

  explicit Internals(const SparseMatrix& matrix)
    : Full(matrix.Symmetric ? WithBothTriangles(matrix) : SparseMatrix())
    , Matrix(matrix.Symmetric ? this->Full : matrix)
  {
    umfpack_di_defaults(this->Control);
  }
  ~Internals()
  {
    umfpack_di_free_symbolic(&this->Symbolic);
    umfpack_di_free_numeric(&this->Numeric);
  }
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;
};

namespace
{

void CheckStatus(int status)
{
  switch (status)
  {
    case UMFPACK_OK:
      return;
    case UMFPACK_WARNING_singular_matrix:
      throw std::runtime_error("The matrix of the system is singular in double precision: an "
                               "element may be flat, or the mesh not connected to its boundary.");
    case UMFPACK_ERROR_out_of_memory:
      throw std::bad_alloc();
    default:
      throw std::runtime_error(
        "The factorisation failed with UMFPACK's error " + std::to_string(status) + ".");
  }
}

} // namespace

SparseLU::SparseLU(const SparseMatrix& any, double memoryLimit)
  : Factor(std::make_unique<Internals>(any))
{
  double info[UMFPACK_INFO];
  const SparseMatrix& matrix = this->Factor->Matrix;
  const int n = matrix.Size();
  CheckStatus(umfpack_di_symbolic(n, n, matrix.ColumnStart.data(), matrix.Row.data(),
    matrix.Value.data(), &this->Factor->Symbolic, this->Factor->Control, info));
  if (info[UMFPACK_PEAK_MEMORY_ESTIMATE] * info[UMFPACK_SIZE_OF_UNIT] > memoryLimit)
  {
    throw std::bad_alloc();
  }
  CheckStatus(umfpack_di_numeric(matrix.ColumnStart.data(), matrix.Row.data(), matrix.Value.data(),
    this->Factor->Symbolic, &this->Factor->Numeric, this->Factor->Control, info));
  // UMFPACK itself warns only of a pivot that is exactly zero.
  if (!(info[UMFPACK_RCOND] > std::numeric_limits<double>::epsilon()))
  {
    CheckStatus(UMFPACK_WARNING_singular_matrix);
  }
}

SparseLU::~SparseLU() = default;

int SparseLU::Size() const
{
  return this->Factor->Matrix.Size();
}

std::vector<double> SparseLU::Solve(std::span<const double> rightHandSides, int columns) const
{
  return this->SolveSystem(UMFPACK_A, rightHandSides, columns);
}

std::vector<double> SparseLU::SolveTransposed(
  std::span<const double> rightHandSides, int columns) const
{
  return this->SolveSystem(UMFPACK_At, rightHandSides, columns);
}

std::vector<double> SparseLU::SolveSystem(
  int system, std::span<const double> rightHandSides, int columns) const
{
  const SparseMatrix& matrix = this->Factor->Matrix;
  std::vector<double> result(rightHandSides.size());
  double info[UMFPACK_INFO];
  for (int column = 0; column < columns; ++column)
  {
    const std::size_t first = static_cast<std::size_t>(column) * this->Size();
    CheckStatus(umfpack_di_solve(system, matrix.ColumnStart.data(), matrix.Row.data(),
      matrix.Value.data(), result.data() + first, rightHandSides.data() + first,
      this->Factor->Numeric, this->Factor->Control, info));
  }
  return result;
}

} // namespace pemesh

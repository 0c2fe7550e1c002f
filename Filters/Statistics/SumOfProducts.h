// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Sums of products of two samples.
 */
#ifndef pemesh_SumOfProducts_h
#define pemesh_SumOfProducts_h

#include <cstddef>
#include <span>

namespace pemesh
{

/** In a fixed order, four sums at a time: quick, and the same bits everywhere. */
inline double SumOfProducts(std::span<const double> u, std::span<const double> v)
{
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  const std::size_t whole = u.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      sums[k] += u[i + k] * v[i + k];
    }
  }
  for (std::size_t i = whole; i < u.size(); ++i)
  {
    sums[0] += u[i] * v[i];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace pemesh

#endif

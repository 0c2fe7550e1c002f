// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random numbers that are the same on every platform: the distributions of the standard library
 * are not.
 */
#ifndef pemesh_RandomNumbers_h
#define pemesh_RandomNumbers_h

#include <cstdint>
#include <random>

namespace pemesh
{

class RandomNumbers
{
public:
  /** `seed` is an integer from 0 to 2^53. */
  explicit RandomNumbers(double seed)
    : Engine(static_cast<std::uint64_t>(seed))
  {
  }

  /** Uniform in [0, 1). */
  double Fraction() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

  /** Uniform in [-1, 1). */
  double Signed() { return 2.0 * this->Fraction() - 1.0; }

private:
  std::mt19937_64 Engine;
};

} // namespace pemesh

#endif

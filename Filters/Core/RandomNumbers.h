// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random numbers that are the same bits everywhere: the standard defines std::mt19937_64 to the
 * bit, but not what its distributions make of it.
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
  explicit RandomNumbers(std::uint64_t seed)
    : Engine(seed)
  {
  }

  /** In [0, 1), a multiple of 2^-53. */
  double Uniform() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

  double Between(double low, double high) { return low + this->Uniform() * (high - low); }

  /** In [-1, 1). */
  double Signed() { return 2.0 * this->Uniform() - 1.0; }

  /** 0 to count - 1. */
  int Below(int count) { return static_cast<int>(this->Uniform() * count); }

private:
  std::mt19937_64 Engine;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Study documents drawn at random: one table of draws, each of which sets some keys.
 */
#ifndef pemesh_RandomStudy_h
#define pemesh_RandomStudy_h

#include <nlohmann/json.hpp>

#include <cstdint>
#include <random>

/** The same numbers for the same seed, everywhere. */
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : Bits(seed)
  {
  }

  /** From `low` to `high`. */
  double Real(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Bits() >> 11) * 0x1p-53);
  }
  /** 0 to count - 1. */
  int Integer(int count)
  {
    return static_cast<int>(((this->Bits() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
  }
  /** True once in `count` times. */
  bool OneIn(int count) { return this->Integer(count) == 0; }

private:
  std::mt19937_64 Bits;
};

/** The document of a seed: every draw of the table, in its order. */
nlohmann::ordered_json DrawStudy(std::uint64_t seed);

#endif

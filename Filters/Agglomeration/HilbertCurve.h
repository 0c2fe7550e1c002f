// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where a point lies along a curve that keeps neighbours together.
 *
 * Reference: D. Hilbert, Ueber die stetige Abbildung einer Linie auf ein Flaechenstueck,
 * Mathematische Annalen 38 (1891) 459-460, doi:10.1007/BF01199431.
 */
#ifndef pemesh_HilbertCurve_h
#define pemesh_HilbertCurve_h

#include <cstdint>

namespace pemesh
{

/** The place of cell (x, y) of 2^31 x 2^31 cells along the curve. */
inline std::uint64_t HilbertKey(std::uint32_t x, std::uint32_t y)
{
  constexpr std::uint32_t Mask = 0x7fffffffU;
  std::uint64_t key = 0;
  for (int level = 30; level >= 0; --level)
  {
    const std::uint32_t right = (x >> level) & 1U;
    const std::uint32_t upper = (y >> level) & 1U;
    // Quadrants in the order lower left, upper left, upper right, lower right.
    key = key << 2 | ((3U * right) ^ upper);
    // The first and the last quadrant hold the curve mirrored in a diagonal. Without a branch,
    // which would be mispredicted every other time.
    const std::uint32_t isMirrored = upper - 1U; // all bits, or none
    const std::uint32_t swapped = (x ^ y) & isMirrored;
    const std::uint32_t flipped = (0U - right) & isMirrored & Mask;
    x ^= swapped ^ flipped;
    y ^= swapped ^ flipped;
  }
  return key;
}

} // namespace pemesh

#endif

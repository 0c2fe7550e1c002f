// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Functions are evaluated at several points at once, which lets the processor do so too.
 */
#ifndef pemesh_PointBlock_h
#define pemesh_PointBlock_h

#include <array>
#include <cstddef>

namespace pemesh
{

inline constexpr std::size_t PointBlockSize = 8;
using BlockOfNumbers = std::array<double, PointBlockSize>;

struct PointBlock
{
  BlockOfNumbers X{};
  BlockOfNumbers Y{};
};

} // namespace pemesh

#endif

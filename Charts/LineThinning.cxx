// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LineThinning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pemesh
{

void ThinLine(std::vector<float>& points, double columnWidth)
{
  constexpr std::size_t few = 1000;
  const std::size_t count = points.size() / 2;
  if (count < few)
  {
    return;
  }
  const auto columnOf = [&](std::size_t i) { return std::floor(points[2 * i] / columnWidth); };
  std::vector<float> kept;
  for (std::size_t first = 0; first < count;)
  {
    std::size_t low = first;
    std::size_t high = first;
    std::size_t last = first;
    for (std::size_t i = first; i < count && columnOf(i) == columnOf(first); ++i)
    {
      low = points[2 * i + 1] < points[2 * low + 1] ? i : low;
      high = points[2 * i + 1] > points[2 * high + 1] ? i : high;
      last = i;
    }
    std::array<std::size_t, 4> chosen = { first, low, high, last };
    std::sort(chosen.begin(), chosen.end());
    const auto* end = std::unique(chosen.begin(), chosen.end());
    for (const auto* i = chosen.begin(); i != end; ++i)
    {
      kept.insert(kept.end(), { points[2 * *i], points[2 * *i + 1] });
    }
    first = last + 1;
  }
  points = std::move(kept);
}

} // namespace pemesh

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

std::vector<float> StripOfLine(
  const std::vector<float>& points, double columnWidth, double halfWidth)
{
  constexpr std::size_t few = 4000;
  constexpr std::size_t dense = 8; // points a column
  const std::size_t count = points.size() / 2;
  const auto columnOf = [&](std::size_t i) { return std::floor(points[2 * i] / columnWidth); };
  const bool isLong =
    count >= few && count > dense * (std::fabs(columnOf(count - 1) - columnOf(0)) + 1.0);
  std::vector<float> strip;
  for (std::size_t first = 0; isLong && first < count;)
  {
    const double column = columnOf(first);
    float low = points[2 * first + 1];
    float high = low;
    if (first > 0)
    {
      // The way from the last column is shared by both.
      const float middle = 0.5F * (points[2 * first - 1] + low);
      low = std::min(low, middle);
      high = std::max(high, middle);
    }
    const auto left = static_cast<float>(column * columnWidth);
    const auto right = static_cast<float>((column + 1.0) * columnWidth);
    // Compared with the ends of the column first, because a division a point takes most of the
    // time.
    const auto isIn = [&](std::size_t at)
    { return (points[2 * at] >= left && points[2 * at] < right) || columnOf(at) == column; };
    std::size_t i = first + 1;
    for (; i < count && isIn(i); ++i)
    {
      low = std::min(low, points[2 * i + 1]);
      high = std::max(high, points[2 * i + 1]);
    }
    if (i < count)
    {
      if (std::fabs(columnOf(i) - column) != 1.0 ||
        (columnOf(i) > column) != (columnOf(count - 1) > column))
      {
        return {}; // a gap, or a way back
      }
      const float middle = 0.5F * (points[2 * i - 1] + points[2 * i + 1]);
      low = std::min(low, middle);
      high = std::max(high, middle);
    }
    const auto x = static_cast<float>((column + 0.5) * columnWidth);
    strip.insert(strip.end(),
      { x, low - static_cast<float>(halfWidth), x, high + static_cast<float>(halfWidth) });
    first = i;
  }
  return strip;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTree.h"

#include <cstdint>

namespace pemesh
{

namespace
{

/** The lower 32 bits with a gap before each. */
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | (bits << 16)) & 0x0000FFFF0000FFFFU;
  bits = (bits | (bits << 8)) & 0x00FF00FF00FF00FFU;
  bits = (bits | (bits << 4)) & 0x0F0F0F0F0F0F0F0FU;
  bits = (bits | (bits << 2)) & 0x3333333333333333U;
  return (bits | (bits << 1)) & 0x5555555555555555U;
}

std::uint64_t Quantize(double value, double low, double high)
{
  const double fraction = high > low ? (value - low) / (high - low) : 0.0;
  // False for NaN, after an overflow: the order is worse then, the answers are the same.
  return fraction > 0.0 ? static_cast<std::uint64_t>(std::min(fraction, 1.0) * 4294967295.0) : 0;
}

struct Key
{
  std::uint64_t Code;
  std::size_t Index;

  friend bool operator<(const Key& a, const Key& b)
  {
    return a.Code < b.Code || (a.Code == b.Code && a.Index < b.Index);
  }
};

std::vector<Key> SortAlongCurve(const std::vector<std::pair<int, Box>>& items)
{
  Box all = items[0].second;
  for (const auto& [item, box] : items)
  {
    all.Add(box);
  }
  std::vector<Key> keys(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    const Box& box = items[i].second;
    const std::uint64_t column = Quantize(0.5 * box.West + 0.5 * box.East, all.West, all.East);
    const std::uint64_t row = Quantize(0.5 * box.South + 0.5 * box.North, all.South, all.North);
    keys[i] = { Spread(column) | (Spread(row) << 1), i };
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

} // namespace

BoxTree::BoxTree(std::vector<std::pair<int, Box>> items)
{
  if (items.empty())
  {
    return;
  }
  this->Levels.emplace_back();
  for (const Key& key : SortAlongCurve(items))
  {
    this->Items.push_back(items[key.Index].first);
    this->Levels[0].push_back(items[key.Index].second);
  }
  while (this->Levels.back().size() > Children)
  {
    const std::vector<Box>& below = this->Levels.back();
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      if (i % Children == 0)
      {
        boxes.push_back(below[i]);
      }
      else
      {
        boxes.back().Add(below[i]);
      }
    }
    this->Levels.push_back(std::move(boxes));
  }
}

} // namespace pemesh

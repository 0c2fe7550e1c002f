// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SegmentGrid.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

/** The x of a segment between two heights, as an interval; both bounds within the segment's. */
std::pair<double, double> WidthBetween(const Segment& segment, double low, double high)
{
  const double dy = segment.To.y - segment.From.y;
  const auto at = [&](double y)
  {
    const double share = std::clamp((y - segment.From.y) / dy, 0.0, 1.0);
    return segment.From.x + share * (segment.To.x - segment.From.x);
  };
  const auto all = std::minmax(segment.From.x, segment.To.x);
  if (std::abs(dy) <= high - low) // as flat as a row: no need to be more precise
  {
    return all;
  }
  const double a = at(low);
  const double b = at(high);
  return { std::min(a, b), std::max(a, b) };
}

} // namespace

SegmentGrid::SegmentGrid(const std::vector<Segment>& segments, double margin, double buckets)
{
  Point2 high = segments[0].From;
  this->Low = high;
  for (const Segment& segment : segments)
  {
    for (const Point2& end : { segment.From, segment.To })
    {
      this->Low = { std::min(this->Low.x, end.x), std::min(this->Low.y, end.y) };
      high = { std::max(high.x, end.x), std::max(high.y, end.y) };
    }
  }
  this->Low = { this->Low.x - 2.0 * margin, this->Low.y - 2.0 * margin };
  const double width = high.x + 2.0 * margin - this->Low.x;
  const double height = high.y + 2.0 * margin - this->Low.y;
  const double most = std::clamp(buckets, 1.0, 1e8);
  this->Side = std::max(std::sqrt(width * height / most), std::max(width, height) / most);
  this->Columns = static_cast<int>(width / this->Side) + 1;
  this->Rows = static_cast<int>(height / this->Side) + 1;

  this->First.assign(static_cast<std::size_t>(this->Columns) * this->Rows + 1, 0);
  for (const Segment& segment : segments)
  {
    this->ForBuckets(segment, margin, [this](std::size_t bucket) { ++this->First[bucket + 1]; });
  }
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Entries.resize(this->First.back());
  std::vector<int> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    this->ForBuckets(segments[i], margin,
      [this, &next, i](std::size_t bucket)
      { this->Entries[next[bucket]++] = static_cast<int>(i); });
  }
}

template <typename Visitor>
void SegmentGrid::ForBuckets(const Segment& segment, double distance, const Visitor& visit) const
{
  const auto [south, north] = std::minmax(segment.From.y, segment.To.y);
  const double firstRow = std::floor((south - distance - this->Low.y) / this->Side);
  const double lastRow = std::floor((north + distance - this->Low.y) / this->Side);
  if (lastRow < 0.0 || firstRow >= this->Rows)
  {
    return;
  }
  const int last = static_cast<int>(std::min(lastRow, this->Rows - 1.0));
  for (int row = static_cast<int>(std::max(firstRow, 0.0)); row <= last; ++row)
  {
    // A hundredth of a row more on either side covers the rounding of its bounds.
    const double low = this->Low.y + (row - 0.01) * this->Side - distance;
    const double high = this->Low.y + (row + 1.01) * this->Side + distance;
    const auto [west, east] = WidthBetween(segment, low, high);
    const double firstColumn = std::floor((west - distance - this->Low.x) / this->Side - 0.01);
    const double lastColumn = std::floor((east + distance - this->Low.x) / this->Side + 0.01);
    if (lastColumn < 0.0 || firstColumn >= this->Columns)
    {
      continue;
    }
    const int lastOfRow = static_cast<int>(std::min(lastColumn, this->Columns - 1.0));
    for (int column = static_cast<int>(std::max(firstColumn, 0.0)); column <= lastOfRow; ++column)
    {
      visit(static_cast<std::size_t>(row) * this->Columns + column);
    }
  }
}

const std::vector<int>& SegmentGrid::FindNear(const Segment& segment)
{
  this->Found.clear();
  this->ForBuckets(segment, 0.0,
    [this](std::size_t bucket)
    {
      this->Found.insert(this->Found.end(), this->Entries.begin() + this->First[bucket],
        this->Entries.begin() + this->First[bucket + 1]);
    });
  if (this->Found.size() > 1)
  {
    std::sort(this->Found.begin(), this->Found.end());
    this->Found.erase(std::unique(this->Found.begin(), this->Found.end()), this->Found.end());
  }
  return this->Found;
}

} // namespace pemesh

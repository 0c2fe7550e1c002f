// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomSites.h"

#include "DomainLocator.h"
#include "RandomNumbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

namespace pemesh
{

namespace
{

/** Finds points nearer than a distance, by buckets not smaller than that distance. */
class NeighborSearch
{
public:
  NeighborSearch(const Box& bounds, int count, double distance)
    : Bounds(bounds)
    , Distance(distance)
  {
    const double side =
      std::max(distance, std::sqrt(bounds.Width() * bounds.Height() / static_cast<double>(count)));
    this->Columns = static_cast<int>(std::clamp(bounds.Width() / side, 1.0, double(count)));
    this->Rows = static_cast<int>(std::clamp(bounds.Height() / side, 1.0, double(count)));
    this->Newest.assign(static_cast<std::size_t>(this->Columns) * this->Rows, -1);
  }

  bool IsFree(const Point2& point, const std::vector<Point2>& points) const
  {
    const auto [column, row] = this->BucketOf(point);
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, this->Rows - 1); ++j)
    {
      for (int i = std::max(column - 1, 0); i <= std::min(column + 1, this->Columns - 1); ++i)
      {
        for (int other = this->Newest[this->Number(i, j)]; other >= 0; other = this->Older[other])
        {
          const double dx = points[other].x - point.x;
          const double dy = points[other].y - point.y;
          if (dx * dx + dy * dy < this->Distance * this->Distance)
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** Points are added in the order of their numbers. */
  void Add(const Point2& point)
  {
    const auto [column, row] = this->BucketOf(point);
    int& newest = this->Newest[this->Number(column, row)];
    this->Older.push_back(newest);
    newest = static_cast<int>(this->Older.size()) - 1;
  }

private:
  std::pair<int, int> BucketOf(const Point2& point) const
  {
    const auto place = [](double at, double low, double length, int buckets)
    { return std::clamp(static_cast<int>((at - low) / length * buckets), 0, buckets - 1); };
    return { place(point.x, this->Bounds.Low.x, this->Bounds.Width(), this->Columns),
      place(point.y, this->Bounds.Low.y, this->Bounds.Height(), this->Rows) };
  }
  std::size_t Number(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->Columns + column;
  }

  Box Bounds;
  double Distance;
  int Columns = 1;
  int Rows = 1;
  std::vector<int> Newest; ///< a bucket each: its newest point, -1 if there is none
  std::vector<int> Older;  ///< a point each: the next older one of its bucket
};

/** The place of a point on Hilbert's curve through a grid of 2^16 by 2^16. */
std::uint32_t HilbertIndex(std::uint32_t x, std::uint32_t y)
{
  std::uint32_t index = 0;
  for (std::uint32_t side = 1U << 15; side > 0; side /= 2)
  {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0;
    const std::uint32_t upper = (y & side) != 0 ? 1 : 0;
    index = index * 4 + ((3 * right) ^ upper);
    if (upper == 0) // the quarters at the ends of the curve are turned
    {
      if (right == 1)
      {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

void SortAlongHilbertCurve(const Box& bounds, std::vector<Point2>& points)
{
  const double scale = 65536.0 / std::max(bounds.Width(), bounds.Height());
  const auto place = [scale](double at, double low)
  { return static_cast<std::uint32_t>(std::clamp((at - low) * scale, 0.0, 65535.0)); };
  std::vector<std::pair<std::uint32_t, int>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    keys[i] = { HilbertIndex(place(points[i].x, bounds.Low.x), place(points[i].y, bounds.Low.y)),
      static_cast<int>(i) };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Point2> sorted(points.size());
  std::transform(keys.begin(), keys.end(), sorted.begin(),
    [&points](const auto& key) { return points[key.second]; });
  points.swap(sorted);
}

} // namespace

std::string RandomSites(
  const Domain& domain, int count, double spacing, double seed, std::vector<Point2>& sites)
{
  constexpr int MostMisses = 1000000; // in a row
  const DomainLocator locator(domain);
  const Box bounds = BoxOf(domain);
  const double distance =
    spacing * std::sqrt(2.0 / std::numbers::sqrt3 * DomainArea(domain) / count);
  NeighborSearch neighbors(bounds, count, distance);
  RandomNumbers random(static_cast<std::uint64_t>(seed));
  sites.clear();
  sites.reserve(static_cast<std::size_t>(count));
  for (int misses = 0; static_cast<int>(sites.size()) < count;)
  {
    const double x = bounds.Low.x + bounds.Width() * random.Uniform();
    const double y = bounds.Low.y + bounds.Height() * random.Uniform();
    if (locator.Contains({ x, y }) && (spacing == 0.0 || neighbors.IsFree({ x, y }, sites)))
    {
      sites.push_back({ x, y });
      neighbors.Add(sites.back());
      misses = 0;
    }
    else if (++misses == MostMisses)
    {
      return "Only " + std::to_string(sites.size()) + " of " + std::to_string(count) +
        " random points found a place in the domain; ask for fewer cells or a smaller spacing.";
    }
  }
  SortAlongHilbertCurve(bounds, sites);
  return {};
}

} // namespace pemesh

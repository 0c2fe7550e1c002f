// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointDistances.h"

#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pemesh
{

namespace
{

constexpr std::size_t SmallSet = 48; // up to here all pairs are faster than sorting

double SquaredDistance(const Point2& a, const Point2& b)
{
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  return x * x + y * y;
}

PointPair WithDistance(PolygonView points, std::size_t first, std::size_t second)
{
  return { first, second, std::sqrt(SquaredDistance(points[first], points[second])) };
}

std::vector<std::size_t> SortedByX(PolygonView points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [points](std::size_t a, std::size_t b)
    {
      const Point2& p = points[a];
      const Point2& q = points[b];
      return p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && a < b)));
    });
  return order;
}

/** Indices of the strictly convex hull, counter-clockwise (A. M. Andrew's monotone chain, 1979). */
std::vector<std::size_t> ConvexHull(PolygonView points)
{
  const std::vector<std::size_t> order = SortedByX(points);
  std::vector<std::size_t> hull;
  const auto AddChain = [&](auto begin, auto end)
  {
    const std::size_t base = hull.size();
    for (auto it = begin; it != end; ++it)
    {
      while (hull.size() >= base + 2 &&
        Orientation(points[hull[hull.size() - 2]], points[hull.back()], points[*it]) <= 0)
      {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  AddChain(order.begin(), order.end());
  AddChain(order.rbegin(), order.rend());
  return hull;
}

PointPair FarthestByComparison(PolygonView points)
{
  double largest = -1.0;
  std::size_t first = 0;
  std::size_t second = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      const double squared = SquaredDistance(points[i], points[j]);
      if (squared > largest)
      {
        largest = squared;
        first = i;
        second = j;
      }
    }
  }
  return WithDistance(points, first, second);
}

/** For each edge of the hull the vertex farthest from it; the farthest pair is among these. */
PointPair FarthestByCalipers(PolygonView points)
{
  const std::vector<std::size_t> hull = ConvexHull(points);
  const std::size_t size = hull.size();
  if (size < 4)
  {
    std::vector<Point2> corners;
    for (const std::size_t id : hull)
    {
      corners.push_back(points[id]);
    }
    const PointPair pair = FarthestByComparison(corners);
    return size < 2 ? WithDistance(points, 0, 0)
                    : WithDistance(points, hull[pair.First], hull[pair.Second]);
  }
  double largest = -1.0;
  PointPair best;
  std::size_t j = 1;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& a = points[hull[i]];
    const Point2& b = points[hull[(i + 1) % size]];
    // Along the edge (not from a to the vertices), so that vertices close together cannot stall it.
    const auto Rises = [&](std::size_t k)
    {
      const Point2& p = points[hull[k % size]];
      const Point2& q = points[hull[(k + 1) % size]];
      return (b.x - a.x) * (q.y - p.y) - (b.y - a.y) * (q.x - p.x) > 0.0;
    };
    j = std::max(j, i + 1);
    while (j < i + size && Rises(j))
    {
      ++j;
    }
    // The neighbours are tried too, so that a tie cannot hide a pair.
    for (const std::size_t k : { j - 1, j, j + 1 })
    {
      for (const std::size_t l : { i, i + 1 })
      {
        const std::size_t first = hull[l % size];
        const std::size_t second = hull[k % size];
        const double squared = SquaredDistance(points[first], points[second]);
        if (squared > largest)
        {
          largest = squared;
          best = { first, second, 0.0 };
        }
      }
    }
  }
  return WithDistance(points, best.First, best.Second);
}

} // namespace

PointPair FarthestPair(PolygonView points)
{
  if (points.empty())
  {
    return { 0, 0, std::numeric_limits<double>::quiet_NaN() };
  }
  return points.size() <= SmallSet ? FarthestByComparison(points) : FarthestByCalipers(points);
}

DistanceRange MeasureDistances(PolygonView points)
{
  if (points.size() < 2 || points.size() > SmallSet)
  {
    return { FarthestPair(points), ClosestPair(points).Distance };
  }
  double least = std::numeric_limits<double>::infinity();
  double largest = -1.0;
  std::size_t first = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    // Without branches inside: which pair is next to be the closest or farthest is pure chance.
    double farthest = 0.0;
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      const double squared = SquaredDistance(points[i], points[j]);
      farthest = std::max(farthest, squared);
      least = std::min(least, squared);
    }
    first = farthest > largest ? i : first;
    largest = std::max(largest, farthest);
  }
  std::size_t second = first + 1;
  while (second + 1 < points.size() && SquaredDistance(points[first], points[second]) != largest)
  {
    ++second;
  }
  return { WithDistance(points, first, second), std::sqrt(least) };
}

double Diameter(PolygonView points)
{
  return FarthestPair(points).Distance;
}

PointPair ClosestPair(PolygonView points)
{
  if (points.size() < 2)
  {
    return { 0, 0, std::numeric_limits<double>::quiet_NaN() };
  }
  std::vector<std::size_t> order;
  if (points.size() > SmallSet)
  {
    order = SortedByX(points);
  }
  const auto At = [&](std::size_t i) { return order.empty() ? i : order[i]; };
  double least = std::numeric_limits<double>::infinity();
  PointPair best;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2& p = points[At(i)];
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      const Point2& q = points[At(j)];
      if (!order.empty() && (q.x - p.x) * (q.x - p.x) >= least)
      {
        break; // all that follow are farther still in x
      }
      const double squared = SquaredDistance(p, q);
      if (squared < least)
      {
        least = squared;
        best = { At(i), At(j), 0.0 };
      }
    }
  }
  return WithDistance(points, best.First, best.Second);
}

} // namespace pemesh

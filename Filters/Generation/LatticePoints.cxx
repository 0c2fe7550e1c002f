// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatticePoints.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

/** Area of a lattice triangle over the area allowed. */
constexpr double AreaShare = 0.9;

/**
 * How far each coordinate is shaken, in edges: three vertices change the area of their triangle by
 * no more than 3 * 0.02 * sqrt(2) / (sqrt(3) / 2), that is 9.8 %, so it stays below the bound.
 */
constexpr double Shake = 0.02;

/**
 * Distance kept from the boundary, in edges. Tried from 0.6 to 1.1: the fewer points near preserved
 * edges, the fewer flat triangles remain there, and the mesh is hardly larger.
 */
constexpr double Clearance = 1.1;

struct Interval
{
  double From = std::numeric_limits<double>::infinity();
  double To = -std::numeric_limits<double>::infinity();

  void Add(double x)
  {
    this->From = std::min(this->From, x);
    this->To = std::max(this->To, x);
  }
};

/** An interval, or a crossing of the boundary, on a row of the lattice. */
struct OnRow
{
  std::int64_t Row;
  Interval Place;

  bool operator<(const OnRow& other) const
  {
    return this->Row < other.Row || (this->Row == other.Row && this->Place.From < other.Place.From);
  }
};

struct Node
{
  std::uint64_t Key; ///< its place on the Hilbert curve
  std::uint32_t Row;
  std::uint32_t Column;
};

class Lattice
{
public:
  Lattice(const std::vector<Point2>& points, double maximumArea)
  {
    this->Low = this->High = points.front();
    for (const Point2& point : points)
    {
      this->Low = { std::min(this->Low.x, point.x), std::min(this->Low.y, point.y) };
      this->High = { std::max(this->High.x, point.x), std::max(this->High.y, point.y) };
    }
    this->Edge = 2.0 * std::sqrt(AreaShare * maximumArea / std::numbers::sqrt3);
    this->RowHeight = 0.5 * std::numbers::sqrt3 * this->Edge;
  }

  double HeightOf(std::int64_t row) const
  {
    return this->Low.y + this->RowHeight * static_cast<double>(row);
  }
  double FirstOn(std::int64_t row) const
  {
    return this->Low.x + (row % 2 == 0 ? 0.0 : 0.5 * this->Edge);
  }
  /** The first row that is not below y. */
  std::int64_t RowAbove(double y) const
  {
    return static_cast<std::int64_t>(std::ceil((y - this->Low.y) / this->RowHeight));
  }

  /** The node, shaken: always the same way (splitmix64 of its numbers). */
  Point2 At(const Node& node) const
  {
    std::uint64_t bits =
      (static_cast<std::uint64_t>(node.Row) << 32 | node.Column) + 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31;
    const double x = static_cast<double>(bits >> 32) * 0x1p-31 - 1.0;
    const double y = static_cast<double>(bits & 0xffffffffU) * 0x1p-31 - 1.0;
    return { this->FirstOn(node.Row) + (node.Column + Shake * x) * this->Edge,
      this->HeightOf(node.Row) + Shake * this->Edge * y };
  }

  Point2 Low, High;
  double Edge;
  double RowHeight;
};

/** The x for which (x, y) is no farther than the radius from the segment; empty if there are none.
 */
Interval NearSegment(const Point2& from, const Point2& to, double radius, double y)
{
  Interval near;
  for (const Point2& end : { from, to })
  {
    const double squared = radius * radius - (y - end.y) * (y - end.y);
    if (squared >= 0.0)
    {
      near.Add(end.x - std::sqrt(squared));
      near.Add(end.x + std::sqrt(squared));
    }
  }
  const double factor = radius / std::sqrt(SquaredDistance(from, to));
  const Point2 normal = { factor * (from.y - to.y), factor * (to.x - from.x) };
  for (const double side : { -1.0, 1.0 })
  {
    const double fromY = from.y + side * normal.y;
    const double toY = to.y + side * normal.y;
    if (std::min(fromY, toY) <= y && y <= std::max(fromY, toY) && fromY != toY)
    {
      near.Add(from.x + side * normal.x + (to.x - from.x) * (y - fromY) / (toY - fromY));
    }
  }
  return near;
}

/** What of the boundary lies on and near the rows. */
struct Rows
{
  std::vector<OnRow> Crossings;
  std::vector<OnRow> Forbidden;
};

/** False if there would be more crossings than that. */
bool FindRows(
  const Lattice& lattice, const DomainBoundary& boundary, double mostCrossings, Rows& rows)
{
  const double clearance = Clearance * lattice.Edge;
  double expected = 0.0;
  for (const InputSegment& segment : boundary.Segments)
  {
    expected += std::abs(boundary.Points[segment.From].y - boundary.Points[segment.To].y);
  }
  if (!(expected / lattice.RowHeight < mostCrossings))
  {
    return false;
  }
  for (const InputSegment& segment : boundary.Segments)
  {
    const Point2& from = boundary.Points[segment.From];
    const Point2& to = boundary.Points[segment.To];
    const double south = std::min(from.y, to.y);
    const double north = std::max(from.y, to.y);
    for (std::int64_t row = lattice.RowAbove(south - clearance);
         lattice.HeightOf(row) <= north + clearance; ++row)
    {
      const double y = lattice.HeightOf(row);
      const Interval near = NearSegment(from, to, clearance, y);
      if (near.From <= near.To)
      {
        rows.Forbidden.push_back({ row, near });
      }
      if ((from.y <= y) != (to.y <= y))
      {
        const double x = from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y);
        rows.Crossings.push_back({ row, { x, x } });
      }
    }
  }
  std::sort(rows.Crossings.begin(), rows.Crossings.end());
  std::sort(rows.Forbidden.begin(), rows.Forbidden.end());
  return true;
}

/** The distance along the Hilbert curve of that order, D. Hilbert 1891. */
std::uint64_t HilbertKey(std::uint32_t x, std::uint32_t y, int order)
{
  std::uint64_t key = 0;
  for (int bit = order - 1; bit >= 0; --bit)
  {
    const std::uint32_t right = x >> bit & 1U;
    const std::uint32_t upper = y >> bit & 1U;
    key = key << 2 | ((3U * right) ^ upper);
    if (upper == 0)
    {
      if (right == 1)
      {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

/** The nodes inside the domain, where the boundary is crossed an odd number of times before. */
std::vector<Node> FindNodes(const Lattice& lattice, const Rows& rows)
{
  std::vector<Node> nodes;
  std::size_t forbidden = 0;
  double forbiddenTo = 0.0;
  std::int64_t currentRow = -1;
  for (std::size_t i = 0; i + 1 < rows.Crossings.size(); i += 2)
  {
    const std::int64_t row = rows.Crossings[i].Row;
    if (row != currentRow)
    {
      currentRow = row;
      forbiddenTo = -std::numeric_limits<double>::infinity();
    }
    const double first = lattice.FirstOn(row);
    const double from = std::ceil((rows.Crossings[i].Place.From - first) / lattice.Edge);
    const double to = std::floor((rows.Crossings[i + 1].Place.From - first) / lattice.Edge);
    for (double column = std::max(0.0, from); column <= to; ++column)
    {
      const double x = first + column * lattice.Edge;
      while (forbidden < rows.Forbidden.size() &&
        (rows.Forbidden[forbidden].Row < row ||
          (rows.Forbidden[forbidden].Row == row && rows.Forbidden[forbidden].Place.From <= x)))
      {
        if (rows.Forbidden[forbidden].Row == row)
        {
          forbiddenTo = std::max(forbiddenTo, rows.Forbidden[forbidden].Place.To);
        }
        ++forbidden;
      }
      if (x > forbiddenTo)
      {
        nodes.push_back({ 0, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column) });
      }
    }
  }
  return nodes;
}

} // namespace

std::vector<Point2> MakeLatticePoints(const DomainBoundary& boundary, double maximumArea)
{
  const Lattice lattice(boundary.Points, maximumArea);
  const double width = (lattice.High.x - lattice.Low.x) / lattice.Edge;
  const double height = (lattice.High.y - lattice.Low.y) / lattice.RowHeight;
  double twiceArea = 0.0;
  for (const InputSegment& segment : boundary.Segments)
  {
    twiceArea +=
      Cross(boundary.Points[segment.From] - lattice.Low, boundary.Points[segment.To] - lattice.Low);
  }
  // If rows cross the boundary more often than that the domain is too narrow for inner points.
  const double mostCrossings = twiceArea / maximumArea + 1000.0;
  constexpr double LargestNumber = std::numeric_limits<std::int32_t>::max();
  Rows rows;
  if (!(width < LargestNumber && height < LargestNumber) ||
    !FindRows(lattice, boundary, mostCrossings, rows))
  {
    return {};
  }
  std::vector<Node> nodes = FindNodes(lattice, rows);
  const int order = std::bit_width(static_cast<std::uint32_t>(std::max(width, height)) + 1U);
  for (Node& node : nodes)
  {
    node.Key = HilbertKey(node.Column, node.Row, order);
  }
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.Key < b.Key; });
  std::vector<Point2> points;
  points.reserve(nodes.size());
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(points),
    [&lattice](const Node& node) { return lattice.At(node); });
  return points;
}

} // namespace pemesh

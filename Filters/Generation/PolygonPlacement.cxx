// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonPlacement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

struct Box
{
  Point2 Low;
  Point2 High;

  Point2 Center() const
  {
    return { 0.5 * (this->Low.x + this->High.x), 0.5 * (this->Low.y + this->High.y) };
  }
};

Box BoxOf(const std::vector<Point2>& vertices)
{
  Box box = { vertices[0], vertices[0] };
  for (const Point2& point : vertices)
  {
    box.Low = { std::min(box.Low.x, point.x), std::min(box.Low.y, point.y) };
    box.High = { std::max(box.High.x, point.x), std::max(box.High.y, point.y) };
  }
  return box;
}

Point2 AverageOf(const std::vector<Point2>& vertices)
{
  Point2 sum;
  for (const Point2& point : vertices)
  {
    sum.x += point.x;
    sum.y += point.y;
  }
  const double n = static_cast<double>(vertices.size());
  return { sum.x / n, sum.y / n };
}

/** Cosine and sine, without rounding at multiples of 90 degrees. */
Point2 DirectionOf(double degrees)
{
  const double turn = std::remainder(degrees, 360.0); // exact, in [-180, 180]
  if (turn == 0.0)
  {
    return { 1.0, 0.0 };
  }
  if (std::abs(turn) == 180.0)
  {
    return { -1.0, 0.0 };
  }
  if (std::abs(turn) == 90.0)
  {
    return { 0.0, turn > 0.0 ? 1.0 : -1.0 };
  }
  const double radians = turn * std::numbers::pi / 180.0;
  return { std::cos(radians), std::sin(radians) };
}

} // namespace

PolygonPlace PlaceOf(const std::vector<Point2>& vertices)
{
  const Box box = BoxOf(vertices);
  const double diagonal = std::hypot(box.High.x - box.Low.x, box.High.y - box.Low.y);
  return { box.Center(), diagonal / UnitPolygonDiagonal };
}

std::vector<Point2> PlacePolygon(
  std::vector<Point2> vertices, const Point2& center, double scale, double degrees)
{
  if (vertices.empty())
  {
    return vertices;
  }
  const PolygonPlace own = PlaceOf(vertices);
  if (own == PolygonPlace{ center, scale } && std::remainder(degrees, 360.0) == 0.0)
  {
    return vertices;
  }
  const double factor = scale / own.Scale;
  const Point2 average = AverageOf(vertices);
  const Point2 direction = DirectionOf(degrees);
  for (Point2& point : vertices)
  {
    const double x = factor * (point.x - average.x);
    const double y = factor * (point.y - average.y);
    point = { direction.x * x - direction.y * y, direction.y * x + direction.x * y };
  }
  const Point2 middle = BoxOf(vertices).Center();
  for (Point2& point : vertices)
  {
    point = { center.x + (point.x - middle.x), center.y + (point.y - middle.y) };
  }
  return vertices;
}

} // namespace pemesh

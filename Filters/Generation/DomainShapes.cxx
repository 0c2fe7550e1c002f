// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainShapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr double LeastSize = 1e-6;
constexpr double GreatestSize = 1e6;

constexpr Parameter RectangleParameters[] = {
  { "width", "extent along x", 1.0, LeastSize, GreatestSize },
  { "height", "extent along y", 1.0, LeastSize, GreatestSize },
};

constexpr Parameter RegularPolygonParameters[] = {
  { "sides", "number of sides", 6.0, 3.0, 100000.0, true },
  { "radius", "radius of the circle through the vertices", 0.5, LeastSize, GreatestSize },
};

constexpr Parameter LShapeParameters[] = {
  { "width", "extent along x", 1.0, LeastSize, GreatestSize },
  { "height", "extent along y", 1.0, LeastSize, GreatestSize },
  { "share", "share of the width and of the height that the missing part takes", 0.5, 0.01, 0.99 },
};

constexpr Parameter DiscParameters[] = {
  { "radius", "radius of the disc", 0.5, LeastSize, GreatestSize },
  { "sides", "sides of the inscribed polygon that stands for the disc", 64.0, 3.0, 100000.0, true },
};

Domain MakeRectangle(const ParameterValues& values)
{
  const double width = values.Get("width");
  const double height = values.Get("height");
  return { { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } }, {} };
}

Domain MakeLShape(const ParameterValues& values)
{
  const double width = values.Get("width");
  const double height = values.Get("height");
  const double x = width * (1.0 - values.Get("share"));
  const double y = height * (1.0 - values.Get("share"));
  return { { { 0.0, 0.0 }, { width, 0.0 }, { width, y }, { x, y }, { x, height }, { 0.0, height } },
    {} };
}

/**
 * Vertex i is at the angle (2 i + 1) pi / sides from straight down, so the bottom edge is level.
 * Mirror images are computed once: symmetric to the bit, and level and upright edges exactly so.
 */
Domain RegularPolygon(int sides, double radius)
{
  const auto half = [sides, radius](int i) -> Point2 // for i < sides / 2, rounded up
  {
    if (2 * i + 1 == sides)
    {
      return { 0.0, radius };
    }
    if (2 * (2 * i + 1) == sides)
    {
      return { radius, 0.0 };
    }
    const bool upper = sides % 2 == 0 && 2 * (2 * i + 1) > sides;
    const int lower = upper ? sides / 2 - 1 - i : i;
    const double angle = (2 * lower + 1) * std::numbers::pi / sides;
    const double y = -radius * std::cos(angle);
    return { radius * std::sin(angle), upper ? -y : y };
  };
  Domain domain;
  for (int i = 0; i < sides; ++i)
  {
    const Point2 right = half(std::min(i, sides - 1 - i));
    domain.Outer.push_back({ 2 * i < sides ? right.x : -right.x, right.y });
  }
  double west = 0.0;
  double south = 0.0;
  for (const Point2& point : domain.Outer)
  {
    west = std::min(west, point.x);
    south = std::min(south, point.y);
  }
  for (Point2& point : domain.Outer)
  {
    point = { point.x - west, point.y - south };
  }
  return domain;
}

Domain MakeRegularPolygon(const ParameterValues& values)
{
  return RegularPolygon(values.GetInteger("sides"), values.Get("radius"));
}

constexpr DomainShape Shapes[] = {
  { "rectangle", "Rectangle", "A rectangle from (0, 0); the unit square by default.",
    RectangleParameters, &MakeRectangle },
  { "regular-polygon", "Regular polygon", "A regular polygon that stands on one of its sides.",
    RegularPolygonParameters, &MakeRegularPolygon },
  { "l-shape", "L", "A rectangle less its upper right part.", LShapeParameters, &MakeLShape },
  { "disc", "Disc",
    "A disc, that is, a regular polygon with many sides and vertices on its circle.",
    DiscParameters, &MakeRegularPolygon },
};

} // namespace

std::span<const DomainShape> DomainShapes()
{
  return Shapes;
}

const DomainShape* FindDomainShape(std::string_view name)
{
  const auto found = std::find_if(std::begin(Shapes), std::end(Shapes),
    [name](const DomainShape& shape) { return shape.Name == name; });
  return found == std::end(Shapes) ? nullptr : found;
}

} // namespace pemesh

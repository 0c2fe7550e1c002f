// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AreaRules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr double NoBound = std::numeric_limits<double>::infinity();

double Distance(const Point2& a, const Point2& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

double ShortestEdge(const std::vector<Point2>& polygon)
{
  double shortest = NoBound;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    shortest = std::min(shortest, Distance(polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return shortest;
}

double Area(const std::vector<Point2>& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    // Relative to the first vertex: small polygons far from the origin lose no digits.
    twice += (polygon[i].x - polygon[0].x) * (polygon[i + 1].y - polygon[0].y) -
      (polygon[i].y - polygon[0].y) * (polygon[i + 1].x - polygon[0].x);
  }
  return 0.5 * std::abs(twice);
}

double BoxDiagonal(const std::vector<Point2>& polygon)
{
  const auto [west, east] = std::minmax_element(
    polygon.begin(), polygon.end(), [](const Point2& a, const Point2& b) { return a.x < b.x; });
  const auto [south, north] = std::minmax_element(
    polygon.begin(), polygon.end(), [](const Point2& a, const Point2& b) { return a.y < b.y; });
  return std::hypot(east->x - west->x, north->y - south->y);
}

double Unbounded(const AreaRuleInput&)
{
  return NoBound;
}

double FromShortestEdge(const AreaRuleInput& input)
{
  double edge = NoBound;
  double area = NoBound;
  for (const std::vector<Point2>& polygon : input.Polygons)
  {
    edge = std::min(edge, ShortestEdge(polygon));
    area = std::min(area, Area(polygon));
  }
  double bound = std::min(edge * edge * std::numbers::sqrt3 / 4.0, area);
  if (input.MinimumAngle > 0.0)
  {
    bound = std::min(bound, edge * edge * std::sin(input.MinimumAngle * std::numbers::pi / 180.0));
  }
  return bound;
}

double FromDiagonal(const AreaRuleInput& input)
{
  if (input.Polygons.empty())
  {
    return NoBound;
  }
  double sum = 0.0;
  for (const std::vector<Point2>& polygon : input.Polygons)
  {
    sum += BoxDiagonal(polygon);
  }
  const double mean = sum / static_cast<double>(input.Polygons.size());
  return mean * mean / 4.0;
}

double UserConstant(const AreaRuleInput& input)
{
  return input.Constant;
}

constexpr AreaRule Rules[] = {
  { "none", "No bound", "unbounded", &Unbounded },
  { "shortest-edge", "From the shortest edge of the polygons",
    "min(e^2 sqrt(3)/4, e^2 sin(minimum angle), smallest polygon area)", &FromShortestEdge },
  { "diagonal", "From the polygons' bounding boxes", "d^2/4, d the mean diagonal", &FromDiagonal },
  { "constant", "A constant", "the maximum area given", &UserConstant },
};

} // namespace

std::span<const AreaRule> AreaRules()
{
  return Rules;
}

int FindAreaRule(std::string_view name)
{
  const auto found = std::find_if(
    std::begin(Rules), std::end(Rules), [name](const AreaRule& rule) { return rule.Name == name; });
  return found == std::end(Rules) ? -1 : static_cast<int>(found - std::begin(Rules));
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutValidity.h"

#include "NumberText.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

struct Box
{
  double West, East, South, North;
};

Box BoxOf(const std::vector<Point2>& polygon)
{
  Box box = { polygon[0].x, polygon[0].x, polygon[0].y, polygon[0].y };
  for (const Point2& point : polygon)
  {
    box.West = std::min(box.West, point.x);
    box.East = std::max(box.East, point.x);
    box.South = std::min(box.South, point.y);
    box.North = std::max(box.North, point.y);
  }
  return box;
}

bool AreApart(const Box& a, const Box& b)
{
  return a.East < b.West || b.East < a.West || a.North < b.South || b.North < a.South;
}

bool IsUnitSquare(const Domain& domain)
{
  const Box box = BoxOf(domain.Outer);
  return IsRectangle(domain) && box.West == 0.0 && box.South == 0.0 && box.East == 1.0 &&
    box.North == 1.0;
}

RectangleRelation RelateToOuterLoop(const std::vector<Point2>& polygon, const Domain& domain)
{
  if (IsRectangle({ domain.Outer, {} }))
  {
    const Box box = BoxOf(domain.Outer);
    return RelateToRectangle(polygon, { box.West, box.South }, { box.East, box.North });
  }
  if (RelatePolygons(polygon, domain.Outer) != PolygonRelation::FirstInsideSecond)
  {
    return RectangleRelation::Outside;
  }
  return DoBoundariesMeet(polygon, domain.Outer) ? RectangleRelation::Touching
                                                 : RectangleRelation::Inside;
}

std::string FindOwnFault(
  const PlacedPolygon& polygon, const Domain& domain, const std::string& when)
{
  const std::string why = WhyNotSimple(polygon.Vertices);
  if (!why.empty())
  {
    return polygon.Name + " " + why + when + "; use a simple polygon.";
  }
  const std::string border = (IsUnitSquare(domain) ? "the unit square" : "the domain") + when;
  switch (RelateToOuterLoop(polygon.Vertices, domain))
  {
    case RectangleRelation::Outside:
      return polygon.Name + " leaves " + border + "; move it inwards or make it smaller.";
    case RectangleRelation::Touching:
      return polygon.Name + " touches the border of " + border +
        "; move it inwards or make it smaller.";
    case RectangleRelation::Inside:
      break;
  }
  return {};
}

/** The fault of two placed polygons, or of one and a hole of the domain, which is the second. */
std::string FindPairFault(const PlacedPolygon& first, const PlacedPolygon& second,
  bool secondIsHole, const std::string& when)
{
  const std::string remedy = when +
    (secondIsHole ? "; move it away or make it smaller."
                  : "; move them apart or make them smaller.");
  const std::string both = first.Name + (secondIsHole ? " meets " : " and ") + second.Name;
  switch (RelatePolygons(first.Vertices, second.Vertices))
  {
    case PolygonRelation::Apart:
      break;
    case PolygonRelation::Touching:
      return secondIsHole ? first.Name + " touches " + second.Name + remedy
                          : both + " touch" + remedy;
    case PolygonRelation::FirstInsideSecond:
      return first.Name + " lies in " + second.Name + remedy;
    case PolygonRelation::SecondInsideFirst:
      return second.Name + " lies in " + first.Name + remedy;
    case PolygonRelation::Overlapping:
    case PolygonRelation::Equal:
      return secondIsHole ? both + remedy : both + " overlap" + remedy;
  }
  return {};
}

/**
 * The fault of the first pair (in the order of the list) among all polygons and the holes that
 * follow them. Only pairs whose boxes meet are looked at, found by a sweep from west to east.
 */
std::string FindFirstPairFault(
  const std::vector<PlacedPolygon>& loops, std::size_t numberOfPolygons, const std::string& when)
{
  std::vector<Box> boxes;
  std::vector<std::size_t> order;
  for (const PlacedPolygon& loop : loops)
  {
    order.push_back(boxes.size());
    boxes.push_back(BoxOf(loop.Vertices));
  }
  std::sort(order.begin(), order.end(),
    [&boxes](std::size_t a, std::size_t b)
    { return boxes[a].West < boxes[b].West || (boxes[a].West == boxes[b].West && a < b); });
  std::pair<std::size_t, std::size_t> worst = { loops.size(), loops.size() };
  std::string fault;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].West <= boxes[order[i]].East;
         ++j)
    {
      const auto [first, second] = std::minmax(order[i], order[j]);
      if (first >= numberOfPolygons || AreApart(boxes[first], boxes[second]) ||
        std::pair(first, second) > worst)
      {
        continue;
      }
      const std::string found =
        FindPairFault(loops[first], loops[second], second >= numberOfPolygons, when);
      if (!found.empty())
      {
        worst = { first, second };
        fault = found;
      }
    }
  }
  return fault;
}

} // namespace

std::string FindLayoutFault(
  const std::vector<PlacedPolygon>& polygons, const Domain& domain, double t)
{
  const std::string when = std::isnan(t) ? std::string() : " at t = " + FormatNumber(t);
  for (const PlacedPolygon& polygon : polygons)
  {
    std::string fault = FindOwnFault(polygon, domain, when);
    if (!fault.empty())
    {
      return fault;
    }
  }
  std::vector<PlacedPolygon> loops = polygons;
  for (const std::vector<Point2>& hole : domain.Holes)
  {
    const std::size_t number = loops.size() - polygons.size() + 1;
    loops.push_back({ "hole " + std::to_string(number) + " of the domain", hole });
  }
  return FindFirstPairFault(loops, polygons.size(), when);
}

} // namespace pemesh

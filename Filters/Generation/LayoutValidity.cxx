// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutValidity.h"

#include "NumberText.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>

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

std::string FindOwnFault(const PlacedPolygon& polygon, const std::string& when)
{
  const std::string why = WhyNotSimple(polygon.Vertices);
  if (!why.empty())
  {
    return polygon.Name + " " + why + when + "; use a simple polygon.";
  }
  switch (RelateToRectangle(polygon.Vertices))
  {
    case RectangleRelation::Outside:
      return polygon.Name + " leaves the unit square" + when +
        "; move it inwards or make it smaller.";
    case RectangleRelation::Touching:
      return polygon.Name + " touches the border of the unit square" + when +
        "; move it inwards or make it smaller.";
    case RectangleRelation::Inside:
      break;
  }
  return {};
}

std::string FindPairFault(
  const PlacedPolygon& first, const PlacedPolygon& second, const std::string& when)
{
  const std::string remedy = when + "; move them apart or make them smaller.";
  const std::string both = first.Name + " and " + second.Name;
  switch (RelatePolygons(first.Vertices, second.Vertices))
  {
    case PolygonRelation::Apart:
      break;
    case PolygonRelation::Touching:
      return both + " touch" + remedy;
    case PolygonRelation::FirstInsideSecond:
      return first.Name + " lies in " + second.Name + remedy;
    case PolygonRelation::SecondInsideFirst:
      return second.Name + " lies in " + first.Name + remedy;
    case PolygonRelation::Overlapping:
    case PolygonRelation::Equal:
      return both + " overlap" + remedy;
  }
  return {};
}

} // namespace

std::string FindLayoutFault(const std::vector<PlacedPolygon>& polygons, double t)
{
  const std::string when = std::isnan(t) ? std::string() : " at t = " + FormatNumber(t);
  std::vector<Box> boxes;
  for (const PlacedPolygon& polygon : polygons)
  {
    const std::string fault = FindOwnFault(polygon, when);
    if (!fault.empty())
    {
      return fault;
    }
    boxes.push_back(BoxOf(polygon.Vertices));
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    for (std::size_t j = i + 1; j < polygons.size(); ++j)
    {
      const std::string fault = AreApart(boxes[i], boxes[j])
        ? std::string()
        : FindPairFault(polygons[i], polygons[j], when);
      if (!fault.empty())
      {
        return fault;
      }
    }
  }
  return {};
}

} // namespace pemesh

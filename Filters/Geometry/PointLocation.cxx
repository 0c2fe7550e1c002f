// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointLocation.h"

#include "Predicates.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

PointLocation LocatePoint(PolygonView polygon, const Point2& point)
{
  if (polygon.size() < 3 || !std::isfinite(point.x) || !std::isfinite(point.y))
  {
    return PointLocation::Outside;
  }
  bool inside = false;
  Point2 from = polygon.back();
  for (const Point2& to : polygon)
  {
    if (to == point)
    {
      return PointLocation::OnBoundary;
    }
    if ((from.y > point.y) != (to.y > point.y))
    {
      const bool rises = from.y < to.y;
      const int side = rises ? Orientation(from, to, point) : Orientation(to, from, point);
      if (side == 0)
      {
        return PointLocation::OnBoundary;
      }
      inside = inside != (side > 0); // to the left of the edge: the ray meets it
    }
    else if (from.y == point.y && to.y == point.y && std::min(from.x, to.x) < point.x &&
      point.x < std::max(from.x, to.x))
    {
      return PointLocation::OnBoundary;
    }
    from = to;
  }
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

} // namespace pemesh

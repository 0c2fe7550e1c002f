// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "InputCorners.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pemesh
{

InputCorners::InputCorners(const RefinableTriangulation& mesh, const DomainBoundary& boundary)
  : Mesh(mesh)
  , Boundary(boundary)
{
  const std::vector<Point2>& points = boundary.Points;
  this->IsAcute.resize(points.size());
  this->IsSmall.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2 next = points[boundary.Segments[i].To] - points[i];
    const Point2 before = points[boundary.Segments[boundary.Before[i]].From] - points[i];
    // The domain is to the left, between `next` and `before` counter-clockwise.
    const bool convex = Cross(next, before) > 0.0;
    const double dot = Dot(next, before);
    this->IsAcute[i] = convex && dot > 0.0;
    this->IsSmall[i] =
      convex && dot > 0.0 && 4.0 * dot * dot > Dot(next, next) * Dot(before, before);
  }
}

double InputCorners::ShellRadius(double length)
{
  int exponent = 0;
  const double mantissa = std::frexp(0.5 * length, &exponent); // in [0.5, 1)
  return std::ldexp(1.0, mantissa * std::numbers::sqrt2 < 1.0 ? exponent - 1 : exponent);
}

Point2 InputCorners::PointAt(double distance, int end, int otherEnd) const
{
  const Point2& from = this->Mesh.GetPoint(end);
  const Point2& to = this->Mesh.GetPoint(otherEnd);
  const double fraction = distance / std::sqrt(SquaredDistance(from, to));
  // A coordinate that both ends share, such as 0 or 1 on the square, is kept exactly.
  return { from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y) };
}

Point2 InputCorners::SplitPoint(int from, int to) const
{
  const bool fromAcute = this->IsInputVertex(from) && this->IsAcute[from];
  const bool toAcute = this->IsInputVertex(to) && this->IsAcute[to];
  const double length =
    std::sqrt(SquaredDistance(this->Mesh.GetPoint(from), this->Mesh.GetPoint(to)));
  if (fromAcute == toAcute)
  {
    return this->PointAt(0.5 * length, from, to);
  }
  return fromAcute ? this->PointAt(ShellRadius(length), from, to)
                   : this->PointAt(ShellRadius(length), to, from);
}

double InputCorners::SquaredSmallestFeature() const
{
  double smallest = std::numeric_limits<double>::infinity();
  for (const RefinableTriangulation::Triangle& triangle : this->Mesh.GetTriangles())
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const Point2& apex = this->Mesh.GetPoint(triangle.Vertex[edge]);
      const Point2& from = this->Mesh.GetPoint(triangle.Vertex[(edge + 1) % 3]);
      const Point2& to = this->Mesh.GetPoint(triangle.Vertex[(edge + 2) % 3]);
      const double squaredLength = SquaredDistance(from, to);
      smallest = std::min(smallest, squaredLength);
      const bool footInside = Dot(apex - from, to - from) > 0.0 && Dot(apex - to, from - to) > 0.0;
      if (triangle.Neighbor[edge] < 0 && footInside)
      {
        const double cross = Cross(to - from, apex - from);
        smallest = std::min(smallest, cross * cross / squaredLength);
      }
    }
  }
  return smallest;
}

} // namespace pemesh

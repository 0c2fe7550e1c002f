// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonKernel.h"

#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

const std::vector<Point2>& PolygonKernelClipper::Clip(PolygonView polygon)
{
  this->Kernel.clear();
  const std::size_t size = polygon.size();
  if (size < 3)
  {
    return this->Kernel;
  }
  const Point2 origin = polygon[0];
  if (IsConvex(polygon))
  {
    for (const Point2& point : polygon)
    {
      this->Kernel.push_back({ point.x - origin.x, point.y - origin.y });
    }
    return this->Kernel;
  }
  Point2 low;
  Point2 high;
  for (const Point2& point : polygon)
  {
    low = { std::min(low.x, point.x - origin.x), std::min(low.y, point.y - origin.y) };
    high = { std::max(high.x, point.x - origin.x), std::max(high.y, point.y - origin.y) };
  }
  this->Kernel = { low, { high.x, low.y }, high, { low.x, high.y } };
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[i + 1 == size ? 0 : i + 1];
    // The direction from the vertices as given: exact for edges short against the coordinates.
    if (!this->ClipHalfPlane({ a.x - origin.x, a.y - origin.y }, { b.x - a.x, b.y - a.y }))
    {
      break;
    }
  }
  return this->Kernel;
}

/**
 * Cuts off what is to the right of a line (I. E. Sutherland, G. W. Hodgman, Commun. ACM 17 (1974)
 * 32-42). False if nothing is left.
 */
bool PolygonKernelClipper::ClipHalfPlane(const Point2& anchor, const Point2& direction)
{
  const std::size_t size = this->Kernel.size();
  this->Heights.resize(size);
  double lowest = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& p = this->Kernel[i];
    this->Heights[i] = direction.x * (p.y - anchor.y) - direction.y * (p.x - anchor.x);
    lowest = std::min(lowest, this->Heights[i]);
  }
  if (!(lowest < 0.0))
  {
    return true;
  }
  // Every point is written and then kept or not: which it is cannot be foreseen, and a branch that
  // goes the other way costs more than the point.
  this->Clipped.resize(2 * size);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t j = i + 1 == size ? 0 : i + 1;
    const double from = this->Heights[i];
    const double to = this->Heights[j];
    const Point2 p = this->Kernel[i];
    const Point2 q = this->Kernel[j];
    this->Clipped[kept] = p;
    kept += from >= 0.0 ? 1 : 0;
    const double fraction = from / (from - to);
    this->Clipped[kept] = { p.x + fraction * (q.x - p.x), p.y + fraction * (q.y - p.y) };
    kept += std::min(from, to) < 0.0 && std::max(from, to) > 0.0 ? 1 : 0;
  }
  this->Clipped.resize(kept);
  std::swap(this->Kernel, this->Clipped);
  if (this->Kernel.size() < 3)
  {
    this->Kernel.clear();
  }
  return !this->Kernel.empty();
}

std::vector<Point2> PolygonKernel(PolygonView polygon)
{
  PolygonKernelClipper clipper;
  std::vector<Point2> kernel = clipper.Clip(polygon);
  for (Point2& point : kernel)
  {
    point = { point.x + polygon[0].x, point.y + polygon[0].y };
  }
  if (polygon.size() >= 3 && IsConvex(polygon))
  {
    kernel.assign(polygon.begin(), polygon.end()); // to the bit
  }
  return kernel;
}

} // namespace pemesh

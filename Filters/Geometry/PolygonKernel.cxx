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
  bool cuts = false;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& p = this->Kernel[i];
    this->Heights[i] = direction.x * (p.y - anchor.y) - direction.y * (p.x - anchor.x);
    cuts = cuts || this->Heights[i] < 0.0;
  }
  if (!cuts)
  {
    return true;
  }
  this->Clipped.clear();
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t j = i + 1 == size ? 0 : i + 1;
    const double from = this->Heights[i];
    const double to = this->Heights[j];
    if (from >= 0.0)
    {
      this->Clipped.push_back(this->Kernel[i]);
    }
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))
    {
      const Point2& p = this->Kernel[i];
      const Point2& q = this->Kernel[j];
      const double fraction = from / (from - to);
      this->Clipped.push_back({ p.x + fraction * (q.x - p.x), p.y + fraction * (q.y - p.y) });
    }
  }
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

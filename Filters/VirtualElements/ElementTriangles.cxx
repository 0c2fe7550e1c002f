// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTriangles.h"

namespace pemesh
{

namespace
{

// True if the turns at all vertices are clearly to the left; a simple polygon is then convex.
bool IsClearlyConvex(PolygonView vertices)
{
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2& a = vertices[i];
    const Point2& b = vertices[i + 1 < n ? i + 1 : i + 1 - n];
    const Point2& c = vertices[i + 2 < n ? i + 2 : i + 2 - n];
    const double left = (b.x - a.x) * (c.y - b.y);
    const double right = (b.y - a.y) * (c.x - b.x);
    if (!(left - right > 1.0e-12 * (std::abs(left) + std::abs(right))))
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::span<const Triangle2> ElementTriangles::Cut(PolygonView vertices)
{
  this->Triangles.clear();
  if (vertices.size() == 3 || IsClearlyConvex(vertices))
  {
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    {
      this->Triangles.push_back({ vertices[0], vertices[i], vertices[i + 1] });
    }
    return this->Triangles;
  }
  for (const auto& [a, b, c] : this->Triangulator.Triangulate(vertices))
  {
    this->Triangles.push_back({ vertices[static_cast<std::size_t>(a)],
      vertices[static_cast<std::size_t>(b)], vertices[static_cast<std::size_t>(c)] });
  }
  return this->Triangles;
}

} // namespace pemesh

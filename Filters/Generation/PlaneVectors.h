// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Plain vector algebra on points, for the refinement.
 */
#ifndef pemesh_PlaneVectors_h
#define pemesh_PlaneVectors_h

#include "Point2.h"

namespace pemesh
{

inline Point2 operator-(const Point2& a, const Point2& b)
{
  return { a.x - b.x, a.y - b.y };
}

inline double Dot(const Point2& a, const Point2& b)
{
  return a.x * b.x + a.y * b.y;
}

inline double Cross(const Point2& a, const Point2& b)
{
  return a.x * b.y - a.y * b.x;
}

inline double SquaredDistance(const Point2& a, const Point2& b)
{
  return Dot(b - a, b - a);
}

} // namespace pemesh

#endif

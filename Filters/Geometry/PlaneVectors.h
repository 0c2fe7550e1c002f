// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Arithmetic of vectors in the plane.
 */
#ifndef pemesh_PlaneVectors_h
#define pemesh_PlaneVectors_h

#include "Point2.h"

#include <cmath>

namespace pemesh
{

inline Point2 operator-(const Point2& a, const Point2& b)
{
  return { a.x - b.x, a.y - b.y };
}

inline Point2 operator+(const Point2& a, const Point2& b)
{
  return { a.x + b.x, a.y + b.y };
}

inline double Dot(const Point2& a, const Point2& b)
{
  return a.x * b.x + a.y * b.y;
}

/** Twice the signed area of the triangle of two vectors. */
inline double Cross(const Point2& a, const Point2& b)
{
  return a.x * b.y - a.y * b.x;
}

inline double Length(const Point2& a)
{
  return std::sqrt(Dot(a, a));
}

inline double SquaredDistance(const Point2& a, const Point2& b)
{
  return Dot(b - a, b - a);
}

/** The order of points from left to right, and from bottom to top on a vertical line. */
inline bool IsLexicographicallyLess(const Point2& a, const Point2& b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/** The unit normal to the left of a direction. */
inline Point2 LeftOf(const Point2& direction)
{
  return { -direction.y, direction.x };
}

} // namespace pemesh

#endif

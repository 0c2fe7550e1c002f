// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Geometric decisions that are always right.
 *
 * The sign is computed in floating point with a proven error bound, and only where that cannot
 * decide in exact arithmetic. Reference: J. R. Shewchuk, Adaptive precision floating-point
 * arithmetic and fast robust geometric predicates, Discrete Comput. Geom. 18 (1997) 305-363,
 * doi 10.1007/PL00009321 (bound A); the exact stage is CGAL's.
 */
#ifndef pemesh_Predicates_h
#define pemesh_Predicates_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

namespace pemesh
{

/** The exact stage of Orientation, for arguments its filter cannot decide. */
PEMESHFILTERSGEOMETRY_EXPORT int ExactOrientation(
  const Point2& a, const Point2& b, const Point2& c);

/** 1 if a, b, c turn left, -1 if they turn right, 0 if they are exactly on one line. */
inline int Orientation(const Point2& a, const Point2& b, const Point2& c)
{
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double sum = (left < 0.0 ? -left : left) + (right < 0.0 ? -right : right);
  constexpr double ErrorBound = 3.3306690738754716e-16; // (3 + 16 u) u, u = 2^-53
  const double error = ErrorBound * sum;
  // The second term makes underflow, too, fall through to the exact stage.
  if (determinant > error && determinant > 1e-280)
  {
    return 1;
  }
  if (determinant < -error && determinant < -1e-280)
  {
    return -1;
  }
  return ExactOrientation(a, b, c);
}

/** The exact stage of OrientationOfIntersection. */
PEMESHFILTERSGEOMETRY_EXPORT int ExactOrientationOfIntersection(const Point2& a, const Point2& b,
  const Point2& p, const Point2& q, const Point2& r, const Point2& s);

/**
 * Orientation(a, b, x) of the point x where the line from p to q meets that from r to s, which has
 * to turn left of it: (q - p) x (s - r) > 0.
 */
inline int OrientationOfIntersection(const Point2& a, const Point2& b, const Point2& p,
  const Point2& q, const Point2& r, const Point2& s)
{
  struct Product // of vectors, and what bounds its rounding
  {
    double Value;
    double Size;
    Product(double ux, double uy, double vx, double vy)
      : Value(ux * vy - uy * vx)
      , Size(Magnitude(ux * vy) + Magnitude(uy * vx))
    {
    }
    static double Magnitude(double value) { return value < 0.0 ? -value : value; }
  };
  const Product height(b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y);
  const Product rise(b.x - a.x, b.y - a.y, q.x - p.x, q.y - p.y);
  const Product turn(q.x - p.x, q.y - p.y, s.x - r.x, s.y - r.y);
  const Product along(r.x - p.x, r.y - p.y, s.x - r.x, s.y - r.y);
  const double determinant = height.Value * turn.Value + along.Value * rise.Value;
  // Every product of vectors is within 4 u of its size, u = 2^-53, so this is within 10 u.
  constexpr double ErrorBound = 1.8e-15; // 16 u
  const double error = ErrorBound * (height.Size * turn.Size + along.Size * rise.Size);
  if (determinant > error && determinant > 1e-280)
  {
    return 1;
  }
  if (determinant < -error && determinant < -1e-280)
  {
    return -1;
  }
  return ExactOrientationOfIntersection(a, b, p, q, r, s);
}

} // namespace pemesh

#endif

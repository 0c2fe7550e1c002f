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

} // namespace pemesh

#endif

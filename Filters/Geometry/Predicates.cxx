// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Mpzf.h>

namespace pemesh
{

namespace
{

#ifdef CGAL_HAS_MPZF
using ExactNumber = CGAL::Mpzf;
#else
using ExactNumber = CGAL::MP_Float;
#endif

struct ExactVector
{
  ExactNumber x;
  ExactNumber y;

  ExactVector(const Point2& from, const Point2& to)
    : x(ExactNumber(to.x) - ExactNumber(from.x))
    , y(ExactNumber(to.y) - ExactNumber(from.y))
  {
  }
};

ExactNumber Cross(const ExactVector& a, const ExactVector& b)
{
  return a.x * b.y - a.y * b.x;
}

} // namespace

int ExactOrientation(const Point2& a, const Point2& b, const Point2& c)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return static_cast<int>(CGAL::orientation(
    Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y)));
}

int ExactOrientationOfIntersection(const Point2& a, const Point2& b, const Point2& p,
  const Point2& q, const Point2& r, const Point2& s)
{
  const ExactVector cut(a, b);
  const ExactVector first(p, q);
  const ExactVector second(r, s);
  const ExactNumber determinant = Cross(cut, ExactVector(a, p)) * Cross(first, second) +
    Cross(ExactVector(p, r), second) * Cross(cut, first);
  return static_cast<int>(CGAL::sign(determinant));
}

} // namespace pemesh

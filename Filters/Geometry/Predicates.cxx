// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace pemesh
{

int ExactOrientation(const Point2& a, const Point2& b, const Point2& c)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return static_cast<int>(CGAL::orientation(
    Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y)));
}

} // namespace pemesh

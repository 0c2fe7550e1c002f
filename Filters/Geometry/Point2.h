// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The point type of all kernels, and the view of an element that they take.
 *
 * A polygon is the cyclic sequence of its vertices, without repeating the first at the end.
 */
#ifndef pemesh_Point2_h
#define pemesh_Point2_h

#include <span>

namespace pemesh
{

struct Point2
{
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const Point2&, const Point2&) = default;
};

using PolygonView = std::span<const Point2>;

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The triangles over which an element is integrated. Private to the module.
 *
 * All lie inside the element, so that nothing is evaluated outside, where a solution may be
 * undefined, and nothing has to cancel.
 */
#ifndef pemesh_ElementTriangles_h
#define pemesh_ElementTriangles_h

#include "Point2.h"
#include "Quadrature.h"
#include "TriangulatePolygon.h"

#include <span>
#include <vector>

namespace pemesh
{

class ElementTriangles
{
public:
  /** Cuts a simple counter-clockwise polygon, convex or not. Valid until the next call. */
  std::span<const Triangle2> Cut(PolygonView vertices);

private:
  PolygonTriangulator Triangulator;
  std::vector<Triangle2> Triangles;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A circle: what the inscribed and the enclosing circle kernels return.
 */
#ifndef pemesh_Circle_h
#define pemesh_Circle_h

#include "Point2.h"

namespace pemesh
{

struct Circle
{
  Point2 Center;
  double Radius = 0.0;
};

} // namespace pemesh

#endif

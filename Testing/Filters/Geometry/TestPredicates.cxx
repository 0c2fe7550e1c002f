// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Predicates.h"

#include <gtest/gtest.h>

#include <cmath>

using pemesh::Orientation;
using pemesh::Point2;

TEST(Predicates, TurnsAndLines)
{
  EXPECT_EQ(Orientation({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(Orientation({ 0, 0 }, { 0, 1 }, { 1, 0 }), -1);
  EXPECT_EQ(Orientation({ 0, 0 }, { 1, 1 }, { 2, 2 }), 0);
  EXPECT_EQ(Orientation({ 1, 1 }, { 1, 1 }, { 2, 2 }), 0);
}

TEST(Predicates, OneUnitInTheLastPlaceDecides)
{
  // L. Kettner et al., Classroom examples of robustness problems, Comput. Geom. 40 (2008) 61-78:
  // near the line through (12, 12) and (24, 24) plain arithmetic gives random signs.
  const Point2 q = { 12, 12 };
  const Point2 r = { 24, 24 };
  double x = 0.5;
  for (int i = 0; i < 64; ++i, x = std::nextafter(x, 1.0))
  {
    double y = 0.5;
    for (int j = 0; j < 64; ++j, y = std::nextafter(y, 1.0))
    {
      EXPECT_EQ(Orientation({ x, y }, q, r), (y > x) - (y < x)) << i << ' ' << j;
    }
  }
}

TEST(Predicates, AtAnyScale)
{
  for (const double scale : { 1e-150, 1e-9, 1e9, 1e100 })
  {
    EXPECT_EQ(Orientation({ 0, 0 }, { scale, 0 }, { scale, scale }), 1) << scale;
    EXPECT_EQ(Orientation({ 0, 0 }, { scale, scale }, { 2 * scale, 2 * scale }), 0) << scale;
  }
}

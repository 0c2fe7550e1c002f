// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AreaRules.h"

#include "MeshInvariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

TEST(AreaRules, FormulasByHand)
{
  // A rectangle 0.2 x 0.1 and a right triangle with legs 0.3 and 0.4.
  const std::vector<PolygonVertices> polygons = { { { 0.1, 0.1 }, { 0.3, 0.1 }, { 0.3, 0.2 },
                                                    { 0.1, 0.2 } },
    { { 0.5, 0.5 }, { 0.8, 0.5 }, { 0.5, 0.9 } } };
  const auto bound = [&](const char* rule, double angle) {
    return pemesh::AreaRules()[pemesh::FindAreaRule(rule)].MaximumArea({ polygons, angle, 0.007 });
  };
  EXPECT_EQ(bound("none", 20.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bound("constant", 20.0), 0.007);
  const double diagonal = 0.5 * (std::hypot(0.2, 0.1) + 0.5);
  EXPECT_NEAR(bound("diagonal", 20.0), diagonal * diagonal / 4.0, 1e-16);
  // Shortest edge 0.1: the sine term is the least up to 25.66 degrees, then sqrt(3)/4.
  EXPECT_NEAR(bound("shortest-edge", 20.0), 0.01 * std::sin(std::acos(-1.0) / 9.0), 1e-16);
  EXPECT_NEAR(bound("shortest-edge", 30.0), 0.01 * std::sqrt(3.0) / 4.0, 1e-16);
  EXPECT_NEAR(bound("shortest-edge", 0.0), 0.01 * std::sqrt(3.0) / 4.0, 1e-16)
    << "no angle asked for: its term is left out";
  EXPECT_EQ(pemesh::FindAreaRule("diagonals"), -1);
}

TEST(AreaRules, SmallestAreaCounts)
{
  const std::vector<PolygonVertices> flat = { { { 0.1, 0.1 }, { 0.5, 0.1 }, { 0.9, 0.1001 },
    { 0.5, 0.101 } } };
  const double area = SignedArea(flat[0]);
  const auto* rule = &pemesh::AreaRules()[pemesh::FindAreaRule("shortest-edge")];
  EXPECT_NEAR(rule->MaximumArea({ flat, 20.0, 0.0 }), area, 1e-15);
}

} // namespace

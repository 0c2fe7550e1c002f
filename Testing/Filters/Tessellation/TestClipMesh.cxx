// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ClipMesh.h"
#include "PolygonMeasures.h"
#include "SampleDomains.h"
#include "TessellationInvariants.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pemesh
{

namespace
{

/** Squares of a grid over [low, high]^2. */
PolygonMesh Grid(int squares, double low, double high)
{
  PolygonMesh grid;
  const auto at = [&](int i) { return low + (high - low) * i / squares; };
  for (int j = 0; j <= squares; ++j)
  {
    for (int i = 0; i <= squares; ++i)
    {
      grid.Points.push_back({ at(i), at(j) });
    }
  }
  for (int j = 0; j < squares; ++j)
  {
    for (int i = 0; i < squares; ++i)
    {
      const int corner = j * (squares + 1) + i;
      grid.AddElement(std::array{ corner, corner + 1, corner + squares + 2, corner + squares + 1 });
    }
  }
  return grid;
}

ClippedMesh Clip(const PolygonMesh& cells, const Domain& domain)
{
  ClippedMesh clipped;
  EXPECT_EQ(ClipMesh(cells, domain, 1e-9, clipped), "");
  EXPECT_EQ(WhyNotAMeshOf(domain, clipped.Mesh), "");
  return clipped;
}

double AreaOf(const PolygonMesh& mesh, int element)
{
  std::vector<Point2> vertices;
  mesh.GetVertices(element, vertices);
  return SignedArea(vertices);
}

Domain LShape(double corner)
{
  return { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, corner }, { corner, corner }, { corner, 1.0 },
             { 0.0, 1.0 } },
    {} };
}

TEST(ClipMesh, ACellAroundAHoleIsSplitInTwo)
{
  Domain frame = UnitSquare();
  frame.Holes = { { { 0.25, 0.25 }, { 0.75, 0.25 }, { 0.75, 0.75 }, { 0.25, 0.75 } } };
  for (const PolygonMesh& cells : { Grid(1, 0.0, 1.0), Grid(1, -0.5, 2.0) })
  {
    const ClippedMesh clipped = Clip(cells, frame);
    ASSERT_EQ(clipped.Mesh.NumberOfElements(), 2);
    EXPECT_EQ(AreaOf(clipped.Mesh, 0), 0.375);
    EXPECT_EQ(AreaOf(clipped.Mesh, 1), 0.375);
    EXPECT_EQ(clipped.Mesh.Points.size(), 10U);
  }
}

TEST(ClipMesh, AHoleThatTouchesItsCellInOnePointIsSplitOff)
{
  Domain domain = UnitSquare();
  domain.Holes = { { { 0.5, 0.25 }, { 0.75, 0.2 }, { 0.8, 0.3 } } }; // on the line x = 0.5
  const ClippedMesh clipped = Clip(Grid(2, 0.0, 1.0), domain);
  EXPECT_EQ(clipped.Mesh.NumberOfElements(), 5);
}

TEST(ClipMesh, CellsWhoseEdgesAreTheBoundaryStayWhole)
{
  for (const double error : { 0.0, 1e-16, 1e-12, -1e-12 })
  {
    const ClippedMesh clipped = Clip(Grid(4, 0.0, 1.0), LShape(0.5 + error));
    ASSERT_EQ(clipped.Mesh.NumberOfElements(), 12) << error;
    EXPECT_EQ(clipped.Mesh.Points.size(), 21U) << error;
    for (int element = 0; element < 12; ++element)
    {
      EXPECT_NEAR(AreaOf(clipped.Mesh, element), 1.0 / 16.0, 1e-12);
    }
  }
}

TEST(ClipMesh, ACellThatIsCutApartBecomesSeveralElements)
{
  const Domain comb = SampleDomains()[8].Region;
  EXPECT_EQ(Clip(Grid(1, -0.3, 1.2), comb).Mesh.NumberOfElements(), 1);
  const ClippedMesh halves = Clip(Grid(2, -1.0, 2.0), comb); // lines x = 0.5 and y = 0.5
  EXPECT_EQ(halves.Mesh.NumberOfElements(), 2 + 6);
  EXPECT_EQ(halves.Cells, (std::vector<int>{ 0, 1, 2, 2, 2, 3, 3, 3 }));
}

TEST(ClipMesh, CutSquaresHaveTheAreasOfTheirParts)
{
  const Domain triangle = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } }, {} };
  const ClippedMesh clipped = Clip(Grid(5, 0.0, 1.0), triangle);
  ASSERT_EQ(clipped.Mesh.NumberOfElements(), 15);
  for (int element = 0; element < 15; ++element)
  {
    const int cell = clipped.Cells[element];
    const bool isHalf = cell % 5 + cell / 5 == 4;
    EXPECT_NEAR(AreaOf(clipped.Mesh, element), isHalf ? 0.02 : 0.04, 1e-15);
  }
}

} // namespace

} // namespace pemesh

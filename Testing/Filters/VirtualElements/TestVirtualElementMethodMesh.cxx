// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodMesh.h"

#include "VirtualElementTestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using pemesh::MakeMesh;
using pemesh::MakeVirtualElementMesh;
using testing::HasSubstr;

const std::vector<pemesh::Point2> Square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };

std::string WhyRefused(vtkPolyData* mesh)
{
  try
  {
    MakeVirtualElementMesh(mesh);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "accepted";
}

TEST(VirtualElementMesh, TheBoundaryOfTheSquareIsFound)
{
  for (const auto& data :
    { pemesh::MakeTriangles(5), pemesh::MakeLShapes(6), pemesh::MakeChessboard(4) })
  {
    const auto mesh = MakeVirtualElementMesh(data);
    for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
    {
      const auto [x, y] = mesh.Points[static_cast<std::size_t>(id)];
      const bool outside = x == 0.0 || x == 1.0 || y == 0.0 || y == 1.0;
      EXPECT_EQ(mesh.OnBoundary[static_cast<std::size_t>(id)] != 0, outside) << x << " " << y;
    }
  }
}

TEST(VirtualElementMesh, UsesListTheElementsOfAPoint)
{
  const auto mesh = MakeVirtualElementMesh(pemesh::MakeChessboard(4));
  std::size_t uses = 0;
  std::size_t unused = 0;
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    const auto i = static_cast<std::size_t>(id);
    unused += mesh.Used[i] ? 0 : 1;
    for (auto use = static_cast<std::size_t>(mesh.FirstUse[i]);
         use < static_cast<std::size_t>(mesh.FirstUse[i + 1]); ++use)
    {
      ++uses;
      EXPECT_EQ(
        mesh.Element(mesh.UseElement[use])[static_cast<std::size_t>(mesh.UsePlace[use])], id);
    }
  }
  EXPECT_EQ(uses, mesh.Corners.size());
  EXPECT_EQ(unused, 8u); // the centres of the fields that are not cut
}

TEST(VirtualElementMesh, AHoleHasABoundaryToo)
{
  pemesh::GridPoints grid(3);
  std::vector<pemesh::IdList> elements;
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (i != 1 || j != 1)
      {
        elements.push_back(
          { grid.Id(i, j), grid.Id(i + 1, j), grid.Id(i + 1, j + 1), grid.Id(i, j + 1) });
      }
    }
  }
  const auto mesh = MakeVirtualElementMesh(MakeMesh(grid.Points, elements));
  EXPECT_THAT(mesh.OnBoundary, testing::Each(1));
}

TEST(VirtualElementMesh, BadMeshesAreRefusedByName)
{
  EXPECT_THAT(WhyRefused(MakeMesh(Square, {})), HasSubstr("no polygons"));
  EXPECT_THAT(WhyRefused(MakeMesh(Square, { { 0, 1, 7 } })), HasSubstr("vertex 7"));
  EXPECT_THAT(WhyRefused(MakeMesh(Square, { { 0, 1, 2 }, { 0, 3, 2 } })), HasSubstr("Element 1"));
  EXPECT_THAT(WhyRefused(MakeMesh(Square, { { 0, 1, 2, 1 } })), HasSubstr("more than once"));
  EXPECT_THAT(
    WhyRefused(MakeMesh({ { 0, 0 }, { 1, 1 }, { 2, 2 } }, { { 0, 1, 2 } })), HasSubstr("flat"));
  auto bad = Square;
  bad[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(WhyRefused(MakeMesh(bad, { { 0, 1, 2, 3 } })), HasSubstr("Vertex 2"));
}

TEST(VirtualElementMesh, OverlapsAreRefused)
{
  EXPECT_THAT(WhyRefused(MakeMesh(Square, { { 0, 1, 2, 3 }, { 0, 1, 2 } })),
    HasSubstr("between the vertices 0 and 1 belongs to the elements 0 and 1"));
}

// Without a boundary nothing would hold the solution and the system would be singular. Some
// element of a closed surface is always clockwise in the plane, and refused as such.
TEST(VirtualElementMesh, ClosedSurfacesAreRefused)
{
  EXPECT_THAT(
    WhyRefused(MakeMesh({ { 0, 0 }, { 1, 0 }, { 0.4, 1 } }, { { 0, 1, 2 }, { 0, 2, 1 } })),
    HasSubstr("Element 1"));
  EXPECT_THAT(WhyRefused(MakeMesh({ { 0, 0 }, { 1, 0 }, { 0.4, 1 }, { 0.4, 0.3 } },
                { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } })),
    HasSubstr("Element 3"));
}

// A square beside two halves of its right neighbour, in every direction; shared vertices are fine.
TEST(VirtualElementMethodMesh, TJunctionsAreRefused)
{
  for (int turn = 0; turn < 8; ++turn)
  {
    const double angle = 0.7 * turn;
    std::vector<pemesh::Point2> points{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 2, 1 },
      { 1, 0.4 }, { 2, 0.4 } };
    for (pemesh::Point2& p : points)
    {
      p = { 3.0 + std::cos(angle) * p.x - std::sin(angle) * p.y,
        std::sin(angle) * p.x + std::cos(angle) * p.y };
    }
    EXPECT_THAT(WhyRefused(MakeMesh(points, { { 0, 1, 2, 3 }, { 1, 4, 7, 6 }, { 6, 7, 5, 2 } })),
      HasSubstr("Vertex 6 lies on the edge between 1 and 2 of element 0"))
      << turn;
    EXPECT_EQ(WhyRefused(MakeMesh(points, { { 0, 1, 6, 2, 3 }, { 1, 4, 7, 6 }, { 6, 7, 5, 2 } })),
      "accepted");
  }
}

// The search is by rows of a grid: a long edge in any direction, and many short ones on it.
TEST(VirtualElementMethodMesh, ATJunctionIsFoundWhereverItLies)
{
  for (int hanging = 1; hanging < 40; hanging += 3)
  {
    std::vector<pemesh::Point2> points{ { 0, 0 }, { 7, 3 }, { 2, 5 } };
    std::vector<pemesh::IdList> elements{ { 0, 1, 2 } };
    points.push_back({ 5, -4 });
    const double t = hanging / 40.0;
    points.push_back({ 7 * t, 3 * t });
    elements.push_back({ 0, 3, 4 });
    EXPECT_THAT(WhyRefused(MakeMesh(points, elements)), HasSubstr("Vertex 4 lies on")) << hanging;
  }
}

} // namespace

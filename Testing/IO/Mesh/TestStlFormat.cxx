// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

using namespace pemesh;

namespace
{

/** Twice the area, by the shoelace formula in long double. */
long double TwiceArea(vtkPolyData* mesh)
{
  long double sum = 0.0L;
  for (const auto& polygon : PolygonsOf(mesh))
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      double p[3];
      double q[3];
      mesh->GetPoint(polygon[i], p);
      mesh->GetPoint(polygon[(i + 1) % polygon.size()], q);
      sum += static_cast<long double>(p[0]) * q[1] - static_cast<long double>(q[0]) * p[1];
    }
  }
  return sum;
}

} // namespace

TEST(StlFormat, ReadsTextAndMergesCorners)
{
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  // The second triangle is clockwise, and one of its corners has -0 where the first has 0.
  WriteBytes(path,
    "solid a name # of words\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n"
    "   vertex 1e0 0 0\n   vertex 1 1 0\n  endloop\n endfacet\nfacet normal 0 0 -1\nouter loop\n"
    "vertex -0.0 0 0\nvertex 0 1 0\nvertex 1 1 -0\nendloop\nendfacet\nendsolid a name\n");
  ExpectSameMesh(ReadMesh(path),
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
}

TEST(StlFormat, MergesExactDuplicatesOnly)
{
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  WriteBytes(path,
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1.0000000000000002 0 0\nvertex 1 1 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  EXPECT_EQ(ReadMesh(path)->GetNumberOfPoints(), 5);
}

TEST(StlFormat, ReadsBinaryEvenIfItBeginsWithSolid)
{
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  std::string text = "solid, says a binary file";
  text.resize(80, ' ');
  text += std::string("\1\0\0\0", 4);
  const float triangle[12] = { 0, 0, 1, 0, 0, 0, 0.1F, 0, 0, 0, 0.5F, 0 };
  text.append(reinterpret_cast<const char*>(triangle), sizeof(triangle));
  text.append("\7\7");
  WriteBytes(path, text);
  ExpectSameMesh(
    ReadMesh(path), MakeTestMesh({ { 0, 0 }, { 0.1F, 0 }, { 0, 0.5 } }, { { 0, 1, 2 } }));
}

TEST(StlFormat, WritesTrianglesThatFillThePolygons)
{
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  // A concave polygon in the unit square, and the notch.
  const auto mesh = MakeTestMesh(
    { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.5, 0.1 }, { 0, 1 } }, { { 0, 1, 2, 3, 4 }, { 4, 3, 2 } });
  WriteMesh(path, mesh);
  const auto triangles = ReadMesh(path);
  EXPECT_EQ(triangles->GetNumberOfPolys(), 4);
  EXPECT_EQ(triangles->GetNumberOfPoints(), 5);
  EXPECT_NEAR(static_cast<double>(TwiceArea(triangles)), 2.0, 1e-15);
  double area = 0.0;
  for (const auto& triangle : PolygonsOf(triangles)) // none is counted with a negative area
  {
    const auto one = MakeTestMesh({ { 0, 0 } }, { triangle });
    one->SetPoints(triangles->GetPoints());
    area += std::abs(static_cast<double>(TwiceArea(one)));
  }
  EXPECT_NEAR(area, 2.0, 1e-15);
}

TEST(StlFormat, TrianglesKeepTheirBits)
{
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  const auto mesh =
    MakeTestMesh({ { 0.1, 1.0 / 3.0 }, { 0.7, 1e-17 }, { 2.0 / 3.0, 0.9 } }, { { 0, 1, 2 } });
  WriteMesh(path, mesh);
  const auto again = ReadMesh(path);
  std::vector<std::uint64_t> expected = CoordinateBits(mesh);
  std::vector<std::uint64_t> actual = CoordinateBits(again);
  std::sort(expected.begin(), expected.end());
  std::sort(actual.begin(), actual.end());
  EXPECT_EQ(actual, expected);
}

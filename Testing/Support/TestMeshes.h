// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Small meshes made by hand, and their comparison bit by bit.
 */
#ifndef pemesh_TestMeshes_h
#define pemesh_TestMeshes_h

#include "Point2.h"
#include "TestFolder.h"

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

namespace pemesh
{

using TestPolygons = std::vector<std::vector<vtkIdType>>;

inline vtkSmartPointer<vtkPolyData> MakeTestMesh(
  const std::vector<Point2>& vertices, const TestPolygons& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point2& vertex : vertices)
  {
    points->InsertNextPoint(vertex.x, vertex.y, 0.0);
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/** The unit square as one square and, on its right, two triangles. */
inline vtkSmartPointer<vtkPolyData> MakeHouse()
{
  return MakeTestMesh({ { 0, 0 }, { 0.5, 0 }, { 0.5, 1 }, { 0, 1 }, { 1, 0 }, { 1, 1 } },
    { { 0, 1, 2, 3 }, { 1, 4, 2 }, { 4, 5, 2 } });
}

/** Numbers that a careless writer or reader changes, and a vertex that no element uses. */
inline vtkSmartPointer<vtkPolyData> MakeAwkwardMesh()
{
  return MakeTestMesh(
    { { 0.1, 1.0 / 3.0 }, { 1e-300, -0.0 }, { 1.7976931348623157e308, 5e-324 },
      { 0.30000000000000004, 1e-17 }, { 2.0 / 3.0, 123456789.12345679 }, { -0.7, 1e22 } },
    { { 1, 3, 4, 0 }, { 0, 4, 5 } });
}

/** n x n squares of the unit square, their vertices moved a little, half of them cut in two. */
inline vtkSmartPointer<vtkPolyData> MakeJitteredGrid(int n, std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  const auto random = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<Point2> vertices;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const bool inside = i > 0 && i < n && j > 0 && j < n;
      const double dx = inside ? 0.4 * (random() - 0.5) : 0.0;
      const double dy = inside ? 0.4 * (random() - 0.5) : 0.0;
      vertices.push_back({ (i + dx) / n, (j + dy) / n });
    }
  }
  TestPolygons polygons;
  for (vtkIdType j = 0; j < n; ++j)
  {
    for (vtkIdType i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i;
      const vtkIdType c = a + n + 2;
      if ((i + j) % 2 == 0)
      {
        polygons.push_back({ a, a + 1, c, c - 1 });
      }
      else
      {
        polygons.push_back({ a, a + 1, c });
        polygons.push_back({ a, c, c - 1 });
      }
    }
  }
  return MakeTestMesh(vertices, polygons);
}

inline TestPolygons PolygonsOf(vtkPolyData* mesh)
{
  TestPolygons polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    polygons.emplace_back(ids->begin(), ids->end());
  }
  return polygons;
}

/** The bits of the coordinates: -0 is not 0 here. */
inline std::vector<std::uint64_t> CoordinateBits(vtkPolyData* mesh)
{
  std::vector<std::uint64_t> bits;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    for (const double coordinate : point)
    {
      bits.push_back(std::bit_cast<std::uint64_t>(coordinate));
    }
  }
  return bits;
}

inline void ExpectSameMesh(vtkPolyData* actual, vtkPolyData* expected)
{
  ASSERT_TRUE(actual && actual->GetPoints());
  EXPECT_EQ(actual->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(CoordinateBits(actual), CoordinateBits(expected));
  EXPECT_EQ(PolygonsOf(actual), PolygonsOf(expected));
}

inline void WriteBytes(const std::filesystem::path& path, std::string_view bytes)
{
  // Removed first: to overwrite a file in place makes some file systems wait for the disk.
  std::filesystem::remove(path);
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string ReadBytes(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

} // namespace pemesh

#endif

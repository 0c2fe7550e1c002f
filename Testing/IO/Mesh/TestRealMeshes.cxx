// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes that others have published: read, checked against what is known of them, written in
 * every format and read again.
 */
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <algorithm>
#include <map>

using namespace pemesh;

namespace
{

std::vector<std::filesystem::path> MeshesIn(const char* folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(
         std::filesystem::path(PEMESH_TEST_DATA) / "Meshes" / folder))
  {
    if (FindMeshFormatOfFile(entry.path()))
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/** Counter-clockwise elements fill the unit square, and the edges inside have two of them. */
void ExpectMeshOfUnitSquare(vtkPolyData* mesh)
{
  long double twiceArea = 0.0L;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (const auto& polygon : PolygonsOf(mesh))
  {
    long double own = 0.0L;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const vtkIdType from = polygon[i];
      const vtkIdType to = polygon[(i + 1) % polygon.size()];
      double p[3];
      double q[3];
      mesh->GetPoint(from, p);
      mesh->GetPoint(to, q);
      own += static_cast<long double>(p[0]) * q[1] - static_cast<long double>(q[0]) * p[1];
      const auto directed = std::make_pair(from, to);
      EXPECT_EQ(++edges[directed], 1);
    }
    EXPECT_GT(own, 0.0L);
    twiceArea += own;
  }
  EXPECT_NEAR(static_cast<double>(twiceArea), 2.0, 1e-12);
  for (const auto& [edge, count] : edges)
  {
    double p[3];
    double q[3];
    mesh->GetPoint(edge.first, p);
    mesh->GetPoint(edge.second, q);
    const bool boundary =
      (p[0] == q[0] && (p[0] == 0 || p[0] == 1)) || (p[1] == q[1] && (p[1] == 0 || p[1] == 1));
    EXPECT_EQ(edges.count({ edge.second, edge.first }), boundary ? 0U : 1U);
  }
}

} // namespace

class RealMeshes : public testing::TestWithParam<const char*>
{
};

TEST_P(RealMeshes, AreReadWholeAndSurviveEveryFormat)
{
  const auto paths = MeshesIn(GetParam());
  ASSERT_FALSE(paths.empty());
  const std::filesystem::path folder = TestFolder();
  for (const auto& path : paths)
  {
    SCOPED_TRACE(path.filename());
    const auto mesh = ReadMesh(path);
    ExpectMeshOfUnitSquare(mesh);
    for (const MeshFormat& format : MeshFormats())
    {
      if (format.KeepsVertices && format.MostCorners == 0)
      {
        const std::filesystem::path copy = folder / ("copy" + std::string(format.Extensions[0]));
        format.Write(copy, mesh);
        ExpectSameMesh(ReadMesh(copy), mesh);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, RealMeshes, testing::Values("exercise_1_2", "vem_quality_2d"),
  [](const auto& test) { return std::string(test.param); });

TEST(RealMeshes, HaveTheirCounts)
{
  EXPECT_EQ(MeshesIn("exercise_1_2").size(), 11U);
  EXPECT_EQ(MeshesIn("vem_quality_2d").size(), 17U);
  const std::filesystem::path data = std::filesystem::path(PEMESH_TEST_DATA) / "Meshes";
  const auto off = ReadMesh(data / "exercise_1_2" / "009_0.426316.off");
  EXPECT_EQ(off->GetNumberOfPoints(), 132);
  EXPECT_EQ(off->GetNumberOfPolys(), 157);
  EXPECT_EQ(off->GetPoint(0)[0], 0.056891649440013348);
  const auto slices = ReadMesh(data / "vem_quality_2d" / "Slices0.off");
  EXPECT_EQ(slices->GetNumberOfPoints(), 7);
  EXPECT_EQ(PolygonsOf(slices)[0], (std::vector<vtkIdType>{ 1, 5, 3, 4 }));
}

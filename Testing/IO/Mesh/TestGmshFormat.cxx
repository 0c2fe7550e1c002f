// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

using namespace pemesh;

namespace
{

vtkSmartPointer<vtkPolyData> ReadText(const std::string& text)
{
  const std::filesystem::path path = TestFolder() / "mesh.msh";
  WriteBytes(path, text);
  return ReadMesh(path);
}

} // namespace

TEST(GmshFormat, VersionTwoWithLinesGroupsAndData)
{
  // Tags with gaps and out of order, as after the removal of entities.
  const auto mesh =
    ReadText("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
             "$PhysicalNames\n1\n2 7 \"a # b\"\n$EndPhysicalNames\n"
             "$Nodes\n5\n10 0 0 0\n3 1 0 0\n4 1 1 0\n7 0 1 0\n9 0.5 2 0\n$EndNodes\n"
             "$Elements\n4\n1 15 2 0 1 10\n2 1 2 5 1 10 3\n"
             "3 3 2 7 1 10 3 4 7\n4 2 3 7 1 0 7 4 9\n$EndElements\n"
             "$NodeData\n1\n\"u\"\n$EndNodeData\n");
  ExpectSameMesh(mesh,
    MakeTestMesh(
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 2 } }, { { 0, 1, 2, 3 }, { 3, 2, 4 } }));
}

TEST(GmshFormat, VersionFourInBlocks)
{
  // The unit square as Gmsh 4.8 writes it: entities, nodes by entity, one of them parametric.
  const auto mesh = ReadText("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                             "$Entities\n1 1 1 0\n1 0 0 0 0\n1 0 0 0 1 0 0 0 2 1 -2\n"
                             "1 0 0 0 1 1 0 0 1 1\n$EndEntities\n"
                             "$Nodes\n3 5 1 5\n0 1 0 1\n1\n0 0 0\n"
                             "1 1 1 1\n2\n1 0 0 0.5\n2 1 0 3\n3\n4\n5\n1 1 0\n0 1 0\n0.5 0.5 0\n"
                             "$EndNodes\n$Elements\n2 4 1 4\n1 1 1 1\n1 1 2\n2 1 2 3\n"
                             "2 1 2 5\n3 2 3 5\n4 5 3 4\n$EndElements\n");
  ExpectSameMesh(mesh,
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 0.5 } },
      { { 0, 1, 4 }, { 1, 2, 4 }, { 4, 2, 3 } }));
}

TEST(GmshFormat, KeepsTrianglesAndQuadrilateralsToTheBit)
{
  const std::filesystem::path path = TestFolder() / "mesh.msh";
  for (const auto& mesh : { MakeHouse(), MakeJitteredGrid(20, 5), MakeAwkwardMesh() })
  {
    WriteMesh(path, mesh);
    ExpectSameMesh(ReadMesh(path), mesh);
  }
}

TEST(GmshFormat, LargerElementsAreCutAndFilled)
{
  // An L of area 3: its triangles must not fill the notch.
  const auto mesh = MakeTestMesh(
    { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }, { { 0, 1, 2, 3, 4, 5 } });
  const std::filesystem::path path = TestFolder() / "mesh.msh";
  WriteMesh(path, mesh);
  const auto cut = ReadMesh(path);
  EXPECT_EQ(cut->GetNumberOfPolys(), 4);
  EXPECT_EQ(CoordinateBits(cut), CoordinateBits(mesh));
  double area = 0.0;
  for (const auto& triangle : PolygonsOf(cut))
  {
    double p[3][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      cut->GetPoint(triangle[i], p[i]);
    }
    area +=
      0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
  }
  EXPECT_DOUBLE_EQ(area, 3.0);
}

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <algorithm>

using namespace pemesh;

namespace
{

vtkSmartPointer<vtkPolyData> ReadText(const std::string& text)
{
  const std::filesystem::path path = TestFolder() / "mesh.ply";
  WriteBytes(path, text);
  return ReadMesh(path);
}

/** The bytes of numbers in the order asked for. */
template <typename Value>
void Append(std::string& bytes, Value value, bool bigEndian)
{
  std::string own(reinterpret_cast<const char*>(&value), sizeof(value));
  if (bigEndian)
  {
    std::reverse(own.begin(), own.end());
  }
  bytes += own;
}

} // namespace

TEST(PlyFormat, TextWithColoursNormalsAndEdges)
{
  const auto mesh = ReadText("ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info x\r\n"
                             "element vertex 5\r\nproperty float x\r\nproperty float y\r\n"
                             "property float z\r\nproperty uchar red\r\n"
                             "element face 2\r\nproperty list uchar int vertex_index\r\n"
                             "property list uchar float texcoord\r\n"
                             "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\n"
                             "end_header\r\n0 0 0 255\r\n1 0 0 1\r\n1 1 0 2\r\n0.1 1 0 3\r\n"
                             "0 1 -0 4\r\n5 0 1 2 3 4 0\r\n3 0 1 2 2 0.5 0.5\r\n0 1\r\n");
  ExpectSameMesh(mesh,
    MakeTestMesh(
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.1, 1 }, { 0, 1 } }, { { 0, 1, 2, 3, 4 }, { 0, 1, 2 } }));
}

TEST(PlyFormat, BinaryOfBothOrdersKeepsDoubles)
{
  for (const bool big : { false, true })
  {
    std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
      "_endian 1.0\nelement face 2\nproperty list ushort uint vertex_indices\n"
      "property char flag\nelement vertex 4\n"
      "property double x\nproperty short id\nproperty double y\nend_header\n";
    const auto house = MakeTestMesh({ { 0.1, 1e-300 }, { 1, -0.0 }, { 1.0 / 3.0, 1 }, { 0, 1 } },
      { { 0, 1, 2, 3 }, { 3, 0, 2 } });
    for (const auto& polygon : PolygonsOf(house)) // faces before vertices
    {
      Append(text, static_cast<std::uint16_t>(polygon.size()), big);
      for (const vtkIdType vertex : polygon)
      {
        Append(text, static_cast<std::uint32_t>(vertex), big);
      }
      Append(text, '\n', big);
    }
    for (vtkIdType i = 0; i < 4; ++i)
    {
      Append(text, house->GetPoint(i)[0], big);
      Append(text, std::int16_t(-7), big);
      Append(text, house->GetPoint(i)[1], big);
    }
    ExpectSameMesh(ReadText(text), house);
  }
}

TEST(PlyFormat, WritesWhatOthersRead)
{
  const std::filesystem::path path = TestFolder() / "mesh.ply";
  WriteMesh(path, MakeTestMesh({ { 0, 0 }, { 0.1, 0 }, { 0, 1 } }, { { 0, 1, 2 } }));
  EXPECT_EQ(ReadBytes(path),
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nelement face 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 0\n0.1 0 0\n0 1 0\n3 0 1 2\n");
}

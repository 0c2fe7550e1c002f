// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * OBJ, the text format of Wavefront: "v x y z" and "f a b c …", numbers from one or, negative,
 * backwards from the last vertex. Texture and normal indices (a/b/c, a//c) are skipped, and so
 * are the statements that say nothing about a planar mesh.
 */
#include "FormatFunctions.h"

#include "ElementAccess.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <array>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** Statements that a mesh may contain and that change neither its vertices nor its faces. */
constexpr std::array Ignored{ "vt", "vn", "vp", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap",
  "maplib", "l", "p", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj" };

class ObjReader
{
public:
  ObjReader(std::string_view text, const std::filesystem::path& path)
    : File(text, path, true)
    , Path(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    while (this->File.NextLine())
    {
      const std::string_view statement = this->File.Word();
      if (statement == "v")
      {
        this->ReadVertex();
      }
      else if (statement == "f")
      {
        this->ReadFace();
      }
      else if (std::find(Ignored.begin(), Ignored.end(), statement) == Ignored.end())
      {
        this->File.Fail("the line begins with no statement of an OBJ mesh (v, f, vt, vn, o, g, …)");
      }
    }
    // A face may come before its vertices, so that only now the numbers can be judged.
    const std::int64_t vertices = this->Mesh.GetNumberOfVertices();
    if (this->Mesh.GetNumberOfElements() == 0)
    {
      FailMeshFile(this->Path,
        "holds " + CountText(vertices, "vertex", "vertices") +
          " and no face; an OBJ mesh has lines \"v x y z\" and \"f a b c\"");
    }
    if (this->LargestVertex >= vertices)
    {
      this->File.FailAt(this->LargestVertexLine,
        "a face uses vertex " + std::to_string(this->LargestVertex + 1) +
          ", and the vertices are 1 to " + std::to_string(vertices));
    }
    return this->Mesh.Take();
  }

private:
  void ReadVertex()
  {
    const double x = this->File.Coordinate();
    const double y = this->File.Coordinate();
    this->File.ZeroCoordinate();
    constexpr int mostExtras = 4; // a weight, or a colour with or without opacity
    for (int i = 0; i < mostExtras && !this->File.AtLineEnd(); ++i)
    {
      this->File.SkipNumber("a coordinate, a weight or a colour");
    }
    this->File.NeedLineEnd("a vertex");
    this->Mesh.AddVertex(x, y);
  }

  void ReadFace()
  {
    std::int64_t corners = 0;
    for (; !this->File.AtLineEnd(); ++corners)
    {
      this->Mesh.AddCorner(this->ReadCorner());
    }
    if (corners < 3)
    {
      this->File.Fail(
        "a face has " + CountText(corners, "vertex", "vertices") + " and needs three or more");
    }
    this->Mesh.EndElement();
  }

  std::int64_t ReadCorner()
  {
    const std::int64_t number = this->File.Index("a vertex of the face");
    const std::int64_t vertices = this->Mesh.GetNumberOfVertices();
    if (number == 0 || number < -vertices)
    {
      this->File.Fail("a face uses vertex " + std::to_string(number) + " where " +
        CountText(vertices, "vertex is", "vertices are") +
        " known; they count from 1, or back from -1");
    }
    const std::int64_t vertex = number > 0 ? number - 1 : vertices + number;
    if (vertex > this->LargestVertex)
    {
      this->LargestVertex = vertex;
      this->LargestVertexLine = this->File.GetLine();
    }
    return vertex;
  }

  LineScanner File;
  const std::filesystem::path& Path;
  MeshBuilder Mesh;
  std::int64_t LargestVertex = -1;
  std::size_t LargestVertexLine = 0;
};

} // namespace

vtkSmartPointer<vtkPolyData> ReadObj(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  return ObjReader(text, path).Read();
}

void WriteObj(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  AppendVertices(text, "v ", mesh);
  ElementAccess elements(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    text.Append('f');
    for (const vtkIdType id : ids)
    {
      text.Append(' ');
      text.AppendValue(id + 1);
    }
    text.Append('\n');
  }
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

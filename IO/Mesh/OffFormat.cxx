// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * OFF, the object file format of Geomview: a header, the three counts, one vertex a line, one
 * face a line with its number of vertices first and, perhaps, a colour last.
 * http://www.geomview.org/docs/html/OFF.html
 */
#include "FormatFunctions.h"

#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr std::size_t LeastBytesOfVertex = 6; // "0 0 0\n"
constexpr std::size_t LeastBytesOfFace = 8;   // "3 0 1 2\n"

bool IsNumber(std::string_view word)
{
  return !word.empty() && word.find_first_not_of("+-0123456789") == std::string_view::npos;
}

/** Whether vertices carry normals, colours or texture coordinates after their position. */
bool ReadHeader(LineScanner& file)
{
  file.NeedLine("the word OFF");
  std::string word(file.PeekWord());
  if (IsNumber(word))
  {
    return false; // some programs begin with the counts
  }
  std::transform(word.begin(), word.end(), word.begin(),
    [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  const std::size_t prefix = word.size() < 3 ? 0 : word.size() - 3;
  const bool known = word.substr(prefix) == "OFF" &&
    word.substr(0, prefix).find_first_not_of("STCN") == std::string::npos;
  if (!known)
  {
    file.Fail("an OFF file of planar points must begin with the word OFF");
  }
  file.Word();
  return prefix > 0;
}

struct Counts
{
  std::int64_t Vertices;
  std::int64_t Faces;
};

/** It may be missing, or alone on the next line, where a vertex has three numbers. */
void SkipEdgeCount(LineScanner& file)
{
  if (file.AtLineEnd())
  {
    LineScanner ahead = file;
    if (ahead.NextLine() && IsNumber(ahead.Word()) && ahead.AtLineEnd())
    {
      file = ahead;
    }
    return;
  }
  file.Integer("the number of edges");
}

Counts ReadCounts(LineScanner& file)
{
  file.NeedWord("the number of vertices"); // counts may be on lines of their own
  if (file.PeekWord() == "BINARY")
  {
    file.Fail("binary OFF is not supported; save the mesh as text");
  }
  const std::int64_t vertices = file.Integer("the number of vertices");
  file.NeedWord("the number of faces");
  const std::int64_t faces = file.Integer("the number of faces");
  SkipEdgeCount(file);
  file.NeedLineEnd("the counts");
  if (vertices < 3 || faces < 1)
  {
    file.Fail("a mesh needs at least three vertices and one face, and this one has " +
      CountText(vertices, "vertex", "vertices") + " and " + CountText(faces, "face", "faces"));
  }
  return { vertices, faces };
}

void ReadVertices(LineScanner& file, const Counts& counts, bool extras, MeshBuilder& mesh)
{
  mesh.ReserveVertices(
    std::min(static_cast<std::size_t>(counts.Vertices), file.BytesLeft() / LeastBytesOfVertex + 1));
  for (std::int64_t i = 0; i < counts.Vertices; ++i)
  {
    if (!file.NextLine())
    {
      file.Fail("the file ends after " + CountText(i, "vertex", "vertices") + " of the " +
        std::to_string(counts.Vertices) + " announced");
    }
    const double x = file.Coordinate();
    const double y = file.Coordinate();
    file.ZeroCoordinate();
    while (extras && !file.AtLineEnd())
    {
      file.SkipNumber("a number");
    }
    file.NeedLineEnd("the three coordinates of a vertex");
    mesh.AddVertex(x, y);
  }
}

void ReadFace(LineScanner& file, std::int64_t vertices, MeshBuilder& mesh)
{
  const std::int64_t corners = file.Integer("the number of vertices of a face");
  if (corners < 3)
  {
    file.Fail(
      "a face has " + CountText(corners, "vertex", "vertices") + " and needs three or more");
  }
  for (std::int64_t j = 0; j < corners; ++j)
  {
    const std::int64_t vertex = file.Integer("a vertex of the face");
    if (vertex < 0 || vertex >= vertices)
    {
      file.Fail("a face uses vertex " + std::to_string(vertex) + ", and the vertices are 0 to " +
        std::to_string(vertices - 1));
    }
    mesh.AddCorner(vertex);
  }
  mesh.EndElement();
  constexpr int mostColourValues = 4;
  for (int value = 0; value < mostColourValues && !file.AtLineEnd(); ++value)
  {
    file.SkipNumber("a vertex of the face or a value of its colour");
  }
  file.NeedLineEnd("the face and its colour");
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadOff(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  LineScanner file(text, path);
  const bool extras = ReadHeader(file);
  const Counts counts = ReadCounts(file);
  MeshBuilder mesh;
  ReadVertices(file, counts, extras, mesh);
  const auto faces = static_cast<std::size_t>(counts.Faces);
  mesh.ReserveElements(std::min(faces, file.BytesLeft() / LeastBytesOfFace + 1), 0);
  for (std::int64_t i = 0; i < counts.Faces; ++i)
  {
    if (!file.NextLine())
    {
      file.Fail("the file ends after " + CountText(i, "face", "faces") + " of the " +
        std::to_string(counts.Faces) + " announced");
    }
    ReadFace(file, counts.Vertices, mesh);
  }
  if (file.NextLine())
  {
    file.Fail("the file goes on after the " + CountText(counts.Vertices, "vertex", "vertices") +
      " and " + CountText(counts.Faces, "face", "faces") + " announced");
  }
  return mesh.Take();
}

void WriteOff(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.Append("OFF\n");
  text.AppendValue(mesh->GetNumberOfPoints());
  text.Append(' ');
  text.AppendValue(mesh->GetNumberOfPolys());
  text.Append(" 0\n");
  AppendVertices(text, "", mesh);
  AppendElements(text, mesh, 0);
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

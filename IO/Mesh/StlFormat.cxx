// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * STL, text and binary: triangles with no shared vertices. Corners with equal coordinates become
 * one vertex; normals, names and colours are dropped. Written as text, because the floats of the
 * binary form lose half the digits.
 */
#include "FormatFunctions.h"

#include "CutElements.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <bit>
#include <cstring>
#include <unordered_map>
#include <vector>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** Adds each position once. Equality is that of numbers: 0 and -0 are the same. */
class VertexMerger
{
public:
  explicit VertexMerger(MeshBuilder& mesh)
    : Mesh(mesh)
  {
  }

  std::int64_t Find(double x, double y)
  {
    const auto [entry, isNew] =
      this->Vertices.try_emplace(Position{ x + 0.0, y + 0.0 }, this->Mesh.GetNumberOfVertices());
    if (isNew)
    {
      this->Mesh.AddVertex(x, y);
    }
    return entry->second;
  }

private:
  struct Position
  {
    double X;
    double Y;
    bool operator==(const Position&) const = default;
  };
  struct Hash
  {
    std::size_t operator()(const Position& position) const
    {
      constexpr std::uint64_t odd = 0x9E3779B97F4A7C15; // 2^64 over the golden ratio
      std::uint64_t mix = std::bit_cast<std::uint64_t>(position.X) * odd;
      mix = (std::rotl(mix, 32) ^ std::bit_cast<std::uint64_t>(position.Y)) * odd;
      return mix ^ (mix >> 32);
    }
  };

  MeshBuilder& Mesh;
  std::unordered_map<Position, std::int64_t, Hash> Vertices; // looked up, never walked
};

constexpr std::size_t BinaryHeader = 84; // 80 bytes of anything and the number of triangles
constexpr std::size_t BinaryTriangle = 50;

bool IsBinary(const std::string& text)
{
  if (text.size() < BinaryHeader)
  {
    return false;
  }
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, text.data() + BinaryHeader - sizeof(triangles), sizeof(triangles));
  return text.size() == BinaryHeader + BinaryTriangle * triangles;
}

void ReadBinary(const std::string& text, const std::filesystem::path& path, MeshBuilder& mesh)
{
  VertexMerger vertices(mesh);
  std::size_t triangle = 1;
  for (std::size_t at = BinaryHeader; at < text.size(); at += BinaryTriangle, ++triangle)
  {
    float numbers[12]; // the normal, then the three corners
    std::memcpy(numbers, text.data() + at, sizeof(numbers));
    for (int corner = 3; corner < 12; corner += 3)
    {
      const float* p = numbers + corner;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || p[2] != 0.0F)
      {
        FailMeshFile(path,
          "has a corner of triangle " + std::to_string(triangle) +
            " that is not a finite point of the plane z = 0");
      }
      mesh.AddCorner(vertices.Find(p[0], p[1]));
    }
    mesh.EndElement();
  }
}

class TextStlReader
{
public:
  TextStlReader(const std::string& text, const std::filesystem::path& path, MeshBuilder& mesh)
    : File(text, path)
    , Mesh(mesh)
    , Vertices(mesh)
  {
  }

  /** A solid is "solid", facets, "endsolid"; a facet is seven lines in a fixed order. */
  void Read()
  {
    while (this->File.NextLine())
    {
      this->Expect("solid");
      this->File.NeedLine("a facet");
      while (this->File.PeekWord() == "facet")
      {
        this->ReadFacet();
        this->File.NeedLine("the next facet or the word endsolid");
      }
      this->Expect("endsolid");
    }
  }

private:
  void ReadFacet()
  {
    this->File.NeedLine("the line \"outer loop\"");
    this->Expect("outer");
    for (int corner = 0; corner < 3; ++corner)
    {
      this->File.NeedLine("a vertex");
      this->Expect("vertex");
      const double x = this->File.Coordinate();
      const double y = this->File.Coordinate();
      this->File.ZeroCoordinate();
      this->File.NeedLineEnd("a vertex");
      this->Mesh.AddCorner(this->Vertices.Find(x, y));
    }
    this->Mesh.EndElement();
    this->File.NeedLine("the word endloop");
    this->Expect("endloop");
    this->File.NeedLine("the word endfacet");
    this->Expect("endfacet");
  }

  void Expect(const char* word)
  {
    if (this->File.Word() != word)
    {
      this->File.Fail(std::string("the line should begin with the word \"") + word + '"');
    }
  }

  LineScanner File;
  MeshBuilder& Mesh;
  VertexMerger Vertices;
};

} // namespace

vtkSmartPointer<vtkPolyData> ReadStl(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  MeshBuilder mesh;
  if (IsBinary(text))
  {
    ReadBinary(text, path, mesh);
  }
  else if (text.find("solid") == text.find_first_not_of(" \t\r\n") && !text.empty())
  {
    TextStlReader(text, path, mesh).Read();
  }
  else
  {
    FailMeshFile(path,
      "is neither a text STL file, which begins with \"solid\", nor a binary one, "
      "whose size is 84 bytes and 50 for each triangle");
  }
  if (mesh.GetNumberOfElements() == 0)
  {
    FailMeshFile(path, "holds no triangles");
  }
  return mesh.Take();
}

void WriteStl(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Append("solid pemesh\n");
  ForEachCutElement(mesh, 3,
    [&](vtkIdType, std::span<const vtkIdType> triangle)
    {
      text.Append("facet normal 0 0 1\nouter loop\n");
      for (const vtkIdType vertex : triangle)
      {
        double point[3];
        mesh->GetPoint(vertex, point);
        text.Append("vertex ");
        text.AppendValue(point[0]);
        text.Append(' ');
        text.AppendValue(point[1]);
        text.Append(" 0\n");
      }
      text.Append("endloop\nendfacet\n");
    });
  text.Append("endsolid pemesh\n");
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

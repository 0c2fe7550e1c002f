// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * NODE and ELE, a pair of files. Told apart on reading by their first lines:
 *
 *   standard (Triangle, https://www.cs.cmu.edu/~quake/triangle.node.html)
 *     NODE  "vertices 2 attributes markers", then "index x y [attributes] [marker]" a line
 *     ELE   "elements corners attributes",   then "index v1 … vk [attributes]" a line
 *     Indices count from the first one in NODE, 0 or 1. Triangle knows triangles only; where the
 *     elements have different numbers of corners, "corners" is 0 and a line "index k v1 … vk".
 *   plain
 *     NODE  "vertices 0", then "x y" a line
 *     ELE   "elements",   then "k v1 … vk" a line, counted from 1
 *
 * The standard one is written by default, from 1, with boundary markers (1 on the boundary).
 */
#include "FormatFunctions.h"

#include "BoundaryVertices.h"
#include "ElementAccess.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <vector>

#include <vtkCellArray.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** The file of the pair that has this extension, in the case (.ELE, .ele) of the one given. */
std::filesystem::path Sibling(const std::filesystem::path& path, const char* lower)
{
  const std::string extension = path.extension().string();
  std::string wanted = lower;
  if (extension.size() > 1 && extension[1] >= 'A' && extension[1] <= 'Z')
  {
    std::transform(wanted.begin(), wanted.end(), wanted.begin(),
      [](char c) { return c == '.' ? c : static_cast<char>(c - 'a' + 'A'); });
  }
  std::filesystem::path sibling = path;
  return sibling.replace_extension(wanted);
}

struct Header
{
  std::array<std::int64_t, 4> Numbers{};
  int Count = 0;
};

Header ReadHeader(LineScanner& file, const char* what)
{
  file.NeedLine(what);
  Header header;
  while (header.Count < 4 && !file.AtLineEnd())
  {
    const auto i = static_cast<std::size_t>(header.Count++);
    header.Numbers[i] = file.Integer(what);
  }
  file.NeedLineEnd("the counts");
  constexpr std::int64_t mostAttributes = 1000;
  for (std::size_t i = 1; i < header.Numbers.size(); ++i)
  {
    if (header.Numbers[i] < 0 || header.Numbers[i] > mostAttributes)
    {
      file.Fail("the counts of the first line make no sense");
    }
  }
  return header;
}

/** Reads the vertices and returns the number of the first one. */
std::int64_t ReadNodeFile(const std::filesystem::path& path, MeshBuilder& mesh)
{
  const std::string text = ReadTextFile(path);
  LineScanner file(text, path);
  const auto [numbers, count] = ReadHeader(file, "the number of vertices");
  const bool standard = numbers[1] != 0;
  if (standard && numbers[1] != 2)
  {
    file.Fail(
      "the vertices have " + std::to_string(numbers[1]) + " coordinates, and a planar mesh has 2");
  }
  if (numbers[0] < 3)
  {
    file.Fail(
      "a mesh needs at least three vertices, and this one has " + std::to_string(numbers[0]));
  }
  const std::size_t leastBytes = standard ? 6 : 4; // "0 0 0\n" or "0 0\n"
  mesh.ReserveVertices(
    std::min(static_cast<std::size_t>(numbers[0]), file.BytesLeft() / leastBytes + 1));
  std::int64_t base = 1;
  for (std::int64_t i = 0; i < numbers[0]; ++i)
  {
    if (!file.NextLine())
    {
      file.Fail("the file ends after " + CountText(i, "vertex", "vertices") + " of the " +
        std::to_string(numbers[0]) + " announced");
    }
    if (standard)
    {
      const std::int64_t index = file.Integer("the number of a vertex");
      base = i == 0 ? index : base;
      if ((base != 0 && base != 1) || index != base + i)
      {
        file.Fail("vertex number " + std::to_string(index) +
          " is out of turn: the vertices count "
          "from 0 or 1, one by one");
      }
    }
    const double x = file.Coordinate();
    const double y = file.Coordinate();
    for (std::int64_t skipped = 0; standard && skipped < numbers[2] + numbers[3]; ++skipped)
    {
      file.SkipNumber("an attribute or a boundary marker");
    }
    file.NeedLineEnd("a vertex");
    mesh.AddVertex(x, y);
  }
  if (file.NextLine())
  {
    file.Fail(
      "the file goes on after the " + CountText(numbers[0], "vertex", "vertices") + " announced");
  }
  return base;
}

/** Triangle's option -o2: nodes 4 to 6 are the midpoints of the edges, not corners. */
[[noreturn]] void FailSecondOrder(const LineScanner& file)
{
  file.Fail("the elements are triangles of second order, with nodes on their edges; make them "
            "without Triangle's option -o2");
}

class ElementReader
{
public:
  ElementReader(
    std::string_view text, const std::filesystem::path& path, MeshBuilder& mesh, std::int64_t base)
    : File(text, path)
    , Mesh(mesh)
    , Base(base)
  {
  }

  void Read()
  {
    const auto [numbers, count] = ReadHeader(this->File, "the number of elements");
    const bool standard = count > 1 && (numbers[1] != 0 || count > 2);
    this->Indexed = standard;
    this->Corners = numbers[1];
    this->Attributes = standard ? numbers[2] : 0;
    this->Base = standard ? this->Base : 1;
    if (numbers[0] < 1 || (this->Corners != 0 && this->Corners < 3) || count > 3)
    {
      this->File.Fail("the counts of the first line make no sense");
    }
    const std::size_t leastBytes = 8; // "3 1 2 3\n"
    this->Mesh.ReserveElements(
      std::min(static_cast<std::size_t>(numbers[0]), this->File.BytesLeft() / leastBytes + 1), 0);
    for (std::int64_t i = 0; i < numbers[0]; ++i)
    {
      if (!this->File.NextLine())
      {
        this->File.Fail("the file ends after " + CountText(i, "element", "elements") + " of the " +
          std::to_string(numbers[0]) + " announced");
      }
      this->ReadElement(i);
    }
    if (this->File.NextLine())
    {
      this->File.Fail("the file goes on after the " + CountText(numbers[0], "element", "elements") +
        " announced");
    }
  }

private:
  void ReadElement(std::int64_t element)
  {
    if (this->Indexed)
    {
      const std::int64_t index = this->File.Integer("the number of an element");
      const std::int64_t first = element == 0 ? index : this->FirstElement;
      this->FirstElement = first;
      if ((first != 0 && first != 1) || index != first + element)
      {
        this->File.Fail("element number " + std::to_string(index) +
          " is out of turn: the elements count from 0 or 1, one by one");
      }
    }
    const std::int64_t corners = this->Corners != 0
      ? this->Corners
      : this->File.Integer("the number of vertices of an element");
    if (corners < 3)
    {
      this->File.Fail(
        "an element has " + CountText(corners, "vertex", "vertices") + " and needs three or more");
    }
    for (std::int64_t j = 0; j < corners; ++j)
    {
      this->Mesh.AddCorner(this->ReadCorner());
    }
    this->Mesh.EndElement();
    for (std::int64_t j = 0; j < this->Attributes; ++j)
    {
      this->File.SkipNumber("an attribute");
    }
    this->File.NeedLineEnd("an element");
    if (this->Corners == 6 && element == 0 && this->Mesh.LooksSecondOrder())
    {
      FailSecondOrder(this->File);
    }
  }

  std::int64_t ReadCorner()
  {
    const std::int64_t vertex = this->File.Integer("a vertex of the element");
    const std::int64_t vertices = this->Mesh.GetNumberOfVertices();
    if (vertex < this->Base || vertex - this->Base >= vertices)
    {
      this->File.Fail("an element uses vertex " + std::to_string(vertex) +
        ", and the vertices are " + std::to_string(this->Base) + " to " +
        std::to_string(vertices - 1 + this->Base));
    }
    return vertex - this->Base;
  }

  LineScanner File;
  MeshBuilder& Mesh;
  std::int64_t Base;
  std::int64_t FirstElement = 1;
  std::int64_t Corners = 0; // of every element, or 0 where each line says how many
  std::int64_t Attributes = 0;
  bool Indexed = false;
};

void WriteNodeFile(const std::filesystem::path& path, vtkPolyData* mesh, bool standard)
{
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.AppendValue(mesh->GetNumberOfPoints());
  text.Append(standard ? " 2 0 1\n" : " 0\n");
  const std::vector<char> markers = standard ? MarkBoundaryVertices(mesh) : std::vector<char>();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    if (standard)
    {
      text.AppendValue(i + 1);
      text.Append(' ');
    }
    text.AppendValue(point[0]);
    text.Append(' ');
    text.AppendValue(point[1]);
    if (standard)
    {
      text.Append(markers[static_cast<std::size_t>(i)] ? " 1" : " 0");
    }
    text.Append('\n');
  }
  WriteTextFile(path, text.GetText());
}

void WriteElementFile(const std::filesystem::path& path, vtkPolyData* mesh, bool standard)
{
  const bool triangles = mesh->GetPolys()->GetMaxCellSize() == 3;
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.AppendValue(mesh->GetNumberOfPolys());
  text.Append(!standard ? "\n" : triangles ? " 3 0\n" : " 0 0\n");
  ElementAccess elements(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    if (standard)
    {
      text.AppendValue(i + 1);
      text.Append(' ');
    }
    if (!standard || !triangles)
    {
      text.AppendValue(ids.size());
      text.Append(' ');
    }
    for (std::size_t j = 0; j < ids.size(); ++j)
    {
      text.Append(j == 0 ? "" : " ");
      text.AppendValue(ids[j] + 1);
    }
    text.Append('\n');
  }
  WriteTextFile(path, text.GetText());
}

void WritePair(const std::filesystem::path& path, vtkPolyData* mesh, bool standard)
{
  CheckWritable(path, mesh);
  WriteNodeFile(Sibling(path, ".node"), mesh, standard);
  WriteElementFile(Sibling(path, ".ele"), mesh, standard);
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadNode(const std::filesystem::path& path)
{
  MeshBuilder mesh;
  const std::int64_t base = ReadNodeFile(Sibling(path, ".node"), mesh);
  const std::filesystem::path elements = Sibling(path, ".ele");
  const std::string text = ReadTextFile(elements);
  ElementReader(text, elements, mesh, base).Read();
  return mesh.Take();
}

void WriteNode(const std::filesystem::path& path, vtkPolyData* mesh)
{
  WritePair(path, mesh, true);
}

void WriteNodePlain(const std::filesystem::path& path, vtkPolyData* mesh)
{
  WritePair(path, mesh, false);
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * MSH, the format of Gmsh, versions 2 and 4.1 as text (Gmsh reference manual, chapter "Gmsh file
 * formats", https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format). Read are the nodes and the
 * triangles and quadrilaterals of first order; points and lines, physical groups and data are
 * skipped. Written is version 2.2, which every program reads.
 */
#include "FormatFunctions.h"

#include "CutElements.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr std::int64_t Triangle = 2;
constexpr std::int64_t Quadrilateral = 3;
/** Points and lines of any order. */
constexpr std::array<std::int64_t, 6> Skipped{ 15, 1, 8, 26, 27, 28 };

/** Which vertex a tag names: tags are any positive numbers in any order. */
class NodeTags
{
public:
  void Add(std::int64_t tag)
  {
    this->Tags.emplace_back(tag, static_cast<std::int64_t>(this->Tags.size()));
  }

  /** After the last one: a tag that stands twice, or 0. */
  std::int64_t Sort()
  {
    std::sort(this->Tags.begin(), this->Tags.end());
    const auto twice = std::adjacent_find(this->Tags.begin(), this->Tags.end(),
      [](const auto& a, const auto& b) { return a.first == b.first; });
    return twice == this->Tags.end() ? 0 : twice->first;
  }

  /** The vertex, or -1. */
  std::int64_t Find(std::int64_t tag) const
  {
    // Nearly all files count from 1 without a gap.
    const auto guess = static_cast<std::size_t>(tag - 1);
    if (tag > 0 && guess < this->Tags.size() && this->Tags[guess].first == tag)
    {
      return this->Tags[guess].second;
    }
    const auto found =
      std::lower_bound(this->Tags.begin(), this->Tags.end(), std::make_pair(tag, std::int64_t(0)));
    return found == this->Tags.end() || found->first != tag ? -1 : found->second;
  }

private:
  std::vector<std::pair<std::int64_t, std::int64_t>> Tags;
};

class GmshReader
{
public:
  GmshReader(std::string_view text, const std::filesystem::path& path)
    : File(text, path)
    , Path(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    this->ReadFormat();
    while (this->File.NextLine())
    {
      const std::string_view section = this->File.Word();
      if (section == "$Nodes")
      {
        this->ReadNodes();
      }
      else if (section == "$Elements")
      {
        this->ReadElements();
      }
      else if (section.substr(0, 1) != "$")
      {
        this->File.Fail("a section should begin with $ and its name");
      }
      this->SkipTo("$End" + std::string(section.substr(1)));
    }
    if (this->Mesh.GetNumberOfElements() == 0)
    {
      FailMeshFile(this->Path, "holds no triangles or quadrilaterals");
    }
    return this->Mesh.Take();
  }

private:
  void ReadFormat()
  {
    this->File.NeedLine("the line $MeshFormat");
    if (this->File.Word() != "$MeshFormat")
    {
      this->File.Fail("a file of Gmsh must begin with the line $MeshFormat");
    }
    this->File.NeedLine("the version");
    const std::string_view version = this->File.Word();
    this->IsVersion4 = version == "4.1";
    if (!this->IsVersion4 && version != "2" && version.substr(0, 2) != "2.")
    {
      this->File.Fail("the version is none of 2.2 and 4.1; save the mesh with one of these");
    }
    if (this->File.Integer("the type of the file") != 0)
    {
      this->File.Fail("the file is binary; save the mesh as text (Mesh.Binary = 0)");
    }
    this->SkipTo("$EndMeshFormat");
  }

  void SkipTo(const std::string& end)
  {
    while (this->File.Word() != end)
    {
      this->File.NeedLine(("the line " + end).c_str());
    }
  }

  std::int64_t Count(const char* what)
  {
    const std::int64_t count = this->File.Integer(what);
    if (count < 0)
    {
      this->File.Fail(std::string(what) + " is negative");
    }
    return count;
  }

  void ReadNodes()
  {
    if (this->Mesh.GetNumberOfVertices() > 0)
    {
      this->File.Fail("the nodes stand in the file twice");
    }
    this->File.NeedLine("the number of nodes");
    const std::int64_t blocks = this->IsVersion4 ? this->Count("the number of blocks") : 1;
    const std::int64_t nodes = this->Count("the number of nodes");
    constexpr std::size_t leastBytes = 8; // "1 0 0 0\n"
    this->Mesh.ReserveVertices(
      std::min(static_cast<std::size_t>(nodes), this->File.BytesLeft() / leastBytes + 1));
    for (std::int64_t i = 0; this->IsVersion4 && i < blocks; ++i)
    {
      this->ReadNodeBlock();
    }
    for (std::int64_t i = 0; !this->IsVersion4 && i < nodes; ++i)
    {
      this->File.NeedLine("a node that was announced");
      this->Tags.Add(this->File.Integer("the number of a node"));
      this->ReadNode();
    }
    if (const std::int64_t twice = this->Tags.Sort())
    {
      this->File.Fail("two nodes have the number " + std::to_string(twice));
    }
  }

  /** Of version 4: all tags, then all coordinates. */
  void ReadNodeBlock()
  {
    this->File.NeedLine("a block of nodes");
    this->File.Integer("the dimension of an entity");
    this->File.Integer("the number of an entity");
    this->File.Integer("whether nodes have parameters");
    const std::int64_t nodes = this->Count("the number of nodes of a block");
    for (std::int64_t i = 0; i < nodes; ++i)
    {
      this->File.NeedLine("the number of a node");
      this->Tags.Add(this->File.Integer("the number of a node"));
    }
    for (std::int64_t i = 0; i < nodes; ++i)
    {
      this->File.NeedLine("a node that was announced");
      this->ReadNode();
    }
  }

  void ReadNode()
  {
    const double x = this->File.Coordinate();
    const double y = this->File.Coordinate();
    this->File.ZeroCoordinate(); // parameters of the entity may follow
    this->Mesh.AddVertex(x, y);
  }

  void ReadElements()
  {
    this->File.NeedLine("the number of elements");
    if (!this->IsVersion4)
    {
      const std::int64_t elements = this->Count("the number of elements");
      for (std::int64_t i = 0; i < elements; ++i)
      {
        this->ReadElement2();
      }
      return;
    }
    const std::int64_t blocks = this->Count("the number of blocks");
    for (std::int64_t i = 0; i < blocks; ++i)
    {
      this->File.NeedLine("a block of elements");
      this->File.Integer("the dimension of an entity");
      this->File.Integer("the number of an entity");
      const std::int64_t type = this->File.Integer("the type of elements");
      const std::int64_t elements = this->Count("the number of elements of a block");
      for (std::int64_t j = 0; j < elements; ++j)
      {
        this->File.NeedLine("an element that was announced");
        this->File.Integer("the number of an element");
        this->ReadCorners(type);
      }
    }
  }

  /** Of version 2: number, type, tags, nodes. */
  void ReadElement2()
  {
    this->File.NeedLine("an element that was announced");
    this->File.Integer("the number of an element");
    const std::int64_t type = this->File.Integer("the type of an element");
    const std::int64_t tags = this->Count("the number of tags");
    for (std::int64_t i = 0; i < tags; ++i)
    {
      this->File.Integer("a tag of the element");
    }
    this->ReadCorners(type);
  }

  void ReadCorners(std::int64_t type)
  {
    if (std::find(Skipped.begin(), Skipped.end(), type) != Skipped.end())
    {
      return;
    }
    if (type != Triangle && type != Quadrilateral)
    {
      this->File.Fail("an element has the type " + std::to_string(type) +
        ", and a planar mesh has triangles and quadrilaterals of first order (2 and 3)");
    }
    const int corners = type == Triangle ? 3 : 4;
    for (int i = 0; i < corners; ++i)
    {
      const std::int64_t tag = this->File.Integer("a node of the element");
      const std::int64_t vertex = this->Tags.Find(tag);
      if (vertex < 0)
      {
        this->File.Fail("an element uses node " + std::to_string(tag) + ", which is not known");
      }
      this->Mesh.AddCorner(vertex);
    }
    this->File.NeedLineEnd("the nodes of an element");
    this->Mesh.EndElement();
  }

  LineScanner File;
  const std::filesystem::path& Path;
  MeshBuilder Mesh;
  NodeTags Tags;
  bool IsVersion4 = false;
};

} // namespace

vtkSmartPointer<vtkPolyData> ReadGmsh(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  return GmshReader(text, path).Read();
}

void WriteGmsh(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.Append("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n");
  text.AppendValue(mesh->GetNumberOfPoints());
  text.Append('\n');
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    text.AppendValue(i + 1);
    text.Append(' ');
    text.AppendValue(point[0]);
    text.Append(' ');
    text.AppendValue(point[1]);
    text.Append(" 0\n");
  }
  TextBuffer lines;
  std::int64_t count = 0;
  ForEachCutElement(mesh, 4,
    [&](vtkIdType, std::span<const vtkIdType> element)
    {
      lines.AppendValue(++count);
      // Two tags are usual: the physical group 1 and the elementary entity 1.
      lines.Append(element.size() == 3 ? " 2 2 1 1" : " 3 2 1 1");
      for (const vtkIdType vertex : element)
      {
        lines.Append(' ');
        lines.AppendValue(vertex + 1);
      }
      lines.Append('\n');
    });
  text.Append("$EndNodes\n$Elements\n");
  text.AppendValue(count);
  text.Append('\n');
  text.Append(lines.GetText());
  text.Append("$EndElements\n");
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

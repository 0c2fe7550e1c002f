// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * VTK's legacy format, versions 1 to 5, text and binary, POLYDATA and UNSTRUCTURED_GRID (VTK File
 * Formats, https://docs.vtk.org). Arrays of points and cells, which come last, are not read. An
 * own reader because VTK's takes whatever memory a header asks for, and follows the numbers of
 * a damaged file beyond its arrays.
 */
#include "FormatFunctions.h"

#include "BinaryScanner.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr NumberTypeName TypeNames[] = { { "float", NumberType::Float32 },
  { "double", NumberType::Float64 }, { "int", NumberType::Int32 },
  { "vtkIdType", NumberType::Int32 }, // so it is in these files
  { "unsigned_int", NumberType::UInt32 }, { "long", NumberType::Int64 },
  { "vtktypeint64", NumberType::Int64 }, { "short", NumberType::Int16 },
  { "unsigned_short", NumberType::UInt16 }, { "char", NumberType::Int8 },
  { "unsigned_char", NumberType::UInt8 } };

/** What may follow the words between which METADATA stands. */
constexpr std::array Keywords{ "POINTS", "VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS",
  "CELLS", "CELL_TYPES", "POINT_DATA", "CELL_DATA", "OFFSETS", "CONNECTIVITY", "FIELD" };

/** Cells as the file has them: cell i has the corners between its offset and the next one. */
struct CellList
{
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<std::int64_t> Connectivity;
};

class LegacyReader
{
public:
  LegacyReader(std::string_view text, const std::filesystem::path& path)
    : File(text, path)
    , Path(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    this->ReadHeader();
    while (!this->AtData && this->File.NextLine())
    {
      this->ReadSection();
    }
    if (this->Types.empty())
    {
      this->Types.assign(this->Cells.Offsets.size() - 1, VTK_POLYGON);
    }
    if (this->Types.size() + 1 != this->Cells.Offsets.size())
    {
      FailMeshFile(this->Path, "has not as many cells as types of cells");
    }
    for (std::size_t i = 0; i < this->Types.size(); ++i)
    {
      this->AddCell(i);
    }
    if (this->Mesh.GetNumberOfElements() == 0)
    {
      FailMeshFile(this->Path, "holds no polygons");
    }
    return this->Mesh.Take();
  }

private:
  void ReadHeader()
  {
    this->File.EndLine(); // "# vtk DataFile Version", which was looked at
    this->File.EndLine(); // a title
    this->File.NeedLine("the word ASCII or BINARY");
    const std::string_view form = this->File.Word();
    this->IsBinary = form == "BINARY";
    if (!this->IsBinary && form != "ASCII")
    {
      this->File.Fail("the third line must be ASCII or BINARY");
    }
    this->File.NeedLine("the line DATASET");
    const bool isDataset = this->File.Word() == "DATASET";
    const std::string_view kind = this->File.Word();
    if (!isDataset || (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID"))
    {
      this->File.Fail("a mesh has the line DATASET POLYDATA or DATASET UNSTRUCTURED_GRID");
    }
  }

  void ReadSection()
  {
    const std::string_view word = this->File.Word();
    if (word == "POINTS")
    {
      this->ReadPoints();
    }
    else if (word == "POLYGONS" || word == "CELLS")
    {
      if (this->Cells.Offsets.size() > 1)
      {
        this->File.Fail("the cells stand in the file twice");
      }
      this->Cells = this->ReadCells();
    }
    else if (word == "VERTICES" || word == "LINES")
    {
      this->ReadCells();
    }
    else if (word == "CELL_TYPES")
    {
      this->ReadTypes();
    }
    else if (word == "FIELD")
    {
      this->SkipField();
    }
    else if (word == "METADATA")
    {
      this->SkipMetadata();
    }
    else if (word == "POINT_DATA" || word == "CELL_DATA")
    {
      this->AtData = true;
    }
    else
    {
      this->File.Fail("the line begins with no word of a mesh (POINTS, POLYGONS, CELLS, ...)");
    }
  }

  /** A count that the rest of the file has the bytes for. */
  std::int64_t Count(const char* what)
  {
    const std::int64_t count = this->File.Integer(what);
    if (count < 0 || static_cast<std::size_t>(count) > this->File.BytesLeft())
    {
      this->File.Fail(std::string(what) + " is " + std::to_string(count) +
        ", which the rest of the file does not hold");
    }
    return count;
  }

  NumberType ReadType()
  {
    return ReadNumberType(this->File, TypeNames, "the type of the numbers is not known");
  }

  /** Before `count` numbers of a type are read by Number() or Integer(). */
  void BeginNumbers(NumberType type, std::int64_t count)
  {
    this->Type = type;
    if (this->IsBinary)
    {
      this->File.EndLine();
      this->Bytes.emplace(
        this->File.TakeBytes(static_cast<std::size_t>(count) * SizeOf(type)), this->Path, true);
    }
  }

  double Coordinate()
  {
    if (!this->IsBinary)
    {
      this->File.NeedWord("a coordinate");
      return this->File.Coordinate();
    }
    const double value = this->Bytes->Number(this->Type);
    if (!std::isfinite(value))
    {
      this->Bytes->Fail("has a coordinate that is not finite");
    }
    return value;
  }

  std::int64_t Integer(const char* what)
  {
    if (this->IsBinary)
    {
      return this->Bytes->Integer(this->Type);
    }
    this->File.NeedWord(what);
    return this->File.Integer(what);
  }

  void ReadPoints()
  {
    if (this->Mesh.GetNumberOfVertices() > 0)
    {
      this->File.Fail("the points stand in the file twice");
    }
    const std::int64_t points = this->Count("the number of points");
    this->BeginNumbers(this->ReadType(), 3 * points);
    constexpr std::size_t leastBytes = 6; // "0 0 0\n"
    this->Mesh.ReserveVertices(std::min(static_cast<std::size_t>(points),
      this->IsBinary ? points : this->File.BytesLeft() / leastBytes + 1));
    for (std::int64_t i = 0; i < points; ++i)
    {
      const double x = this->Coordinate();
      const double y = this->Coordinate();
      if (this->Coordinate() != 0.0)
      {
        FailMeshFile(this->Path,
          "has a point, " + std::to_string(i) +
            ", whose third coordinate is not 0; project the mesh onto the plane z = 0 first");
      }
      this->Mesh.AddVertex(x, y);
    }
  }

  CellList ReadCells()
  {
    const std::int64_t first = this->Count("the number of cells");
    const std::int64_t size = this->Count("the size of the list of cells");
    LineScanner ahead = this->File;
    if (ahead.NextLine() && ahead.Word() == "OFFSETS")
    {
      return this->ReadOffsetCells(first, size);
    }
    CellList cells;
    this->BeginNumbers(NumberType::Int32, size);
    std::int64_t left = size;
    for (std::int64_t i = 0; i < first; ++i)
    {
      const std::int64_t corners = left > 0 ? this->Integer("the number of corners of a cell") : -1;
      if (corners < 0 || corners > left - 1)
      {
        FailMeshFile(this->Path, "has cells that do not fit into the size announced for them");
      }
      for (std::int64_t j = 0; j < corners; ++j)
      {
        cells.Connectivity.push_back(this->Integer("a corner of a cell"));
      }
      cells.Offsets.push_back(static_cast<std::int64_t>(cells.Connectivity.size()));
      left -= corners + 1;
    }
    return cells;
  }

  /** Of version 5: `offsets` numbers, one more than cells, then the corners. */
  CellList ReadOffsetCells(std::int64_t offsets, std::int64_t corners)
  {
    CellList cells;
    this->BeginArray("OFFSETS", offsets);
    for (std::int64_t i = 0; i < offsets; ++i)
    {
      const std::int64_t offset = this->Integer("an offset");
      const bool isRight = i == 0 ? offset == 0 : offset >= cells.Offsets.back();
      if (!isRight || offset > corners)
      {
        FailMeshFile(this->Path, "has cells whose offsets are wrong");
      }
      if (i > 0)
      {
        cells.Offsets.push_back(offset);
      }
    }
    this->BeginArray("CONNECTIVITY", corners);
    for (std::int64_t i = 0; i < corners; ++i)
    {
      cells.Connectivity.push_back(this->Integer("a corner of a cell"));
    }
    return cells;
  }

  void BeginArray(const std::string& name, std::int64_t count)
  {
    this->File.NeedLine(name.c_str());
    if (this->File.PeekWord() == "METADATA")
    {
      this->SkipMetadata();
      this->File.NeedLine(name.c_str());
    }
    if (this->File.Word() != name)
    {
      this->File.Fail("the line should begin with the word " + name);
    }
    this->BeginNumbers(this->ReadType(), count);
  }

  void ReadTypes()
  {
    const std::int64_t count = this->Count("the number of types of cells");
    this->BeginNumbers(NumberType::Int32, count);
    this->Types.clear();
    for (std::int64_t i = 0; i < count; ++i)
    {
      this->Types.push_back(this->Integer("the type of a cell"));
    }
  }

  /** Arrays of the whole mesh, of which nothing is kept. */
  void SkipField()
  {
    this->File.Word();
    const std::int64_t arrays = this->Count("the number of arrays");
    for (std::int64_t i = 0; i < arrays; ++i)
    {
      this->File.NeedLine("an array");
      if (this->File.PeekWord() == "METADATA")
      {
        this->SkipMetadata();
        this->File.NeedLine("an array");
      }
      this->File.Word();
      const std::int64_t components = this->Count("the number of components");
      const std::int64_t tuples = this->Count("the number of tuples");
      const auto most = static_cast<std::int64_t>(this->File.BytesLeft());
      if (components > 0 && tuples > most / components)
      {
        this->File.Fail("the rest of the file does not hold the array");
      }
      this->BeginNumbers(this->ReadType(), components * tuples);
      for (std::int64_t j = 0; !this->IsBinary && j < components * tuples; ++j)
      {
        this->File.NeedWord("a number");
        this->File.SkipNumber("a number");
      }
    }
  }

  /** Up to the line before the next word that means something. */
  void SkipMetadata()
  {
    for (LineScanner ahead = this->File; ahead.NextLine(); this->File = ahead)
    {
      const std::string_view word = ahead.PeekWord();
      if (std::find(Keywords.begin(), Keywords.end(), word) != Keywords.end())
      {
        return;
      }
    }
  }

  void AddCell(std::size_t cell)
  {
    const std::int64_t type = this->Types[cell];
    if (type >= VTK_EMPTY_CELL && type <= VTK_POLY_LINE)
    {
      return;
    }
    const auto first = static_cast<std::size_t>(this->Cells.Offsets[cell]);
    const auto last = static_cast<std::size_t>(this->Cells.Offsets[cell + 1]);
    const std::size_t corners = last - first;
    const bool isKnown = type == VTK_TRIANGLE ? corners == 3
      : type == VTK_QUAD || type == VTK_PIXEL ? corners == 4
                                              : type == VTK_POLYGON && corners >= 3;
    if (!isKnown)
    {
      FailMeshFile(this->Path,
        "has a cell, " + std::to_string(cell) + ", of the type " + std::to_string(type) + " with " +
          CountText(static_cast<std::int64_t>(corners), "corner", "corners") +
          ", which is no polygon of three or more");
    }
    const bool isPixel = type == VTK_PIXEL; // its third and fourth corners are in the other order
    for (std::size_t i = first; i < last; ++i)
    {
      const std::size_t at = isPixel && i >= first + 2 ? first + last + 1 - i : i;
      this->Mesh.AddCorner(this->CheckedVertex(this->Cells.Connectivity[at]));
    }
    this->Mesh.EndElement();
  }

  std::int64_t CheckedVertex(std::int64_t vertex) const
  {
    const std::int64_t vertices = this->Mesh.GetNumberOfVertices();
    if (vertex < 0 || vertex >= vertices)
    {
      FailMeshFile(this->Path,
        "has a cell that uses point " + std::to_string(vertex) + ", and the points are 0 to " +
          std::to_string(vertices - 1));
    }
    return vertex;
  }

  LineScanner File;
  const std::filesystem::path& Path;
  MeshBuilder Mesh;
  CellList Cells;
  std::vector<std::int64_t> Types;
  std::optional<BinaryScanner> Bytes; // of the section being read
  NumberType Type = NumberType::Float64;
  bool IsBinary = false;
  bool AtData = false;
};

} // namespace

vtkSmartPointer<vtkPolyData> ReadVtkLegacy(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  if (text.rfind("# vtk DataFile Version", 0) != 0)
  {
    FailMeshFile(path, "does not begin with \"# vtk DataFile Version\"");
  }
  return LegacyReader(text, path).Read();
}

void WriteVtkLegacy(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.Append("# vtk DataFile Version 3.0\nPEMesh\nASCII\nDATASET POLYDATA\nPOINTS ");
  text.AppendValue(mesh->GetNumberOfPoints());
  text.Append(" double\n");
  AppendVertices(text, "", mesh);
  text.Append("POLYGONS ");
  text.AppendValue(mesh->GetNumberOfPolys());
  text.Append(' ');
  text.AppendValue(mesh->GetPolys()->GetNumberOfConnectivityIds() + mesh->GetNumberOfPolys());
  text.Append('\n');
  AppendElements(text, mesh, 0);
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * PLY, the polygon file format (Turk, The PLY Polygon File Format, Stanford, 1994): a header that
 * declares elements and their properties, then the values as text or as bytes of either order.
 * Read are x, y, z of `vertex` and the list of `face`; everything else that a header declares is
 * skipped. VTK's own reader keeps coordinates as floats.
 */
#include "FormatFunctions.h"

#include "BinaryScanner.h"
#include "ElementAccess.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr NumberTypeName TypeNames[] = { { "char", NumberType::Int8 }, { "int8", NumberType::Int8 },
  { "uchar", NumberType::UInt8 }, { "uint8", NumberType::UInt8 }, { "short", NumberType::Int16 },
  { "int16", NumberType::Int16 }, { "ushort", NumberType::UInt16 },
  { "uint16", NumberType::UInt16 }, { "int", NumberType::Int32 }, { "int32", NumberType::Int32 },
  { "uint", NumberType::UInt32 }, { "uint32", NumberType::UInt32 },
  { "float", NumberType::Float32 }, { "float32", NumberType::Float32 },
  { "double", NumberType::Float64 }, { "float64", NumberType::Float64 } };

/** What a property is to a mesh. */
enum class Role
{
  Other,
  X,
  Y,
  Z,
  Corners
};

struct Property
{
  NumberType Type = NumberType::Float64;
  std::optional<NumberType> CountType; // of a list
  Role Meaning = Role::Other;
};

struct PlyElement
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

enum class Encoding
{
  Text,
  LittleEndian,
  BigEndian
};

struct Header
{
  Encoding Form = Encoding::Text;
  std::vector<PlyElement> Elements;
};

NumberType ReadType(LineScanner& file)
{
  return ReadNumberType(file, TypeNames, "a property has a type that PLY does not know");
}

Encoding ReadEncoding(LineScanner& file)
{
  const std::string_view word = file.Word();
  if (word == "ascii")
  {
    return Encoding::Text;
  }
  if (word != "binary_little_endian" && word != "binary_big_endian")
  {
    file.Fail("the format is none of ascii, binary_little_endian and binary_big_endian");
  }
  return word == "binary_big_endian" ? Encoding::BigEndian : Encoding::LittleEndian;
}

PlyElement ReadElementLine(LineScanner& file)
{
  PlyElement element;
  element.Name = file.Word();
  element.Count = file.Integer("the number of elements");
  if (element.Count < 0)
  {
    file.Fail("the number of elements is negative");
  }
  return element;
}

Role RoleOf(const std::string& element, std::string_view property, bool isList)
{
  if (element == "vertex" && !isList)
  {
    return property == "x" ? Role::X
      : property == "y"    ? Role::Y
      : property == "z"    ? Role::Z
                           : Role::Other;
  }
  const bool isFace =
    element == "face" && isList && (property == "vertex_indices" || property == "vertex_index");
  return isFace ? Role::Corners : Role::Other;
}

Property ReadPropertyLine(LineScanner& file, const std::string& element)
{
  Property property;
  const bool isList = file.PeekWord() == "list";
  if (isList)
  {
    file.Word();
    property.CountType = ReadType(file);
  }
  property.Type = ReadType(file);
  property.Meaning = RoleOf(element, file.Word(), isList);
  return property;
}

/** Up to the line end_header; the next byte is the first one of the data. */
Header ReadHeader(LineScanner& file)
{
  file.NeedLine("the word ply");
  if (file.Word() != "ply")
  {
    file.Fail("a PLY file must begin with the word ply");
  }
  Header header;
  for (;;)
  {
    file.NeedLine("the line end_header");
    const std::string_view word = file.Word();
    if (word == "end_header")
    {
      file.EndLine();
      return header;
    }
    if (word == "format")
    {
      header.Form = ReadEncoding(file);
    }
    else if (word == "element")
    {
      header.Elements.push_back(ReadElementLine(file));
    }
    else if (word == "property" && !header.Elements.empty())
    {
      PlyElement& element = header.Elements.back();
      element.Properties.push_back(ReadPropertyLine(file, element.Name));
    }
    else if (word != "comment" && word != "obj_info")
    {
      file.Fail("the line begins with no statement of a PLY header");
    }
  }
}

const PlyElement* FindElement(const Header& header, const char* name)
{
  const auto found = std::find_if(header.Elements.begin(), header.Elements.end(),
    [&](const PlyElement& element) { return element.Name == name; });
  return found == header.Elements.end() ? nullptr : &*found;
}

bool HasRole(const PlyElement& element, Role role)
{
  return std::count_if(element.Properties.begin(), element.Properties.end(),
           [&](const Property& property) { return property.Meaning == role; }) == 1;
}

/** Throws unless there are vertices with coordinates and faces with corners. */
void CheckHeader(const std::filesystem::path& path, const Header& header)
{
  const PlyElement* vertices = FindElement(header, "vertex");
  const PlyElement* faces = FindElement(header, "face");
  if (!vertices || !HasRole(*vertices, Role::X) || !HasRole(*vertices, Role::Y))
  {
    FailMeshFile(path, "declares no vertices with properties x and y");
  }
  if (!faces || !HasRole(*faces, Role::Corners) || faces->Count == 0)
  {
    FailMeshFile(path, "declares no faces with a list vertex_indices");
  }
  for (const PlyElement& element : header.Elements)
  {
    if (element.Count > 0 && element.Properties.empty())
    {
      FailMeshFile(path, "declares elements without properties");
    }
  }
}

/** The values as text: an element is a line. */
class TextValues
{
public:
  explicit TextValues(LineScanner& file)
    : File(file)
  {
  }
  void Begin() { this->File.NeedLine("an element that the header announces"); }
  void End() { this->File.NeedLineEnd("the properties"); }
  double Number(NumberType) { return this->File.Coordinate(); }
  void Skip(NumberType) { this->File.SkipNumber("a number"); }
  std::int64_t Integer(NumberType) { return this->File.Integer("an integer"); }
  void AtEnd()
  {
    if (this->File.NextLine())
    {
      this->File.Fail("the file goes on after all elements that the header announces");
    }
  }
  std::size_t BytesLeft() const { return this->File.BytesLeft(); }
  [[noreturn]] void Fail(const std::string& what) const { this->File.Fail(what); }

private:
  LineScanner& File;
};

/** The values as bytes. */
class BinaryValues
{
public:
  explicit BinaryValues(const BinaryScanner& file)
    : File(file)
  {
  }
  void Begin() {}
  void End() {}
  double Number(NumberType type)
  {
    const double value = this->File.Number(type);
    if (!std::isfinite(value))
    {
      this->File.Fail("has a coordinate that is not finite");
    }
    return value;
  }
  void Skip(NumberType type) { this->File.Skip(SizeOf(type)); }
  std::int64_t Integer(NumberType type) { return this->File.Integer(type); }
  void AtEnd() {} // some writers leave padding
  std::size_t BytesLeft() const { return this->File.BytesLeft(); }
  [[noreturn]] void Fail(const std::string& what) const { this->File.Fail("is wrong: " + what); }

private:
  BinaryScanner File;
};

template <typename Values>
class PlyBody
{
public:
  PlyBody(const Header& header, Values values)
    : Head(header)
    , Source(std::move(values))
    , Vertices(FindElement(header, "vertex")->Count)
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    for (const PlyElement& element : this->Head.Elements)
    {
      this->ReadElements(element);
    }
    this->Source.AtEnd();
    return this->Mesh.Take();
  }

private:
  void ReadElements(const PlyElement& element)
  {
    const auto announced = static_cast<std::size_t>(element.Count);
    const bool isVertex = element.Name == "vertex";
    if (isVertex) // an element takes a byte at least
    {
      this->Mesh.ReserveVertices(std::min(announced, this->Source.BytesLeft() / 4 + 1));
    }
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      this->Source.Begin();
      double point[3] = { 0.0, 0.0, 0.0 };
      for (const Property& property : element.Properties)
      {
        this->ReadProperty(property, point);
      }
      this->Source.End();
      if (isVertex)
      {
        if (point[2] != 0.0)
        {
          this->Source.Fail("the third coordinate of vertex " + std::to_string(i) +
            " is not 0; project the mesh onto the plane z = 0 first");
        }
        this->Mesh.AddVertex(point[0], point[1]);
      }
    }
  }

  void ReadProperty(const Property& property, double (&point)[3])
  {
    if (property.Meaning == Role::Corners)
    {
      this->ReadCorners(property);
    }
    else if (property.Meaning != Role::Other)
    {
      point[static_cast<int>(property.Meaning) - static_cast<int>(Role::X)] =
        this->Source.Number(property.Type);
    }
    else
    {
      const std::int64_t count = property.CountType ? this->Source.Integer(*property.CountType) : 1;
      for (std::int64_t i = 0; i < count; ++i)
      {
        this->Source.Skip(property.Type);
      }
    }
  }

  void ReadCorners(const Property& property)
  {
    const std::int64_t corners = this->Source.Integer(*property.CountType);
    if (corners < 3)
    {
      this->Source.Fail(
        "a face has " + CountText(corners, "vertex", "vertices") + " and needs three or more");
    }
    for (std::int64_t j = 0; j < corners; ++j)
    {
      const std::int64_t vertex = this->Source.Integer(property.Type);
      if (vertex < 0 || vertex >= this->Vertices)
      {
        this->Source.Fail("a face uses vertex " + std::to_string(vertex) +
          ", and the vertices are 0 to " + std::to_string(this->Vertices - 1));
      }
      this->Mesh.AddCorner(vertex);
    }
    this->Mesh.EndElement();
  }

  const Header& Head;
  Values Source;
  MeshBuilder Mesh;
  std::int64_t Vertices; // as announced: faces may come before them
};

} // namespace

vtkSmartPointer<vtkPolyData> ReadPly(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  LineScanner file(text, path);
  const Header header = ReadHeader(file);
  CheckHeader(path, header);
  if (header.Form == Encoding::Text)
  {
    return PlyBody(header, TextValues(file)).Read();
  }
  const std::string_view data = std::string_view(text).substr(text.size() - file.BytesLeft());
  const bool isBig = header.Form == Encoding::BigEndian;
  return PlyBody(header, BinaryValues(BinaryScanner(data, path, isBig))).Read();
}

void WritePly(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  TextBuffer text;
  text.Reserve(GuessTextSize(mesh));
  text.Append("ply\nformat ascii 1.0\nelement vertex ");
  text.AppendValue(mesh->GetNumberOfPoints());
  text.Append("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  text.AppendValue(mesh->GetNumberOfPolys());
  text.Append("\nproperty list int int vertex_indices\nend_header\n");
  AppendVertices(text, "", mesh);
  AppendElements(text, mesh, 0);
  WriteTextFile(path, text.GetText());
}

} // namespace pemesh

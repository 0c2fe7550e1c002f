// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "FormatFunctions.h"
#include "MeshBuilder.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <vtkCellArray.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr std::array OffExtensions{ ".off" };
constexpr std::array ObjExtensions{ ".obj" };
constexpr std::array NodeExtensions{ ".node", ".ele" };
constexpr std::array StlExtensions{ ".stl" };
constexpr std::array VtpExtensions{ ".vtp" };
constexpr std::array VtuExtensions{ ".vtu" };
constexpr std::array VtkExtensions{ ".vtk" };
constexpr std::array PlyExtensions{ ".ply" };
constexpr std::array GmshExtensions{ ".msh" };
constexpr std::array MatExtensions{ ".mat" };

constexpr const char* TriangleReference = "https://www.cs.cmu.edu/~quake/triangle.html";
constexpr const char* VtkReference = "VTK File Formats, https://docs.vtk.org";

constexpr int AnyCorners = 0;

constexpr std::array Formats{
  MeshFormat{ "off", "OFF (Geomview)",
    "Read: text; heads OFF, COFF, NOFF, STOFF or none, counts on any lines, comments; normals and "
    "colours are skipped. Written: OFF.",
    OffExtensions, ReadOff, WriteOff, true, AnyCorners, false,
    "http://www.geomview.org/docs/html/OFF.html" },
  MeshFormat{ "obj", "OBJ (Wavefront)",
    "Read: v and f, also a/b/c and a//c, numbers back from the end, joined lines; groups, "
    "materials, normals and lines are skipped. Written: v and f.",
    ObjExtensions, ReadObj, WriteObj, true, AnyCorners, false, "" },
  MeshFormat{ "node", "NODE and ELE (Triangle)",
    "Read: this form and node-plain, told apart by the first line; numbers from 0 or 1, attributes "
    "are skipped. Written: numbers from 1, boundary markers.",
    NodeExtensions, ReadNode, WriteNode, true, AnyCorners, false, TriangleReference },
  MeshFormat{ "node-plain", "NODE and ELE without indices",
    "Read: as node. Written: n 0, then x y; n, then k i1 ... ik, from 1.", NodeExtensions, ReadNode,
    WriteNodePlain, true, AnyCorners, false, "" },
  MeshFormat{ "stl", "STL",
    "Read: text and binary; corners with the same coordinates become one vertex. Written: text.",
    StlExtensions, ReadStl, WriteStl, false, 3, false, "" },
  MeshFormat{ "vtp", "VTP (VTK)",
    "Read: any encoding. Written: binary data in place, the same bytes for the same mesh.",
    VtpExtensions, ReadVtp, WriteVtp, true, AnyCorners, true, VtkReference },
  MeshFormat{ "vtu", "VTU (VTK)",
    "Read: any encoding; triangles, quadrilaterals and polygons. Written: as vtp.", VtuExtensions,
    ReadVtu, WriteVtu, true, AnyCorners, true, VtkReference },
  MeshFormat{ "vtk", "VTK's legacy format",
    "Read: text and binary, versions 1 to 5, POLYDATA and UNSTRUCTURED_GRID. Written: text, "
    "version 3, POLYDATA.",
    VtkExtensions, ReadVtkLegacy, WriteVtkLegacy, true, AnyCorners, false, VtkReference },
  MeshFormat{ "ply", "PLY (Stanford)",
    "Read: text and both binary forms, numbers of any type; colours and other properties are "
    "skipped. Written: text, doubles.",
    PlyExtensions, ReadPly, WritePly, true, AnyCorners, false, "" },
  MeshFormat{ "gmsh", "MSH (Gmsh)",
    "Read: text, versions 2 and 4.1, first order; lines and physical groups are skipped. Written: "
    "version 2.2.",
    GmshExtensions, ReadGmsh, WriteGmsh, true, 4, false,
    "https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format" },
  MeshFormat{ "mat", "MAT (MATLAB, Octave): vertices, elements, boundary",
    "Read: versions 5 to 7; this form, node and elem, or Node and Element, the elements as cells "
    "or "
    "a matrix. Written: cells, version 5.",
    MatExtensions, ReadMat, WriteMat, true, AnyCorners, false,
    "Sutton, Numer. Algorithms 75 (2017) 1141-1159" },
  MeshFormat{ "mat-node-elem", "MAT (MATLAB, Octave): node, elem",
    "Read: as mat. Written: cells, version 5, as iFEM and mVEM have them.", MatExtensions, ReadMat,
    WriteMatNodeElem, true, AnyCorners, false, "Chen, iFEM (2009); Yu, mVEM (2021)" },
};

const MeshFormat& NeedFormat(const std::filesystem::path& path)
{
  const MeshFormat* format = FindMeshFormatOfFile(path);
  if (!format)
  {
    throw std::runtime_error("\"" + path.string() +
      "\" has no extension of a mesh file; known are " + ListMeshExtensions() + ".");
  }
  return *format;
}

} // namespace

std::span<const MeshFormat> MeshFormats()
{
  return Formats;
}

std::vector<std::string> MeshFormatNames()
{
  std::vector<std::string> names;
  for (const MeshFormat& format : Formats)
  {
    names.emplace_back(format.Name);
  }
  return names;
}

const MeshFormat* FindMeshFormat(std::string_view name)
{
  const auto* found = std::find_if(
    Formats.begin(), Formats.end(), [&](const MeshFormat& format) { return name == format.Name; });
  return found == Formats.end() ? nullptr : found;
}

const MeshFormat* FindMeshFormatOfFile(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto* found = std::find_if(Formats.begin(), Formats.end(),
    [&](const MeshFormat& format)
    {
      return std::find(format.Extensions.begin(), format.Extensions.end(), extension) !=
        format.Extensions.end();
    });
  return found == Formats.end() ? nullptr : found;
}

std::string ListMeshExtensions(const char* before)
{
  std::vector<std::string> seen;
  std::string text;
  for (const MeshFormat& format : Formats)
  {
    for (const char* extension : format.Extensions)
    {
      if (std::find(seen.begin(), seen.end(), extension) == seen.end())
      {
        seen.emplace_back(extension);
        text += (text.empty() ? "" : " ") + std::string(before) + extension;
      }
    }
  }
  return text;
}

vtkIdType CountElementsToCut(const MeshFormat& format, vtkPolyData* mesh)
{
  vtkCellArray* polygons = mesh->GetPolys();
  vtkIdType count = 0;
  for (vtkIdType i = 0; format.MostCorners > 0 && i < polygons->GetNumberOfCells(); ++i)
  {
    count += polygons->GetCellSize(i) > format.MostCorners ? 1 : 0;
  }
  return count;
}

std::string DescribeMeshFormats()
{
  std::string text = "| name | files | elements | arrays | |\n|---|---|---|---|---|\n";
  for (const MeshFormat& format : Formats)
  {
    std::string files;
    for (const char* extension : format.Extensions)
    {
      files += (files.empty() ? "`" : " + `") + std::string(extension) + "`";
    }
    const std::string elements =
      format.MostCorners == 0 ? "any" : "up to " + std::to_string(format.MostCorners) + " vertices";
    text += "| `" + std::string(format.Name) + "` | " + files + " | " + elements + " | " +
      (format.KeepsArrays ? "all" : "none") + " | " + format.Label + ". " + format.Description +
      " |\n";
  }
  return text;
}

vtkSmartPointer<vtkPolyData> ReadMesh(
  const std::filesystem::path& path, ElementOrientation orientation)
{
  auto mesh = NeedFormat(path).Read(path);
  if (orientation == ElementOrientation::CounterClockwise)
  {
    ReverseClockwiseElements(mesh);
  }
  return mesh;
}

void WriteMesh(const std::filesystem::path& path, vtkPolyData* mesh)
{
  NeedFormat(path).Write(path, mesh);
}

} // namespace pemesh

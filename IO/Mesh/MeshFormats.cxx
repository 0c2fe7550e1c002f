// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "FormatFunctions.h"
#include "MeshBuilder.h"

#include <algorithm>
#include <array>
#include <stdexcept>

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

constexpr std::array Formats{
  MeshFormat{ "off", "OFF (Geomview)", OffExtensions, ReadOff, WriteOff, true },
  MeshFormat{ "obj", "OBJ (Wavefront)", ObjExtensions, ReadObj, WriteObj, true },
  MeshFormat{ "node", "NODE and ELE (Triangle)", NodeExtensions, ReadNode, WriteNode, true },
  MeshFormat{
    "node-plain", "NODE and ELE without indices", NodeExtensions, ReadNode, WriteNodePlain, true },
  MeshFormat{ "stl", "STL (triangles)", StlExtensions, ReadStl, WriteStl, false },
  MeshFormat{ "vtp", "VTP (VTK, with all arrays)", VtpExtensions, ReadVtp, WriteVtp, true },
};

/** "off, obj, …" for messages. */
std::string KnownExtensions()
{
  std::string text;
  for (const MeshFormat& format : Formats)
  {
    for (const char* extension : format.Extensions)
    {
      if (text.find(extension) == std::string::npos)
      {
        text += (text.empty() ? "" : " ") + std::string(extension);
      }
    }
  }
  return text;
}

const MeshFormat& NeedFormat(const std::filesystem::path& path)
{
  const MeshFormat* format = FindMeshFormatOfFile(path);
  if (!format)
  {
    throw std::runtime_error("\"" + path.string() +
      "\" has no extension of a mesh file; known are " + KnownExtensions() + ".");
  }
  return *format;
}

} // namespace

std::span<const MeshFormat> MeshFormats()
{
  return Formats;
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

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The mesh file formats, as one table, and the functions that read and write by extension.
 *
 * What holds for every format:
 *  - Vertices keep the number and the order of the file, used by an element or not, because the
 *    files of a solver hold one number a vertex. STL alone has no vertices of its own: corners
 *    with the same coordinates are one vertex, in the order in which they first appear.
 *  - No reader takes more memory than what the file could hold, whatever its header announces; of
 *    VTP and VTU, which VTK reads, only the counts of the header are held to that.
 *  - Coordinates are doubles, read and written so that every bit survives (binary STL: floats).
 *  - Meshes are planar: a third coordinate must be zero and is dropped.
 *  - Elements that are clockwise in the file are reversed, the first vertex staying first, unless
 *    ReadMesh is asked for them as stored. The sign of the area is exact, so that no needle is
 *    turned by rounding.
 *  - Nothing depends on the locale; files are written whole or not at all.
 *  - Whatever is wrong with a file is a std::runtime_error with one sentence that names the file
 *    and, in a text file, the line.
 *
 * To add a format: one entry in the table of MeshFormats.cxx.
 */
#ifndef pemesh_MeshFormats_h
#define pemesh_MeshFormats_h

#include "pemeshIOMeshModule.h" // For export macro

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vtkSmartPointer.h> // For return type
#include <vtkType.h>         // For vtkIdType

class vtkPolyData;

namespace pemesh
{

/** One entry of the table that readers, writers, commands, windows and documents go by. */
struct MeshFormat
{
  /** Kebab-case: how a study, a solver description or a command names it. */
  const char* Name;
  const char* Label;
  /** What is read of it and what is written, one sentence each. */
  const char* Description;
  /** Lower case, with the dot; the first one is the one written. Two are a pair of files. */
  std::span<const char* const> Extensions;
  /** Elements as stored; ReadMesh turns them round. */
  vtkSmartPointer<vtkPolyData> (*Read)(const std::filesystem::path& path);
  void (*Write)(const std::filesystem::path& path, vtkPolyData* mesh);
  /** Whether a file keeps the order of the vertices, which a solver's answer needs. */
  bool KeepsVertices;
  /** How many vertices an element of a file may have, 0 without a limit. Larger elements are cut
   * into triangles when they are written. */
  int MostCorners;
  /** Whether a file keeps the arrays of vertices, elements and mesh. */
  bool KeepsArrays;
  /** Where the format is defined, or "" where the description says it all. */
  const char* Reference;
};

/** All formats. Where two share an extension, the first one is the one meant by it. */
PEMESHIOMESH_EXPORT std::span<const MeshFormat> MeshFormats();

/** Their names, in order. */
PEMESHIOMESH_EXPORT std::vector<std::string> MeshFormatNames();

/** By its name, or null. */
PEMESHIOMESH_EXPORT const MeshFormat* FindMeshFormat(std::string_view name);

/** By the extension of a file, whatever its case, or null. */
PEMESHIOMESH_EXPORT const MeshFormat* FindMeshFormatOfFile(const std::filesystem::path& path);

/** The endings of mesh files, each once: " " between them and `before` in front ("*" for windows).
 */
PEMESHIOMESH_EXPORT std::string ListMeshExtensions(const char* before = "");

/** The elements that writing in this format cuts into triangles. */
PEMESHIOMESH_EXPORT vtkIdType CountElementsToCut(const MeshFormat& format, vtkPolyData* mesh);

/** The table of the formats as in IO/Mesh/README.md, in Markdown. */
PEMESHIOMESH_EXPORT std::string DescribeMeshFormats();

/** What becomes of elements that are clockwise in a file. */
enum class ElementOrientation
{
  CounterClockwise, ///< they are reversed
  AsStored          ///< nothing: for who looks for what is wrong with a file
};

/** Throws std::runtime_error where the extension is unknown or the file is bad. */
PEMESHIOMESH_EXPORT vtkSmartPointer<vtkPolyData> ReadMesh(const std::filesystem::path& path,
  ElementOrientation orientation = ElementOrientation::CounterClockwise);

/**
 * Throws std::runtime_error where the extension is unknown, the mesh cannot be written (no
 * polygons, lines, coordinates that are not finite) or the disk refuses.
 */
PEMESHIOMESH_EXPORT void WriteMesh(const std::filesystem::path& path, vtkPolyData* mesh);

} // namespace pemesh

#endif

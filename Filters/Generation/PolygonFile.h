// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Polygons from files: of a mesh file each element is one, of a table of points each block of
 * lines.
 *
 * Mesh files are all that IO/Mesh reads: MeshFormats.h. A table of points has
 * the extension csv, txt or xy and one vertex a line: x and y, separated by a comma, a semicolon
 * or blanks, numbers with a decimal point. Its first line may be the header x,y; # begins a
 * comment; empty lines end a polygon, so that a file can hold several. A last vertex that repeats
 * the first is left out.
 */
#ifndef pemesh_PolygonFile_h
#define pemesh_PolygonFile_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/**
 * The polygons of a file in its order, at least one, each with three vertices or more, turned
 * counter-clockwise where they are not (the first vertex stays the first). They need not be simple.
 * Throws std::runtime_error with one sentence that names the file and, in a text file, the line.
 */
PEMESHFILTERSGENERATION_EXPORT std::vector<std::vector<Point2>> ReadPolygonFile(
  const std::filesystem::path& path);

/** The same of the text of a table of points, which messages call `source`. */
PEMESHFILTERSGENERATION_EXPORT std::vector<std::vector<Point2>> ParsePolygonPoints(
  std::string_view text, const std::string& source);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The polygons of a study as a table, for spreadsheets and other programs.
 *
 * The form read and written is CSV (RFC 4180) with a header. Its columns are those keys of
 * `polygons` in the study document (README.md) that have a value, but center_x and center_y for
 * `center`, and vertices as "x y; x y; x y" for `points`. Only `family` is needed; an empty field
 * is the default. Also read is the form of PEMesh's predecessor: one polygon a line without
 * a header, blanks between `class file|NONE centre_x centre_y rotation scale`, with the rotation in
 * radians, the classes of the eight families, and Random for the polygon of a file.
 */
#ifndef pemesh_PolygonTable_h
#define pemesh_PolygonTable_h

#include "Study.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/**
 * Reads a table; `file` of its polygons is relative to it. Throws std::runtime_error with one
 * sentence that names the file, the line and the column.
 */
PEMESHIOSTUDY_EXPORT std::vector<StudyPolygon> ReadPolygonTable(const std::filesystem::path& path);

/** The same of the text of a table, which messages call `source`. */
PEMESHIOSTUDY_EXPORT std::vector<StudyPolygon> ParsePolygonTable(
  std::string_view text, const std::string& source);

/** The text of a table; ParsePolygonTable gives back the same polygons. */
PEMESHIOSTUDY_EXPORT std::string FormatPolygonTable(const std::vector<StudyPolygon>& polygons);

/** Throws std::runtime_error where the disk refuses. */
PEMESHIOSTUDY_EXPORT void WritePolygonTable(
  const std::filesystem::path& path, const std::vector<StudyPolygon>& polygons);

} // namespace pemesh

#endif

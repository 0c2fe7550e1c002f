// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The study document: JSON, keys in kebab-case, angles in degrees.
 *
 * Reading is strict. Every function throws std::runtime_error with one sentence that names the
 * file and the place in it: a syntax error by line and column, a key given twice, an unknown key
 * with the nearest known one, a value of the wrong type or out of range by its path
 * (`mesh.min-angle`, `polygons[0].scale`). Of the files named in the document only a table of
 * polygons is read here; FindStudyMeshes (Study.h), FindStudySolvers (SolverDescriptionFile.h) and
 * whoever places the polygons look at the others.
 */
#ifndef pemesh_StudyFile_h
#define pemesh_StudyFile_h

#include "Study.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <filesystem>
#include <string>
#include <string_view>

namespace pemesh
{

/** Reads a document. */
PEMESHIOSTUDY_EXPORT Study ReadStudy(const std::filesystem::path& path);

/** Reads the text of a document; `path` is used in messages, and relative paths start from it. */
PEMESHIOSTUDY_EXPORT Study ParseStudy(std::string_view text, const std::filesystem::path& path);

/**
 * The document of a study with every default written out, keys always in the same order.
 * ParseStudy(FormatStudy(study), path) gives back the study (Folder comes from the path).
 */
PEMESHIOSTUDY_EXPORT std::string FormatStudy(const Study& study);

/**
 * Changes one value of a document (the text of any JSON file) and returns the new text: `setting`
 * is "mesh.min-angle=25", "polygons[0].scale=0.5", or "polygons[*].scale=0.5" for all of them. What
 * follows the equals sign is JSON if it can be read as such, else a text. Missing objects are made
 * on the way.
 */
PEMESHIOSTUDY_EXPORT std::string ApplySetting(std::string_view text, std::string_view setting);

/** The study as seen from another folder: relative paths in it name the same files as before. */
PEMESHIOSTUDY_EXPORT Study MoveStudy(const Study& study, const std::filesystem::path& folder);

/** All keys with type, default, range and meaning, one a line: the reference of the document. */
PEMESHIOSTUDY_EXPORT std::string DescribeStudyKeys();

} // namespace pemesh

#endif

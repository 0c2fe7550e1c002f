// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Values of a document named by their path: "mesh.min-angle", "polygons[0].scale" (or
 * "polygons.0.scale"), and "polygons[*].scale" for that of every item of the list.
 */
#ifndef pemesh_DocumentPath_h
#define pemesh_DocumentPath_h

#include "JsonValue.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/** The keys of a path, one after the other. */
PEMESHIOSTUDY_EXPORT std::vector<std::string> SplitDocumentPath(std::string_view path);

/**
 * Sets the value, or all values, of a path. Objects that are missing on the way are made. Throws
 * std::runtime_error with a sentence that begins with `shown`: an improper path, an item that a
 * list does not have.
 */
PEMESHIOSTUDY_EXPORT void SetAtPath(
  JsonValue& document, std::string_view path, const JsonValue& value, const std::string& shown);

/** Whether the document has the value, or all values, of a path. */
PEMESHIOSTUDY_EXPORT bool HasPath(const JsonValue& document, std::string_view path);

/** The value of a path without *, or null; valid until the document changes. */
PEMESHIOSTUDY_EXPORT const JsonValue* FindAtPath(const JsonValue& document, std::string_view path);

/** Takes the member or the item of a path without * out; nothing happens where there is none. */
PEMESHIOSTUDY_EXPORT void RemoveAtPath(JsonValue& document, std::string_view path);

} // namespace pemesh

#endif

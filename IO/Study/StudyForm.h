// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The keys of a study document as a form that a person fills in: what a window needs to know to
 * offer an editor for every key that applies. It comes from the same tables as reading, writing and
 * the reference.
 */
#ifndef pemesh_StudyForm_h
#define pemesh_StudyForm_h

#include "JsonValue.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pemesh
{

struct Study;

/** What a value may be. */
struct ValueForm
{
  enum KindType
  {
    Text,
    Number,
    Integer,
    Truth,
    Choice,
    Texts, ///< a list of texts
    Pair   ///< two numbers
  };
  KindType Kind = Text;
  double Least = -std::numeric_limits<double>::infinity(); ///< of numbers
  double Greatest = std::numeric_limits<double>::infinity();
  bool ExcludesLeast = false;
  std::vector<std::string> Choices = {};
  std::string WhenUnset = {}; ///< of a number that may be left out: whose value is in force then
};

/** One key that applies. */
struct FormField
{
  std::string Path; ///< "mesh.max-area.rule"
  std::string Key;  ///< "rule"
  std::string Type; ///< as in the reference: "number between 0 and 33"
  std::string Doc;
  ValueForm Form;
  std::optional<JsonValue> Value; ///< in effect, given or default; nothing where it is left out
  bool IsRequired = false;
};

/**
 * The fields of one object of a document: "domain", "mesh" (with those of the objects in it),
 * "scatter", "polygons[2]", "sweep[0]", "solvers[1]". None for another path, or an item that the
 * study does not have.
 */
PEMESHIOSTUDY_EXPORT std::vector<FormField> DescribeStudyForm(
  const Study& study, const std::string& path);

/**
 * The document with another choice at a path ("mesh.max-area.rule"): keys beside it that belong to
 * the choice before are gone, and a number that the new one requires is there. Throws
 * std::runtime_error where the document says something else that is impossible.
 */
PEMESHIOSTUDY_EXPORT JsonValue ChooseInDocument(
  const JsonValue& document, const std::string& path, const std::string& choice);

} // namespace pemesh

#endif

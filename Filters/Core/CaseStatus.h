// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The status of a case travels with its mesh, as field data.
 *
 * A case that cannot be meshed, read or solved is not an error of the pipeline: the filter that
 * met it passes on what there is and says what happened in two one-value string arrays,
 * `Status` ("ok", or one word such as "invalid-layout") and `StatusMessage` (one sentence that
 * names the culprit and the way out). Filters downstream pass a failed mesh on untouched.
 */
#ifndef pemesh_CaseStatus_h
#define pemesh_CaseStatus_h

#include "pemeshFiltersCoreModule.h" // For export macro

#include <string>

class vtkDataObject;
class vtkFieldData;

namespace pemesh
{

/** Marks `data` as failed: `status` is one lower-case word with hyphens, `message` a sentence. */
PEMESHFILTERSCORE_EXPORT void SetCaseFailed(
  vtkDataObject* data, const std::string& status, const std::string& message);

/** "ok" where nothing was said. */
PEMESHFILTERSCORE_EXPORT std::string GetCaseStatus(vtkDataObject* data);

/** Empty where nothing was said. */
PEMESHFILTERSCORE_EXPORT std::string GetCaseStatusMessage(vtkDataObject* data);

PEMESHFILTERSCORE_EXPORT bool IsCaseFailed(vtkDataObject* data);

///@{
/** One-value field arrays: provenance, parameters of the case, performances of a solver run. */
PEMESHFILTERSCORE_EXPORT void SetFieldNumber(
  vtkDataObject* data, const std::string& name, double value);
PEMESHFILTERSCORE_EXPORT void SetFieldText(
  vtkDataObject* data, const std::string& name, const std::string& value);
/** Empty where there is no such array. */
PEMESHFILTERSCORE_EXPORT std::string GetFieldText(vtkDataObject* data, const std::string& name);
/** NaN where there is no such array. */
PEMESHFILTERSCORE_EXPORT double GetFieldNumber(vtkDataObject* data, const std::string& name);
///@}

///@{
/**
 * Lists of names kept in the field data, without repetition:
 * `Parameters` are the quantities that a case varies (columns that lead its row), `Measured` the
 * performances that depend on the machine (seconds, bytes), which never enter the results table.
 */
inline constexpr const char* ParametersList = "Parameters";
inline constexpr const char* MeasuredList = "Measured";
PEMESHFILTERSCORE_EXPORT void AddToFieldList(
  vtkDataObject* data, const std::string& list, const std::string& name);
PEMESHFILTERSCORE_EXPORT bool IsInFieldList(
  vtkDataObject* data, const std::string& list, const std::string& name);
///@}

/** The name of the mesh, used in file names and tables: field text `Mesh`. */
inline constexpr const char* MeshNameField = "Mesh";

} // namespace pemesh

#endif

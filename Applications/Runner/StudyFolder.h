// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The folder of the results of a study: whether it may be written into, and what of an earlier run
 * must go from it so that nobody takes it for results of this one.
 */
#ifndef pemesh_StudyFolder_h
#define pemesh_StudyFolder_h

#include <filesystem>
#include <vector>

namespace pemesh
{

struct Study;
struct StudyCase;

/** Throws std::runtime_error where the folder holds something else than the results of a study. */
void CheckStudyFolder(const std::filesystem::path& folder);

/**
 * Removes what an earlier run has written for meshes, solvers and figures that the study does not
 * have any more, known from the study.json of that run; what programs that were killed left half
 * written; and, unless the study `goesOn` from there, the tables. Other files, of the user or of
 * the solvers, stay. To be called before the new study.json is written.
 */
void RemoveStaleFiles(const std::filesystem::path& folder, const Study& study,
  const std::vector<StudyCase>& cases, bool goesOn);

/** Removes the mesh of one case in all formats, where the case has none any more. */
void RemoveMeshFiles(
  const std::filesystem::path& folder, const Study& study, const StudyCase& studyCase);

/** Whether the mesh of a case is there, whole, in all formats of the study. */
bool HasMeshFilesOf(
  const std::filesystem::path& folder, const Study& study, const StudyCase& studyCase);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tells whether the row of a case can be taken from an earlier run.
 */
#ifndef pemesh_StudyCaseKey_h
#define pemesh_StudyCaseKey_h

#include <filesystem>
#include <string>
#include <vector>

namespace pemesh
{

struct SolverDescription;
struct Study;
struct StudyCase;

/**
 * A digest of all that the row and the mesh of a case follow from: the study with the values of
 * the case, the bytes of the files that it names, the solvers and what they say of their version,
 * and the version of PEMesh. Two cases with one key have the same row. `meshFiles` are those of the
 * study, by the time of the case.
 */
std::string StudyCaseKey(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<std::filesystem::path>& meshFiles, const StudyCase& studyCase);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The cases of a study: one mesh each, whatever is swept.
 */
#ifndef pemesh_StudyCases_h
#define pemesh_StudyCases_h

#include "StudySweeps.h"
#include "pemeshRunnerModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

struct Study;

struct StudyCase
{
  int Index = 0;
  /** Name of the mesh in files and tables, unique in the study. */
  std::string Name;
  /** What time the source is asked for: t of a layout, the index of a mesh file. */
  double Time = 0.0;
  /** What is swept, in the order of the study. */
  std::vector<SweptValue> Values;
};

/**
 * Throws std::runtime_error when the study names no mesh, and when a swept value is not allowed
 * where it is set.
 */
PEMESHRUNNER_EXPORT std::vector<StudyCase> MakeStudyCases(const Study& study);

/**
 * Name of a generated mesh, as in "009_0.426316": index with at least three digits and, where t is
 * swept, its value with six decimals.
 */
std::string GeneratedMeshName(int index, int count, const std::vector<SweptValue>& values);

} // namespace pemesh

#endif

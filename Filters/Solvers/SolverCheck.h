// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tries a solver before a study does, and says what is wrong with it or with its description.
 */
#ifndef pemesh_SolverCheck_h
#define pemesh_SolverCheck_h

#include "pemeshFiltersSolversModule.h" // For export macro

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pemesh
{

struct SolverDescription;

struct SolverFinding
{
  bool IsError = true; // else it is worth knowing
  std::string Sentence;
};

/**
 * Runs the solver on a mesh of eight elements (three, four and five vertices) of the unit square,
 * and on the same mesh with its vertices in another order, which must change nothing but the order
 * of the solution. `options` are those that are not to have their defaults; the files go to the
 * folder, an empty one stands for a temporary one. No finding: all is well.
 */
PEMESHFILTERSSOLVERS_EXPORT std::vector<SolverFinding> CheckSolver(
  const SolverDescription& description, const std::map<std::string, std::string>& options,
  const std::filesystem::path& folder);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One call of a solver, for one mesh or for a list of them; private to the module.
 */
#ifndef pemesh_SolverCall_h
#define pemesh_SolverCall_h

#include "ChildProcess.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pemesh
{

class SolverFolder;
struct MeshFormat;
struct SolverDescription;
struct SolverRun;

/** What one mesh, which lies in its folder, wants of a call, and how that went. */
struct SolverRequest
{
  const SolverRun& Run;
  SolverFolder& Folder;
  std::filesystem::path MeshFile;

  ChildProcessResult Result;
  bool IsFolderTooLarge = false; // so that it was cancelled
  bool IsShared = false;         // with other meshes
  std::string Error;             // why there was no call, if there was none
  bool IsMissing = false;        // because there is no such program
};

/** What a run is called in messages. */
std::string NameOfSolver(const SolverRun& run);

/** The format in which the solver reads meshes. Throws std::runtime_error with a sentence. */
const MeshFormat& SolverMeshFormat(const std::string& name);

/**
 * The values of all placeholders, for a mesh file that may be only imagined. A solver that takes a
 * list is told nothing of a single mesh.
 */
std::map<std::string, std::string> SolverPlaceholders(
  const SolverRun& run, const MeshFormat& format, const std::filesystem::path& mesh);

/** The files that a call itself leaves in the folder of a mesh. */
std::vector<std::filesystem::path> SolverCallFiles(const SolverFolder& folder);

/**
 * Calls the solver for this mesh, and for those of others who wait in the queue of the run if it
 * takes lists, unless `isAlone`. Throws nothing: Error says what went wrong.
 */
void CallSolver(SolverRequest& request, bool isAlone);

} // namespace pemesh

#endif

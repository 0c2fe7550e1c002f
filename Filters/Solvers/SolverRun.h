// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One run of an external solver on one mesh, from the mesh to its answer; private to the filter.
 */
#ifndef pemesh_SolverRun_h
#define pemesh_SolverRun_h

#include "SolverAnswer.h"
#include "SolverDescription.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

class vtkPolyData;

namespace pemesh
{

class MemoryBudget;
class SolverQueue;

struct SolverRun
{
  SolverDescription Description;
  std::map<std::string, std::string> Options; // every option with its value
  std::filesystem::path WorkDirectory;        // empty: a temporary folder
  int Threads = 1;
  int Retries = 0;
  MemoryBudget* Budget = nullptr;           // shared with others that run
  SolverQueue* Queue = nullptr;             // the same; it makes the lists of meshes
  bool ReusesAnswer = false;                // of an earlier run that was asked the same
  std::string Version;                      // of the solver: part of the question
  std::function<bool(double seconds)> GoOn; // false cancels
};

struct SolverOutcome
{
  std::string Status; // "ok" or what went wrong, in a word
  std::string Message;
  std::string Hint;    // what was unusual of a run that has ended by itself: files, processes
  SolverAnswer Answer; // what is good of it; empty unless ok or partial
};

/** Throws std::runtime_error where no mesh could ever be solved like this. */
void CheckSolverRun(const SolverRun& run);

/** Never throws for what the mesh, the disk or the solver does: the outcome says it. */
SolverOutcome RunSolver(const SolverRun& run, vtkPolyData* mesh);

} // namespace pemesh

#endif

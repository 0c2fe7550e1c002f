// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a run is, as every process of it must know it.
 */
#ifndef pemesh_StudyTask_h
#define pemesh_StudyTask_h

#include "CaseWorkers.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pemesh
{

struct StudyTask
{
  /** The document, and the file that it stands for: relative paths are resolved against that. */
  std::string Text;
  std::filesystem::path Source;
  bool MeshesOnly = false;
  std::vector<std::string> Formats;  // none: those of the study
  std::vector<std::string> Versions; // of the solvers, in the order of the study
  CaseWorkers::Options Options;
};

struct LoadedStudy
{
  Study TheStudy;
  std::vector<SolverDescription> Solvers;
  std::vector<StudyCase> Cases;
};

/** Throws std::runtime_error with a sentence. */
LoadedStudy LoadStudy(const StudyTask& task);

///@{
/** As a message. */
std::vector<std::string> FieldsOfTask(const StudyTask& task);
StudyTask TaskOfFields(const std::vector<std::string>& fields);
///@}

} // namespace pemesh

#endif

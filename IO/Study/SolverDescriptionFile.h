// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Descriptions of external solvers: one JSON file each, found by name in the search folders.
 * All functions throw std::runtime_error with one sentence that names the file and the key.
 */
#ifndef pemesh_SolverDescriptionFile_h
#define pemesh_SolverDescriptionFile_h

#include "SolverDescription.h"
#include "Study.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/** A limit of the run of a solver on one mesh: a key of descriptions and of the runs of a study. */
struct SolverLimit
{
  const char* Key;
  const char* Doc;
  double SolverDescription::*OfDescription;
  std::optional<double> StudySolver::*OfRun;
};
PEMESHIOSTUDY_EXPORT const std::vector<SolverLimit>& SolverLimits();

/** Reads a description; its Folder becomes that of the file. */
PEMESHIOSTUDY_EXPORT SolverDescription ReadSolverDescription(const std::filesystem::path& path);

PEMESHIOSTUDY_EXPORT SolverDescription ParseSolverDescription(
  std::string_view text, const std::filesystem::path& path);

PEMESHIOSTUDY_EXPORT std::string FormatSolverDescription(const SolverDescription& description);

/**
 * Where descriptions are looked for, first match wins: the folders of the environment variable
 * PEMESH_SOLVERS (separated as in PATH), share/pemesh/solvers of the installation that the running
 * program or this library belongs to, and for a build tree the descriptions of the source tree.
 */
PEMESHIOSTUDY_EXPORT std::vector<std::filesystem::path> SolverFolders();

/** A description found in a search folder, or why it cannot be used. */
struct FoundSolver
{
  std::filesystem::path File;
  SolverDescription Description;
  std::string Error; // empty if the file is good
};

/** The solver that needs nothing installed: what to begin with. */
inline constexpr const char* BundledSolver = "pemesh-vem";

/**
 * All descriptions of the search folders, the bundled solver first, the others in order of name; of
 * two with one name the first found.
 */
PEMESHIOSTUDY_EXPORT std::vector<FoundSolver> ListSolvers(
  const std::vector<std::filesystem::path>& folders = SolverFolders());

/** A description by its name, or by the path of its file (ends in .json, relative to `base`). */
PEMESHIOSTUDY_EXPORT SolverDescription FindSolver(const std::string& nameOrFile,
  const std::filesystem::path& base = {},
  const std::vector<std::filesystem::path>& folders = SolverFolders());

/**
 * The description of every run of the study, in order. Checks the options of the runs against it
 * (unknown name, wrong type) and writes the defaults of those not given, and the limits, into the
 * study.
 */
PEMESHIOSTUDY_EXPORT std::vector<SolverDescription> FindStudySolvers(
  Study& study, const std::vector<std::filesystem::path>& folders = SolverFolders());

} // namespace pemesh

#endif

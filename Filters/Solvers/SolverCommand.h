// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * From the command of a description to the argument list of a child process.
 */
#ifndef pemesh_SolverCommand_h
#define pemesh_SolverCommand_h

#include "pemeshFiltersSolversModule.h" // For export macro

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pemesh
{

struct SolverDescription;

/**
 * The arguments with each {name} replaced by its value and "{{", "}}" by braces. Throws
 * std::runtime_error where a placeholder has no value, naming it and the ones there are.
 */
PEMESHFILTERSSOLVERS_EXPORT std::vector<std::string> ExpandCommand(
  const std::vector<std::string>& command, const std::map<std::string, std::string>& values);

/**
 * The file of a program: an absolute path as it is; with a slash, relative to `folder`; else
 * beside the running program, else in PATH. Empty where there is no such file.
 */
PEMESHFILTERSSOLVERS_EXPORT std::filesystem::path FindSolverProgram(
  const std::string& program, const std::filesystem::path& folder);

/**
 * What the solver says about its version: the first line that its version command prints; empty
 * where there is no such command or it does not answer within ten seconds.
 */
PEMESHFILTERSSOLVERS_EXPORT std::string AskSolverVersion(const SolverDescription& description);

/** The placeholder {folder}: an absolute path, because solvers run in folders of their own. */
PEMESHFILTERSSOLVERS_EXPORT std::string SolverDescriptionFolder(
  const SolverDescription& description);

/**
 * Changes where the answers of the solver may change: with its description (limits and labels
 * aside), and with the programs and scripts that its command names.
 */
PEMESHFILTERSSOLVERS_EXPORT std::string SolverFingerprint(const SolverDescription& description);

/** Whether its command names {list}. */
PEMESHFILTERSSOLVERS_EXPORT bool TakesList(const SolverDescription& description);

} // namespace pemesh

#endif

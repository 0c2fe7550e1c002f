// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Runs a program of the build tree as a user would, and keeps what it said.
 */
#ifndef pemesh_ProgramRun_h
#define pemesh_ProgramRun_h

#include "TestFolder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pemesh
{

struct ProgramRun
{
  int ExitCode = -1; // 128 + n where signal n ended it
  std::string Output;
  std::string Errors;
};

/** `program` is a name in the build tree's bin, or a path. `folder` is where it runs. */
ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::filesystem::path& folder = {});

/** The whole file, or "" if there is none. */
std::string FileText(const std::filesystem::path& path);

} // namespace pemesh

#endif

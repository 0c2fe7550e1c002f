// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `pemesh`: studies without a window.
 */
#include "Commands.h"
#include "Terminal.h"

#include <CLI/CLI.hpp>

#include <exception>

namespace
{

int RunProgram(int argc, char** argv)
{
  CLI::App program("How the geometry of polygonal meshes affects polytopal element methods.\n"
                   "Exit code: 0 all was done, 1 part of it failed (the rest is done and saved),\n"
                   "2 wrong usage or input.");
  program.name("pemesh");
  program.set_version_flag("--version", std::string("pemesh ") + PEMESH_VERSION);
  program.require_subcommand(1);

  int exitCode = pemesh::AllDone;
  pemesh::AddStudyCommands(program, exitCode);
  pemesh::AddSlurmCommand(program, exitCode);
  pemesh::AddMetricsCommand(program, exitCode);
  pemesh::AddRenderCommand(program, exitCode);
  pemesh::AddCheckCommand(program, exitCode);
  pemesh::AddConvertCommand(program, exitCode);
  pemesh::AddCorrelateCommand(program, exitCode);
  pemesh::AddPlotCommand(program, exitCode);
  pemesh::AddReportCommand(program, exitCode);
  pemesh::AddConvergenceCommand(program, exitCode);
  pemesh::AddSolversCommand(program, exitCode);
  pemesh::AddListCommand(program, exitCode);

  pemesh::InstallMessageHandler();
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return program.exit(error) == 0 ? pemesh::AllDone : pemesh::WrongUsage;
  }
  catch (const std::exception& error)
  {
    pemesh::Complain(error.what());
    return pemesh::WrongUsage;
  }
  return exitCode;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return RunProgram(argc, argv);
  }
  catch (...) // not even a sentence could be printed
  {
    return pemesh::PartFailed;
  }
}

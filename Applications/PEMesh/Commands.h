// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The commands of `pemesh`. Each function adds some to the program and stores the exit code of the
 * one that runs; main.cxx has the list. A command throws std::runtime_error with a sentence where
 * its arguments or files are wrong.
 */
#ifndef pemesh_Commands_h
#define pemesh_Commands_h

namespace CLI
{
class App;
}

namespace pemesh
{

/** run, generate, solve: what the Runner does. */
void AddStudyCommands(CLI::App& program, int& exitCode);

/** metrics: mesh files, one after the other. */
void AddMetricsCommand(CLI::App& program, int& exitCode);

/** render: mesh files, side by side. */
void AddRenderCommand(CLI::App& program, int& exitCode);

/** correlate, plot: what is done with a table. */
void AddTableCommands(CLI::App& program, int& exitCode);

/** check: what is wrong with mesh files. */
void AddCheckCommand(CLI::App& program, int& exitCode);

/** solvers check: a solver on a tiny mesh. */
void AddSolversCommand(CLI::App& program, int& exitCode);

/** list: the tables to choose from. */
void AddListCommand(CLI::App& program, int& exitCode);

} // namespace pemesh

#endif

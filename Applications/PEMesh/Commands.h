// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The commands of `pemesh`. Each function adds some to the program and stores the exit code of the
 * one that runs; main.cxx has the list. A command throws std::runtime_error with a sentence where
 * its arguments or files are wrong.
 */
#ifndef pemesh_Commands_h
#define pemesh_Commands_h

#include <string>

namespace CLI
{
class App;
}

namespace pemesh
{

/** run, generate, solve: what the Runner does. */
void AddStudyCommands(CLI::App& program, int& exitCode);

/** slurm: a study as a batch script. */
void AddSlurmCommand(CLI::App& program, int& exitCode);

/** metrics: mesh files, one after the other. */
void AddMetricsCommand(CLI::App& program, int& exitCode);

/** render: mesh files, side by side. */
void AddRenderCommand(CLI::App& program, int& exitCode);

/** correlate: tables of results, one or several. */
void AddCorrelateCommand(CLI::App& program, int& exitCode);

/** plot: charts of tables. */
void AddPlotCommand(CLI::App& program, int& exitCode);

/** report: the results of a study on one page. */
void AddReportCommand(CLI::App& program, int& exitCode);

/** Writes that page of a folder and says where it is. An exit code. */
int WriteReport(const std::string& folder, const std::string& file);

/** convergence: the observed orders in a table. */
void AddConvergenceCommand(CLI::App& program, int& exitCode);

/** check: what is wrong with mesh files. */
void AddCheckCommand(CLI::App& program, int& exitCode);

/** convert: mesh files into another format. */
void AddConvertCommand(CLI::App& program, int& exitCode);

/** solvers check: a solver on a tiny mesh. */
void AddSolversCommand(CLI::App& program, int& exitCode);

/** list: the tables to choose from. */
void AddListCommand(CLI::App& program, int& exitCode);

} // namespace pemesh

#endif

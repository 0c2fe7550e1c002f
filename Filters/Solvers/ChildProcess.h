// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Runs a program and waits for it, with a time limit and a way to cancel.
 *
 * Why not vtksys' Process: it installs a handler of SIGCHLD for the whole program and keeps its
 * processes in one global array that the handler walks; it guards that array by blocking the
 * signal in the calling thread, so that with several threads a handler may walk an array that
 * another thread has freed, and pipes of one child leak into another. posix_spawn has none of
 * this: no handler, no global state, descriptors that are closed on exec from the start. Any
 * number of threads may run programs at once.
 *
 * Between this program and the child stands pemesh-supervise (Applications/Supervisor), which
 * keeps the limits and ends the child with all that it has started, also when this program is
 * killed.
 */
#ifndef pemesh_ChildProcess_h
#define pemesh_ChildProcess_h

#include "pemeshFiltersSolversModule.h" // For export macro

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pemesh
{

struct ChildProcess
{
  /** The program (an absolute path: nothing is searched) and its arguments. No shell sees them. */
  std::vector<std::string> Arguments;
  /** Must exist. */
  std::filesystem::path WorkingDirectory;
  /** Set in the child beside the environment of this program. */
  std::vector<std::pair<std::string, std::string>> Environment;
  ///@{
  /** Where its output goes; empty: nowhere. Written as it comes, replaced if there. */
  std::filesystem::path OutputFile;
  std::filesystem::path ErrorFile;
  ///@}
  /** Output beyond this many bytes a file is dropped, and the file says so. */
  std::size_t OutputLimit = std::size_t{ 16 } << 20;
  ///@{
  /** 0 = none. */
  double TimeLimit = 0.0;      // seconds
  double ProcessorLimit = 0.0; // seconds of processors, of all its processes
  double MemoryLimit = 0.0;    // bytes resident, of all its processes together
  double FileLimit = 0.0;      // bytes, of each file that it writes
  ///@}
  /** Called about ten times a second with the seconds gone; false ends the child. */
  std::function<bool(double seconds)> GoOn;
};

struct ChildProcessResult
{
  enum class Ending
  {
    Exited,    // by itself, with ExitStatus
    Signal,    // by a signal, whose name is in Reason
    TimeLimit, // ended by force, as are the next three
    ProcessorLimit,
    MemoryLimit,
    Cancelled,  // because GoOn said so
    NotStarted, // Reason says why; IsMissing if there is no such program
  };
  Ending How = Ending::NotStarted;
  int ExitStatus = 0;
  bool IsMissing = false;
  bool IsFileTooLarge = false; // the signal was that of FileLimit
  std::string Reason;
  double ProcessorSeconds = 0.0; // of all its processes
  double PeakMemory = 0.0;       // bytes resident, of all its processes together
  int ProcessesLeft = 0;         // that it had left running and that were ended
  /** The last line written to standard error that is not blank, shortened. */
  std::string LastErrorLine;
};

/**
 * All that the child has started ends with it, however it ends, and wherever it hides: in another
 * process group, in a session of its own. A child to be ended gets SIGTERM, so that a launcher such
 * as mpirun can clean up, and half a second later SIGKILL (at once if it is for its memory).
 * Numbers are written with a decimal point in the child, whatever the language of the user
 * (LC_NUMERIC is C). No core file is written.
 *
 * Throws std::runtime_error where a log file cannot be written.
 */
PEMESHFILTERSSOLVERS_EXPORT ChildProcessResult RunChildProcess(const ChildProcess& child);

} // namespace pemesh

#endif

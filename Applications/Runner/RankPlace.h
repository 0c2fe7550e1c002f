// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where a process of a run is, and what of the machine is its own.
 */
#ifndef pemesh_RankPlace_h
#define pemesh_RankPlace_h

#include <map>
#include <string>

namespace pemesh
{

struct StudyTask;

std::string MachineOfProcess();

/** The machine and the cores that this process is bound to: "node7 0,1,2,3". */
std::string PlaceOfProcess();

/**
 * Changes a task to the share of a process at `own`, where `places` has all, this one too: where no
 * number of workers is asked for, the cores of the place by the processes that are bound to just
 * these, at least one worker; the memory of solvers by the processes on the machine.
 */
void ShareTask(StudyTask& task, const std::string& own, const std::map<int, std::string>& places);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The processes that mpiexec has started together with this one.
 */
#ifndef pemesh_Ranks_h
#define pemesh_Ranks_h

#include <functional>

namespace pemesh
{

class RankChannel;

/**
 * Does a study in the first process (its channel is null where it is alone), while the others work
 * for it; answers with the exit code. Throws std::runtime_error with a sentence where this PEMesh
 * was built without MPI and started by it.
 */
int RunWithRanks(const std::function<int(RankChannel*)>& study);

} // namespace pemesh

#endif

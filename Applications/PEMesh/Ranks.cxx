// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks.h"

#include "Commands.h"
#include "RankBoard.h"
#include "RankChannel.h"
#include "Terminal.h"

#include <csignal>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace pemesh
{

namespace
{

/** How many processes were started together: known before MPI is, which takes its time to start. */
int ProcessesStarted()
{
  // Open MPI; MPICH, Intel MPI and Slurm's PMI; Slurm's srun.
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS" })
  {
    if (const char* value = std::getenv(name))
    {
      return std::atoi(value);
    }
  }
  return 1;
}

std::unique_ptr<RankChannel> OpenRankChannel()
{
  const int processes = ProcessesStarted();
  if (processes < 2)
  {
    return nullptr;
  }
  using Open = RankChannel*();
  void* library = dlopen("libpemesh-ranks.so", RTLD_NOW | RTLD_GLOBAL);
  Open* open = library ? reinterpret_cast<Open*>(dlsym(library, "PEMeshOpenRankChannel")) : nullptr;
  if (!open)
  {
    throw std::runtime_error("This is one of " + std::to_string(processes) +
      " processes, but PEMesh was built without MPI, or its library is gone; start it without "
      "mpiexec, or build it with -DPEMESH_USE_MPI=ON.");
  }
  std::unique_ptr<RankChannel> channel(open());
  if (channel->GetSize() == 1)
  {
    throw std::runtime_error("This is one of " + std::to_string(processes) +
      " processes that do not know each other; start them by the mpiexec of Open MPI, for which "
      "this PEMesh was built (with srun: --mpi=pmix).");
  }
  return channel;
}

} // namespace

int RunWithRanks(const std::function<int(RankChannel*)>& study)
{
  const std::unique_ptr<RankChannel> channel = OpenRankChannel();
  if (channel && channel->GetRank() > 0)
  {
    std::signal(SIGINT, SIG_IGN); // the first process is told too, and tells when to stop
    std::signal(SIGTERM, SIG_IGN);
    std::signal(SIGUSR1, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    WorkForFirstRank(*channel);
    return AllDone;
  }
  return study(channel.get());
}

} // namespace pemesh

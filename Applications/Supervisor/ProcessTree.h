// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The processes that descend from this one, as Linux shows them in /proc.
 */
#ifndef pemesh_ProcessTree_h
#define pemesh_ProcessTree_h

#include <cstdint>
#include <vector>

#include <sys/types.h>

namespace pemesh
{

struct ProcessUsage
{
  bool IsAlive = false;          // neither gone nor a zombie
  double ProcessorSeconds = 0.0; // of the process and of the children that it has waited for
  std::uint64_t Memory = 0;      // resident, bytes; pages shared by processes count for each
};

/**
 * Children, their children and so on. One that forks meanwhile may be missed: ask again. Neither
 * function throws, because nobody would keep watch if the supervisor ended: what cannot be found
 * out is left out.
 */
std::vector<pid_t> Descendants() noexcept;

ProcessUsage UsageOf(pid_t process) noexcept;

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RankPlace.h"

#include "StudyTask.h"

#include <algorithm>
#include <array>

#include <sched.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

std::string MachineOf(const std::string& place)
{
  return place.substr(0, place.rfind(' '));
}

long CoresOf(const std::string& place)
{
  return 1 + std::count(place.begin(), place.end(), ',');
}

} // namespace

std::string MachineOfProcess()
{
  std::array<char, 256> machine{};
  gethostname(machine.data(), machine.size() - 1);
  return machine.data();
}

std::string PlaceOfProcess()
{
  cpu_set_t bound;
  CPU_ZERO(&bound);
  sched_getaffinity(0, sizeof(bound), &bound);
  std::string cores;
  for (std::size_t i = 0; i < CPU_SETSIZE; ++i)
  {
    cores += CPU_ISSET(i, &bound) ? (cores.empty() ? "" : ",") + std::to_string(i) : "";
  }
  return MachineOfProcess() + ' ' + cores;
}

void ShareTask(StudyTask& task, const std::string& own, const std::map<int, std::string>& places)
{
  const auto count = [&](auto part)
  {
    return std::count_if(places.begin(), places.end(),
      [&](const auto& entry) { return part(entry.second) == part(own); });
  };
  if (task.Options.Workers == 0)
  {
    const long sharing = count([](const std::string& place) { return place; });
    task.Options.Workers = static_cast<int>(std::max(1L, CoresOf(own) / sharing));
  }
  task.Options.SolverMemory /= static_cast<double>(count(MachineOf));
}

} // namespace pemesh

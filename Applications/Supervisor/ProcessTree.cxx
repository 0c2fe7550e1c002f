// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProcessTree.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <unistd.h>

namespace pemesh
{

namespace
{

/** Every thread has a list of the children that it has started. */
void AppendChildren(pid_t parent, std::vector<pid_t>& processes)
{
  std::error_code error;
  const std::filesystem::path threads = "/proc/" + std::to_string(parent) + "/task";
  for (std::filesystem::directory_iterator thread(threads, error), end; !error && thread != end;
       thread.increment(error))
  {
    std::ifstream children(thread->path() / "children");
    for (pid_t child = 0; children >> child;)
    {
      if (std::find(processes.begin(), processes.end(), child) == processes.end())
      {
        processes.push_back(child);
      }
    }
  }
}

ProcessUsage ReadUsage(pid_t process)
{
  std::ifstream stream("/proc/" + std::to_string(process) + "/stat");
  // Empty where the process ends meanwhile: reading by iterators would throw then.
  std::string text;
  std::getline(stream, text, '\0');
  // The name of the program stands in parentheses and may hold anything, even parentheses.
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string state;
  fields >> state;
  ProcessUsage usage;
  usage.IsAlive = !state.empty() && state != "Z" && state != "X";
  // Fields as numbered in proc(5), the state being number 3.
  constexpr int firstTime = 14; // utime, stime, cutime, cstime
  constexpr int lastTime = 17;
  constexpr int residentPages = 24;
  double ticks = 0.0;
  for (int number = 4; number <= residentPages; ++number)
  {
    std::string word; // some are negative, some larger than a signed number
    fields >> word;
    if (number >= firstTime && number <= lastTime)
    {
      ticks += std::strtod(word.c_str(), nullptr);
    }
    else if (number == residentPages)
    {
      usage.Memory = std::strtoull(word.c_str(), nullptr, 10) *
        static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    }
  }
  usage.ProcessorSeconds = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
  return usage;
}

} // namespace

std::vector<pid_t> Descendants() noexcept
{
  std::vector<pid_t> processes;
  try
  {
    AppendChildren(getpid(), processes);
    for (std::size_t i = 0; i < processes.size(); ++i)
    {
      AppendChildren(processes[i], processes);
    }
  }
  catch (const std::exception&)
  {
    return processes;
  }
  return processes;
}

ProcessUsage UsageOf(pid_t process) noexcept
{
  try
  {
    return ReadUsage(process);
  }
  catch (const std::exception&)
  {
    return {};
  }
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HalfWrittenFiles.h"

#include <cerrno>
#include <csignal>
#include <regex>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pemesh
{

void RemoveHalfWrittenFiles(const std::filesystem::path& folder)
{
  // "results.csv.part123-0" of a process 123.
  static const std::regex pattern("[^]+\\.part([0-9]{1,9})-[0-9]+");
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    std::smatch match;
    constexpr std::size_t longest = 255; // of a name; a bound for std::regex as well
    if (name.size() <= longest && std::regex_match(name, match, pattern) &&
      kill(static_cast<pid_t>(std::stol(match[1])), 0) != 0 && errno == ESRCH)
    {
      files.push_back(entry->path());
    }
  }
  for (const std::filesystem::path& file : files)
  {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
}

} // namespace pemesh

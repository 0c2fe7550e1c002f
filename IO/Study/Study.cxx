// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Study.h"

#include "NumberText.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/** Digits from `at` on, without leading zeros. */
std::string_view TakeDigits(std::string_view text, std::size_t& at)
{
  while (at + 1 < text.size() && text[at] == '0' && IsDigit(text[at + 1]))
  {
    ++at;
  }
  const std::size_t first = at;
  while (at < text.size() && IsDigit(text[at]))
  {
    ++at;
  }
  return text.substr(first, at - first);
}

/** By character, but runs of digits by their value. */
bool ComesBefore(const std::string& a, const std::string& b)
{
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size())
  {
    if (IsDigit(a[i]) && IsDigit(b[j]))
    {
      const std::string_view left = TakeDigits(a, i);
      const std::string_view right = TakeDigits(b, j);
      if (left != right)
      {
        return left.size() != right.size() ? left.size() < right.size() : left < right;
      }
      continue;
    }
    if (a[i] != b[j])
    {
      return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
    }
    ++i;
    ++j;
  }
  const bool isLeftDone = i == a.size();
  const bool isRightDone = j == b.size();
  // Equal but for leading zeros: any fixed order will do.
  return isLeftDone == isRightDone ? a < b : isLeftDone;
}

/** With * for any characters and ? for one; both go back to the last * where they fail. */
bool Matches(std::string_view text, std::string_view pattern)
{
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t star = std::string_view::npos;
  std::size_t retry = 0;
  while (i < text.size())
  {
    if (j < pattern.size() && pattern[j] == '*')
    {
      star = j++;
      retry = i;
    }
    else if (j < pattern.size() && (pattern[j] == '?' || pattern[j] == text[i]))
    {
      ++i;
      ++j;
    }
    else if (star != std::string_view::npos)
    {
      j = star + 1;
      i = ++retry;
    }
    else
    {
      return false;
    }
  }
  return pattern.find_first_not_of('*', j) == std::string_view::npos;
}

bool HasWildcard(const std::string& text)
{
  return text.find_first_of("*?") != std::string::npos;
}

/** What in `folder` matches one component of a pattern, sorted. */
std::vector<fs::path> MatchingEntries(const fs::path& folder, const std::string& component)
{
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    // As in a command line, a hidden file is meant only if the pattern says so.
    if (Matches(name, component) && (name.front() != '.' || component.front() == '.'))
    {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end(), ComesBefore);
  std::vector<fs::path> paths;
  for (const std::string& name : names)
  {
    paths.push_back(folder / name);
  }
  return paths;
}

/** The files that a pattern names, sorted. */
std::vector<fs::path> ExpandPattern(const fs::path& pattern)
{
  std::vector<fs::path> paths{ fs::path() };
  for (const fs::path& component : pattern)
  {
    std::vector<fs::path> next;
    for (const fs::path& path : paths)
    {
      if (HasWildcard(component.string()))
      {
        const std::vector<fs::path> entries =
          MatchingEntries(path.empty() ? fs::path(".") : path, component.string());
        next.insert(next.end(), entries.begin(), entries.end());
      }
      else
      {
        next.push_back(path / component);
      }
    }
    paths = std::move(next);
  }
  std::erase_if(paths,
    [](const fs::path& path)
    {
      std::error_code error;
      return !fs::exists(path, error) || fs::is_directory(path, error);
    });
  return paths;
}

[[noreturn]] void FailToFind(const std::string& pattern, const fs::path& full)
{
  std::error_code error;
  if (HasWildcard(pattern))
  {
    throw std::runtime_error(
      "No mesh file matches \"" + pattern + "\" (looked for \"" + full.string() + "\").");
  }
  if (fs::is_directory(full, error))
  {
    throw std::runtime_error("The mesh file \"" + pattern +
      "\" is a folder: name the files in it with a pattern such as \"" +
      (fs::path(pattern) / "*.off").lexically_normal().string() + "\".");
  }
  throw std::runtime_error(
    "The mesh file \"" + pattern + "\" does not exist (looked for \"" + full.string() + "\").");
}

} // namespace

std::string FormatScalar(const StudyScalar& value)
{
  if (const bool* truth = std::get_if<bool>(&value))
  {
    return *truth ? "true" : "false";
  }
  if (const auto* integer = std::get_if<std::int64_t>(&value))
  {
    return std::to_string(*integer);
  }
  const auto* number = std::get_if<double>(&value);
  return number ? FormatNumber(*number) : std::get<std::string>(value);
}

double ScalarToNumber(const StudyScalar& value)
{
  if (const auto* integer = std::get_if<std::int64_t>(&value))
  {
    return static_cast<double>(*integer);
  }
  const auto* number = std::get_if<double>(&value);
  return number ? *number : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::filesystem::path> FindStudyMeshes(const Study& study)
{
  std::vector<fs::path> found;
  std::set<fs::path> seen;
  for (const std::string& pattern : study.Meshes)
  {
    const fs::path full = (study.Folder / pattern).lexically_normal();
    const std::vector<fs::path> files = ExpandPattern(full);
    if (files.empty())
    {
      FailToFind(pattern, full);
    }
    for (const fs::path& file : files)
    {
      if (seen.insert(file).second)
      {
        found.push_back(file);
      }
    }
  }
  return found;
}

} // namespace pemesh

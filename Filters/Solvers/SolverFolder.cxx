// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverFolder.h"

#include "HalfWrittenFiles.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pemesh
{

SolverFolder::SolverFolder(const fs::path& workDirectory, const std::string& stem)
{
  fs::path root = workDirectory;
  if (root.empty())
  {
    std::string name = (fs::temp_directory_path() / "pemesh-XXXXXX").string();
    if (!mkdtemp(name.data()))
    {
      throw std::runtime_error(
        "Cannot make a temporary folder: " + std::string(std::strerror(errno)) + ".");
    }
    root = this->Temporary = name;
  }
  this->Path = fs::absolute(root / stem).lexically_normal();
  this->Make();
  RemoveHalfWrittenFiles(this->Path); // of a run that was killed
}

void SolverFolder::Make() const
{
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(this->Path, error)))
  {
    // A solver may have put it there, and what it leads to is not ours to write into.
    throw std::runtime_error("The folder \"" + this->Path.string() + "\" is a link: remove it.");
  }
  error.clear();
  fs::create_directories(this->Path, error);
  if (error)
  {
    throw std::runtime_error(
      "Cannot make the folder \"" + this->Path.string() + "\": " + error.message() + ".");
  }
}

bool SolverFolder::IsThere() const
{
  std::error_code error;
  return fs::is_directory(fs::symlink_status(this->Path, error));
}

SolverFolder::~SolverFolder()
{
  if (!this->Temporary.empty())
  {
    std::error_code ignored;
    fs::remove_all(this->Temporary, ignored);
  }
}

void SolverFolder::Remove(const std::vector<fs::path>& files)
{
  for (const fs::path& file : files)
  {
    std::error_code error;
    fs::remove_all(file, error); // a solver may have made a folder of that name
    if (error)
    {
      throw std::runtime_error(
        "Cannot remove the old file \"" + file.string() + "\": " + error.message() + ".");
    }
  }
}

std::set<std::string> SolverFolder::Names() const
{
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(this->Path, error), end; !error && entry != end;
       entry.increment(error))
  {
    names.insert(entry->path().filename().string());
  }
  return names;
}

void SolverFolder::NoteNames()
{
  this->Noted = this->Names();
}

std::vector<std::string> SolverFolder::FindNew(const std::vector<fs::path>& expected) const
{
  std::set<std::string> names = this->Names();
  for (const fs::path& file : expected)
  {
    names.erase(file.filename().string());
  }
  std::erase_if(names, [this](const std::string& name) { return this->Noted.count(name) > 0; });
  return { names.begin(), names.end() };
}

std::uintmax_t SolverFolder::GetSize() const
{
  std::uintmax_t size = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator
         entry(this->Path, fs::directory_options::skip_permission_denied, error),
       end;
       !error && entry != end; entry.increment(error))
  {
    std::error_code gone;
    if (fs::is_regular_file(entry->symlink_status(gone)))
    {
      const std::uintmax_t bytes = entry->file_size(gone);
      size += gone ? 0 : bytes;
    }
  }
  return size;
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TextFile.h"

#include "FileDescriptor.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

[[noreturn]] void Fail(const char* verb, const std::filesystem::path& path, const std::string& why)
{
  throw std::runtime_error(
    std::string("Cannot ") + verb + " \"" + path.string() + "\": " + why + ".");
}

/** So that after a power cut the name does not lead to a file of nothing but zeros. */
void Flush(const std::filesystem::path& temporary, const std::filesystem::path& path)
{
  const FileDescriptor file(open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.IsOpen() && fdatasync(file.Get()) != 0 && errno != EINVAL && errno != EROFS)
  {
    Fail("write", path, std::strerror(errno));
  }
}

} // namespace

std::string ReadTextFile(const std::filesystem::path& path, std::size_t most)
{
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status = {};
  if (file.Get() < 0 || fstat(file.Get(), &status) != 0)
  {
    Fail("read", path, std::strerror(errno));
  }
  if (S_ISDIR(status.st_mode))
  {
    throw std::runtime_error("\"" + path.string() + "\" is a folder, not a file.");
  }
  // The size is a hint: a pipe has none, and a file may grow or shrink while it is read.
  constexpr std::size_t leastRoom = 4096;
  std::string contents;
  contents.resize(std::min(most, static_cast<std::size_t>(status.st_size) + 1));
  std::size_t size = 0;
  while (size < most)
  {
    if (size == contents.size())
    {
      contents.resize(std::min(most, std::max(leastRoom, 2 * size)));
    }
    const ssize_t got = read(file.Get(), contents.data() + size, contents.size() - size);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got < 0)
    {
      Fail("read", path, std::strerror(errno));
    }
    if (got == 0)
    {
      break;
    }
    size += static_cast<std::size_t>(got);
  }
  contents.resize(size);
  return contents;
}

void WriteFileSafely(const std::filesystem::path& path,
  const std::function<void(const std::filesystem::path& temporary)>& write)
{
  static std::atomic<unsigned> counter{ 0 };
  std::error_code error;
  if (path.has_parent_path())
  {
    std::filesystem::create_directories(path.parent_path(), error);
    if (error)
    {
      throw std::runtime_error(
        "Cannot make the folder \"" + path.parent_path().string() + "\": " + error.message() + ".");
    }
  }
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid()) + "-" + std::to_string(counter++);
  std::error_code ignored;
  try
  {
    write(temporary);
    Flush(temporary, path);
  }
  catch (...)
  {
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::filesystem::remove(temporary, ignored);
    Fail("write", path, error.message());
  }
}

void WriteTextFile(const std::filesystem::path& path, std::string_view contents)
{
  WriteFileSafely(path,
    [&](const std::filesystem::path& temporary)
    {
      errno = 0;
      std::ofstream stream(temporary, std::ios::binary);
      stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
      stream.close();
      if (!stream)
      {
        Fail("write", path, std::strerror(errno));
      }
    });
}

} // namespace pemesh

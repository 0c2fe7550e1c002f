// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TextFile.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

namespace pemesh
{

std::string ReadTextFile(const std::filesystem::path& path)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("\"" + path.string() + "\" is a folder, not a file.");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error(
      "Cannot read \"" + path.string() + "\": " + std::strerror(errno) + ".");
  }
  std::string contents;
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  if (!unknown)
  {
    contents.resize(size);
    stream.read(contents.data(), static_cast<std::streamsize>(size));
    contents.resize(static_cast<std::size_t>(stream.gcount()));
  }
  else // a pipe, say
  {
    contents.assign(std::istreambuf_iterator<char>(stream), {});
  }
  return contents;
}

void WriteTextFile(const std::filesystem::path& path, std::string_view contents)
{
  static std::atomic<unsigned> counter{ 0 };
  if (path.has_parent_path())
  {
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error)
    {
      throw std::runtime_error("Cannot make the folder \"" + path.parent_path().string() +
        "\": " + error.message() + ".");
    }
  }
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid()) + "-" + std::to_string(counter++);
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    stream.close();
    if (!stream)
    {
      const std::string reason = std::strerror(errno);
      std::error_code ignored;
      std::filesystem::remove(temporary, ignored);
      throw std::runtime_error("Cannot write \"" + path.string() + "\": " + reason + ".");
    }
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::runtime_error("Cannot write \"" + path.string() + "\": " + error.message() + ".");
  }
}

} // namespace pemesh

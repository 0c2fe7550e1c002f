// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "OutputLog.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

/** Whether the bytes are characters of UTF-8, as far as their lengths go. */
bool IsUtf8(std::string_view text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int following = lead < 0x80 ? 0
      : lead < 0xC2                   ? -1
      : lead < 0xE0                   ? 1
      : lead < 0xF0                   ? 2
                                      : 3;
    if (following < 0 || lead > 0xF4)
    {
      return false;
    }
    for (int k = 0; k < following; ++k)
    {
      if (++i >= text.size() || (text[i] & 0xC0) != 0x80)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

OutputLog::OutputLog(const std::filesystem::path& path, std::size_t limit)
  : Room(limit)
{
  if (path.empty())
  {
    return;
  }
  // A solver of an earlier run may have left anything there: a link is not to be written through,
  // and a pipe that nobody reads would be waited for.
  unlink(path.c_str());
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  this->File.Reset(open(path.c_str(), flags, 0666));
  if (!this->File.IsOpen())
  {
    throw std::runtime_error(
      "Cannot write \"" + path.string() + "\": " + std::strerror(errno) + ".");
  }
}

void OutputLog::Drain()
{
  constexpr int mostReads = 256;
  constexpr std::size_t mostBytes = 65536;
  for (int i = 0; i < mostReads; ++i)
  {
    const std::string bytes = this->Pipe.Read(mostBytes);
    if (bytes.empty())
    {
      return;
    }
    this->Keep(bytes);
  }
}

std::string OutputLog::LastLine() const
{
  constexpr std::string_view blanks = " \t\r\n";
  std::string_view text = this->Tail;
  text = text.substr(0, text.find_last_not_of(blanks) + 1);
  text = text.substr(text.find_last_of("\r\n") + 1); // npos + 1 is 0
  text = text.substr(std::min(text.size(), text.find_first_not_of(blanks)));
  std::string line;
  constexpr std::size_t longest = 300;
  for (const char c : text.substr(0, longest))
  {
    line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  while (!line.empty() && text.size() > longest && (line.back() & 0xC0) == 0x80)
  {
    line.pop_back(); // half a character of UTF-8
  }
  if (!line.empty() && text.size() > longest && (line.back() & 0xC0) == 0xC0)
  {
    line.pop_back();
  }
  if (!IsUtf8(line))
  {
    std::replace_if(
      line.begin(), line.end(), [](char c) { return (c & 0x80) != 0; }, '?');
  }
  return line;
}

void OutputLog::Keep(std::string_view bytes)
{
  constexpr std::size_t tailSize = 4096;
  this->Tail.append(bytes.substr(bytes.size() - std::min(bytes.size(), tailSize)));
  this->Tail.erase(0, this->Tail.size() - std::min(this->Tail.size(), tailSize));
  if (!this->File.IsOpen())
  {
    return;
  }
  this->Write(bytes.substr(0, this->Room));
  if (bytes.size() > this->Room)
  {
    this->Write("\n[The output goes on; only its beginning is kept.]\n");
    this->File.Reset();
    return;
  }
  this->Room -= bytes.size();
}

void OutputLog::Write(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(this->File.Get(), bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
    {
      return; // a full disk must not end the run: the log is a courtesy
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
  }
}

} // namespace pemesh

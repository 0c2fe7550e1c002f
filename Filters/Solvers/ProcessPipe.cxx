// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProcessPipe.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace pemesh
{

ProcessPipe::ProcessPipe()
{
  int ends[2] = { -1, -1 };
  const bool isMade = pipe2(ends, O_CLOEXEC) == 0;
  const FileDescriptor read(ends[0]);
  const FileDescriptor write(ends[1]);
  // Above the numbers that they get in the child, where one must not overwrite another.
  constexpr int firstNumber = 10;
  this->ReadEnd.Reset(fcntl(read.Get(), F_DUPFD_CLOEXEC, firstNumber));
  this->WriteEnd.Reset(fcntl(write.Get(), F_DUPFD_CLOEXEC, firstNumber));
  if (!isMade || !this->ReadEnd.IsOpen() || !this->WriteEnd.IsOpen() ||
    fcntl(this->ReadEnd.Get(), F_SETFL, O_NONBLOCK) != 0)
  {
    throw std::runtime_error("Cannot make a pipe: " + std::string(std::strerror(errno)) + ".");
  }
}

std::string ProcessPipe::Read(std::size_t most)
{
  std::string bytes(this->ReadEnd.IsOpen() ? most : 0, '\0');
  ssize_t got = -1;
  while (this->ReadEnd.IsOpen() &&
    (got = read(this->ReadEnd.Get(), bytes.data(), bytes.size())) < 0 && errno == EINTR)
  {
  }
  if (got == 0)
  {
    this->ReadEnd.Reset();
  }
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

} // namespace pemesh

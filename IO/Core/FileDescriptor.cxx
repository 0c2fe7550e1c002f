// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FileDescriptor.h"

#include <cerrno>

#include <unistd.h>

namespace pemesh
{

void FileDescriptor::Reset(int number)
{
  if (this->Number >= 0)
  {
    const int error = errno; // what a message is about to tell
    close(this->Number);
    errno = error;
  }
  this->Number = number;
}

} // namespace pemesh

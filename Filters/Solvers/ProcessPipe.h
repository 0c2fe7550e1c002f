// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A pipe to a child process; private to ChildProcess.
 */
#ifndef pemesh_ProcessPipe_h
#define pemesh_ProcessPipe_h

#include "FileDescriptor.h"

#include <string>

namespace pemesh
{

/** Its ends are inherited by no child but the one that they are given to. */
class ProcessPipe
{
public:
  /** Throws std::runtime_error. */
  ProcessPipe();

  /** What there is to read, at most `most` bytes; empty for now or, with ReadEnd closed, for ever.
   */
  std::string Read(std::size_t most);

  FileDescriptor ReadEnd;
  FileDescriptor WriteEnd;
};

} // namespace pemesh

#endif

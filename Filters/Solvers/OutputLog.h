// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One output of a child process: the first bytes go into a file, the last ones into memory;
 * private to ChildProcess.
 */
#ifndef pemesh_OutputLog_h
#define pemesh_OutputLog_h

#include "ProcessPipe.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace pemesh
{

class OutputLog
{
public:
  /** An empty path keeps no file. Throws std::runtime_error. */
  OutputLog(const std::filesystem::path& path, std::size_t limit);

  ProcessPipe& GetPipe() { return this->Pipe; }

  /** Reads what there is; bounded, because a child may write without end. */
  void Drain();

  /** The last line that is not blank, without control characters, shortened. */
  std::string LastLine() const;

private:
  void Keep(std::string_view bytes);
  void Write(std::string_view bytes);

  FileDescriptor File;
  ProcessPipe Pipe;
  std::size_t Room;
  std::string Tail;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * An open file of the system, closed on every way out.
 */
#ifndef pemesh_FileDescriptor_h
#define pemesh_FileDescriptor_h

#include "pemeshIOCoreModule.h" // For export macro

namespace pemesh
{

class PEMESHIOCORE_EXPORT FileDescriptor
{
public:
  /** Negative: none is open. */
  explicit FileDescriptor(int number = -1)
    : Number(number)
  {
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { this->Reset(); }

  /** Closes the file and takes another one. Leaves errno as it is. */
  void Reset(int number = -1);
  int Get() const { return this->Number; }
  bool IsOpen() const { return this->Number >= 0; }

private:
  int Number;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A parallel loop over vtkSMPTools for code in C++20: the header of vtkSMPTools in VTK 9.1 is not
 * valid C++20 (constructors named by a template-id), so that ParallelLoop.cxx is compiled as
 * C++17 and nothing else includes it.
 */
#ifndef pemesh_ParallelLoop_h
#define pemesh_ParallelLoop_h

#include "pemeshFiltersCoreModule.h" // For export macro

#include <atomic>
#include <functional>

#include <vtkType.h> // For vtkIdType

namespace pemesh
{

/**
 * Calls `body(first, last)` for parts of the range, in any order and from several threads. `grain`
 * is the length of a part; 0 leaves it to VTK. `body` must not throw.
 */
PEMESHFILTERSCORE_EXPORT void ParallelLoop(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body);

/**
 * While it lives, loops of this thread stay in it as long as there are no idle cores: where so many
 * threads are `busy` with work of their own as there are `cores`, or more. Without it loops use all
 * cores, and as many threads again would be at work.
 */
class PEMESHFILTERSCORE_EXPORT LoopShare
{
public:
  LoopShare(const std::atomic<int>& busy, int cores);
  ~LoopShare();
  LoopShare(const LoopShare&) = delete;
  LoopShare& operator=(const LoopShare&) = delete;

  bool HasIdleCores() const { return this->Busy < this->Cores; }

private:
  const std::atomic<int>& Busy;
  int Cores;
  LoopShare* Outer;
};

/** The most threads a ParallelLoop may use from now on; 0 for one a processor. */
PEMESHFILTERSCORE_EXPORT void SetNumberOfThreads(int threads);

} // namespace pemesh

#endif

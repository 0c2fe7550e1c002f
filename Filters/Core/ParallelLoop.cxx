// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParallelLoop.h"

#include <algorithm>

#include <vtkSMPTools.h>

namespace pemesh
{

namespace
{

thread_local LoopShare* Share = nullptr; // of this thread

/** In parts, between which a body may look whether it shall stop. */
void LoopHere(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body)
{
  constexpr vtkIdType parts = 200;
  const vtkIdType length = grain > 0 ? grain : std::max<vtkIdType>(1, (last - first) / parts);
  for (vtkIdType begin = first; begin < last; begin += length)
  {
    body(begin, std::min(last, begin + length));
  }
}

} // namespace

LoopShare::LoopShare(const std::atomic<int>& busy, int cores)
  : Busy(busy)
  , Cores(cores)
  , Outer(Share)
{
  Share = this;
}

LoopShare::~LoopShare()
{
  Share = this->Outer;
}

void ParallelLoop(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body)
{
  if (Share && !Share->HasIdleCores())
  {
    LoopHere(first, last, grain, body);
    return;
  }
  vtkSMPTools::For(first, last, grain, body);
}

void SetNumberOfThreads(int threads)
{
  vtkSMPTools::Initialize(threads);
}

} // namespace pemesh

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParallelLoop.h"

#include <vtkSMPTools.h>

namespace pemesh
{

void ParallelLoop(vtkIdType first, vtkIdType last, vtkIdType grain,
  const std::function<void(vtkIdType, vtkIdType)>& body)
{
  vtkSMPTools::For(first, last, grain, body);
}

void SetNumberOfThreads(int threads)
{
  vtkSMPTools::Initialize(threads);
}

} // namespace pemesh

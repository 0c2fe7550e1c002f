// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParallelFor.h"

#include <vtkSMPTools.h>

namespace pemesh
{

void ParallelFor(
  vtkIdType begin, vtkIdType end, const std::function<void(vtkIdType, vtkIdType)>& work)
{
  vtkSMPTools::For(begin, end, work);
}

} // namespace pemesh

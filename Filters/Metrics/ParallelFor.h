// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * vtkSMPTools::For for C++20: the header of VTK 9.1 is not valid C++20 (its constructors are
 * named with template arguments), so only ParallelFor.cxx sees it, compiled as C++17.
 */
#ifndef pemesh_ParallelFor_h
#define pemesh_ParallelFor_h

#include <functional>

#include <vtkType.h> // For vtkIdType

namespace pemesh
{

/** Calls `work` on pieces of [begin, end) from the threads of VTK, and waits for all. */
void ParallelFor(
  vtkIdType begin, vtkIdType end, const std::function<void(vtkIdType, vtkIdType)>& work);

} // namespace pemesh

#endif

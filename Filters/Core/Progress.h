// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Progress and cancelling, the same for every version of VTK.
 */
#ifndef pemesh_Progress_h
#define pemesh_Progress_h

#include <vtkAlgorithm.h>
#include <vtkVersionMacros.h>

namespace pemesh
{

/** Reports the fraction done and answers whether to go on: false once an abort was asked for. */
inline bool ReportProgress(vtkAlgorithm* filter, double fraction)
{
  filter->UpdateProgress(fraction);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220900)
  return !filter->CheckAbort();
#else
  return !filter->GetAbortExecute();
#endif
}

} // namespace pemesh

#endif

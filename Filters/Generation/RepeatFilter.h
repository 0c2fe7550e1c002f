// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the filters that repeat meshes share: from the mesh of the input to that of the output.
 */
#ifndef pemesh_RepeatFilter_h
#define pemesh_RepeatFilter_h

#include "MeshRepetition.h"

#include <functional>

#include <vtkType.h> // For vtkIdType

class vtkPolyData;

namespace pemesh
{

struct RepeatRequest
{
  const char* FailureStatus; ///< "not-mirrorable"
  int Times;                 ///< how often the mesh is repeated
  double CopiesEachTime;
  vtkIdType MaximumNumberOfElements;
  std::function<MeshRepetition(const MeshBox&)> Repetition;
  std::function<bool(double)> Progress; ///< whether to go on
};

/** Fills the output: the mesh, provenance, field data, or a failed status. */
void RepeatPolyData(vtkPolyData* input, const RepeatRequest& request, vtkPolyData* output);

} // namespace pemesh

#endif

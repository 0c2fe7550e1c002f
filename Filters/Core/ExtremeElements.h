// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Which elements are extreme: one answer for tables, filters, pictures and windows.
 *
 * Of equal values the first element counts; values that are not finite are undefined and left out.
 */
#ifndef pemesh_ExtremeElements_h
#define pemesh_ExtremeElements_h

#include "pemeshFiltersCoreModule.h" // For export macro
#include <vtkType.h>

class vtkDataArray;

namespace pemesh
{

struct ExtremeElements
{
  vtkIdType Smallest = -1; ///< -1 if no value is finite
  vtkIdType Largest = -1;
};

/** By the first component of an array; null has no extremes. */
PEMESHFILTERSCORE_EXPORT ExtremeElements FindExtremeElements(vtkDataArray* values);

} // namespace pemesh

#endif

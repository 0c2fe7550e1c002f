// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Values of arrays that several threads read at the same time.
 *
 * VTK keeps a temporary tuple in every array (GetTuple1) and its range in the information of the
 * array (GetRange, GetFiniteRange): both write while they read.
 */
#ifndef pemesh_ArrayValues_h
#define pemesh_ArrayValues_h

#include <vtkType.h>

class vtkDataArray;

namespace pemesh
{

/** The first component of a tuple. */
double ValueOf(vtkDataArray* values, vtkIdType tuple);

/**
 * Widens a range by the finite values of an array (null: none). Answers whether there is a value in
 * the range, which begins as { INFINITY, -INFINITY }.
 */
bool ExtendRange(vtkDataArray* values, double range[2]);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The vertices on the boundary of a mesh.
 */
#ifndef pemesh_BoundaryVertices_h
#define pemesh_BoundaryVertices_h

#include <vector>

class vtkPolyData;

namespace pemesh
{

/** For each vertex 1 if it is an end of an edge that only one element has, else 0. */
std::vector<char> MarkBoundaryVertices(vtkPolyData* mesh);

} // namespace pemesh

#endif

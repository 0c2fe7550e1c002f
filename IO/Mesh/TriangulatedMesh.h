// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh of polygons as triangles, for programs that draw or integrate concave polygons wrongly.
 */
#ifndef pemesh_TriangulatedMesh_h
#define pemesh_TriangulatedMesh_h

#include "pemeshIOMeshModule.h" // For export macro

#include <vtkSmartPointer.h> // For return type

class vtkPolyData;

namespace pemesh
{

/** The cell array that names the element of a triangle (vtkIdTypeArray). */
inline constexpr const char* OriginalElementArray = "OriginalElement";

/**
 * The elements in their order, those with more than three vertices as the triangles that fill them
 * (TriangulatePolygon.h: exact, so that areas add up), counter-clockwise, on the same points;
 * an element without area has none. Arrays of points, elements and mesh are carried along.
 */
PEMESHIOMESH_EXPORT vtkSmartPointer<vtkPolyData> TriangulateMesh(vtkPolyData* mesh);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Elements for formats that hold no large polygons.
 */
#ifndef pemesh_CutElements_h
#define pemesh_CutElements_h

#include <functional>
#include <span>

#include <vtkType.h> // For vtkIdType

class vtkPolyData;

namespace pemesh
{

/** Hands over the vertices of each element in order, with its number, those of elements with more
 * than `mostCorners` vertices as triangles, which fill the element, concave or not. */
void ForEachCutElement(vtkPolyData* mesh, int mostCorners,
  const std::function<void(vtkIdType, std::span<const vtkIdType>)>& use);

} // namespace pemesh

#endif

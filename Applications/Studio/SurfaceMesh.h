// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A field on a mesh as a surface above the plane, in blocks of a size that is quick to draw.
 */
#ifndef pemesh_SurfaceMesh_h
#define pemesh_SurfaceMesh_h

#include "MeshPicture.h"

#include <atomic>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

namespace pemesh
{

struct SurfaceMesh
{
  std::vector<vtkSmartPointer<vtkPolyData>> Blocks; ///< triangles; height and scalar are the value
  double Range[2] = { 0.0, 0.0 };
};

/**
 * Of a point array; every element is cut into triangles of its own, concave ones rightly. No blocks
 * where there is no such array.
 */
SurfaceMesh MakeSurface(
  const MeshPicture& picture, const std::string& array, const std::atomic<bool>& stop);

} // namespace pemesh

#endif

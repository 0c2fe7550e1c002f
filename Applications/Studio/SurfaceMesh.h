// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Fields on a mesh as surfaces above the plane.
 */
#ifndef pemesh_SurfaceMesh_h
#define pemesh_SurfaceMesh_h

#include "MeshPicture.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

namespace pemesh
{

/** The vertices in the plane and the triangles of all elements, concave ones rightly. */
struct SurfaceShape
{
  std::vector<Point2> Points;
  std::vector<std::array<std::uint32_t, 3>> Triangles;
};

/** The values of a point array; none where there is no such array. */
struct SurfaceField
{
  std::vector<double> Values;
  double Range[2] = { 0.0, 0.0 };
};

SurfaceShape MakeSurfaceShape(const MeshPicture& picture, const std::atomic<bool>& stop);
SurfaceField MakeSurfaceField(const MeshPicture& picture, const std::string& array);

/** For VTK; height and scalar are the value, and what has none is at height 0. */
vtkSmartPointer<vtkPolyData> MakeSurfaceData(const SurfaceShape& shape, const SurfaceField& field);

/** Solution and ground truth of one mesh. */
struct SurfacePair
{
  SurfaceShape Shape;
  SurfaceField Fields[2];
  vtkSmartPointer<vtkPolyData> Data[2]; ///< where there are few enough triangles for VTK
};

/** Of the arrays <run>_Solution and <run>_GroundTruth. */
SurfacePair MakeSurfacePair(const MeshPicture& picture, const std::string& run,
  std::size_t mostForVtk, const std::atomic<bool>& stop);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes to be agglomerated.
 */
#ifndef pemesh_SampleMeshes_h
#define pemesh_SampleMeshes_h

#include "PolygonMesh.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace pemesh
{

struct SampleMesh
{
  std::string Name;
  PolygonMesh Mesh;
  std::vector<bool> Placed; ///< an element each
};

/** `columns` x `rows` squares, each cut into two triangles, vertices jittered. */
PolygonMesh TriangleGrid(int columns, int rows, std::uint64_t seed);

/** A wall of bricks with jittered corners: hexagons, and straight vertices along the border. */
PolygonMesh BrickWall(int columns, int rows, std::uint64_t seed);

/** A square of triangles with a square hole. */
PolygonMesh TriangleFrame(int size, std::uint64_t seed);

/** Around polygons placed at random, the same for the same seed. */
SampleMesh MeshOfRandomLayout(std::uint64_t seed);

/** All kinds of them. */
std::vector<SampleMesh> SampleMeshes();

} // namespace pemesh

#endif

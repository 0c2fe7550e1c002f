// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The mesh of the unit square around polygons, each of which is one element.
 */
#ifndef pemesh_DomainMesh_h
#define pemesh_DomainMesh_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace pemesh
{

struct DomainMeshOptions
{
  double MinimumAngle = 20.0;                                   ///< degrees
  double MaximumArea = std::numeric_limits<double>::infinity(); ///< of a triangle
  bool PreservePolygons = false;
  int MaximumElements = 20000000;
  std::function<bool(double)> Progress; ///< takes the fraction done; false means stop
};

enum class DomainMeshStatus
{
  Done,
  Failed, ///< DomainMesh::Message says why
  Stopped ///< Progress said so
};

struct DomainMesh
{
  DomainMeshStatus Status = DomainMeshStatus::Failed;
  std::string Message;
  std::vector<Point2> Points; ///< vertices of the polygons, corners of the square, added points
  /**
   * The polygons given, counter-clockwise, each from its first vertex on (its last edges may have
   * been split, so its own vertices are not always the first ones).
   */
  std::vector<std::vector<int>> Polygons;
  std::vector<std::array<int, 3>> Triangles; ///< counter-clockwise
  double AttainedMinimumAngle = 0.0;         ///< degrees, of the triangles
};

/**
 * Meshes the unit square around counter-clockwise polygons in which FindLayoutFault finds no
 * fault. Every edge of the mesh has an element on each side or lies on the border of the square;
 * all elements are simple and counter-clockwise, exactly. Throws std::runtime_error if polygons
 * meet after all.
 */
PEMESHFILTERSGENERATION_EXPORT DomainMesh MeshDomain(
  const std::vector<std::vector<Point2>>& polygons, const DomainMeshOptions& options);

} // namespace pemesh

#endif

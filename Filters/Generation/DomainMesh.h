// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The mesh of a domain around polygons, each of which is one element.
 */
#ifndef pemesh_DomainMesh_h
#define pemesh_DomainMesh_h

#include "Domain.h"
#include "PolygonMesh.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

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
  double Gradation = 0.0;        ///< growth of edges with the distance from polygons; 0: off
  double SizeAtPolygons = 0.0;   ///< wanted edge length there; 0: that of the polygon's own edge
  bool PreservePolygons = false; ///< split none of their edges
  bool PreserveDomain = false;   ///< nor of the domain's own loops
  int MaximumElements = 20000000;
  std::function<bool(double)> Progress; ///< takes the fraction done; false means stop
};

enum class DomainMeshStatus
{
  Done,
  Failed,           ///< DomainMesh::Message says why
  TooManyElements,  ///< more than MaximumElements: the same
  TargetNotReached, ///< MeshDomainToCount: the same
  Stopped           ///< Progress said so
};

struct DomainMesh
{
  DomainMeshStatus Status = DomainMeshStatus::Failed;
  std::string Message;
  /**
   * First the polygons given, counter-clockwise, each from its first vertex on (its last edges may
   * have been split, so its own vertices are not always the first ones), then triangles. Points:
   * vertices of the polygons, of the domain's holes and outer loop, added points.
   */
  PolygonMesh Elements;
  double AttainedMinimumAngle = 0.0; ///< degrees, of the triangles
  double MaximumArea = 0.0;          ///< the bound it was made with
};

/** More elements than this have more sides than an index can count. */
inline constexpr int MostElements = 700000000;

/**
 * Meshes a domain around counter-clockwise polygons in which FindLayoutFault finds no fault. Every
 * edge of the mesh has an element on each side or lies on the boundary of the domain; all elements
 * are simple and counter-clockwise, exactly. Throws std::runtime_error if loops meet after all.
 */
PEMESHFILTERSGENERATION_EXPORT DomainMesh MeshDomain(const Domain& domain,
  const std::vector<std::vector<Point2>>& polygons, const DomainMeshOptions& options);

/** How near the number of elements must come to a target: relative. */
inline constexpr double CountTolerance = 0.02;

/**
 * The same with the maximum area that gives the target number of elements (polygons and triangles,
 * at least 1) to within CountTolerance; that of the options is not used. See CountSearch.h.
 */
PEMESHFILTERSGENERATION_EXPORT DomainMesh MeshDomainToCount(const Domain& domain,
  const std::vector<std::vector<Point2>>& polygons, const DomainMeshOptions& options, int target);

} // namespace pemesh

#endif

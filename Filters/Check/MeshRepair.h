// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The repairs of a mesh that are safe: they change neither the region that an element covers nor
 * any coordinate.
 */
#ifndef pemesh_MeshRepair_h
#define pemesh_MeshRepair_h

#include "MeshChecks.h"

namespace pemesh
{

struct MeshRepair
{
  PolygonMesh Mesh;
  std::vector<int> Points;          ///< of each point left, its number before
  std::vector<MeshFinding> Repairs; ///< the first of each check: what was done, in sentences
  std::vector<std::int64_t> Counts; ///< all of each check: as many as MeshChecks()
};

/**
 * Merges vertices with equal coordinates, drops vertices repeated in a row unless fewer than three
 * would be left, turns clockwise simple elements round (their first vertices stay first) and
 * removes points that no element uses; each only if the options choose its check. Elements keep
 * their numbers. Elements with vertices that cannot be used stay as they are.
 */
PEMESHFILTERSCHECK_EXPORT MeshRepair RepairMesh(
  const PolygonMesh& mesh, const CheckOptions& options);

} // namespace pemesh

#endif

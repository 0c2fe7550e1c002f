// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Whether placed polygons can be meshed around: the check that comes before any meshing.
 */
#ifndef pemesh_LayoutValidity_h
#define pemesh_LayoutValidity_h

#include "Domain.h"
#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

struct PlacedPolygon
{
  std::string Name;
  std::vector<Point2> Vertices;
};

/**
 * Empty if every polygon is simple and lies in the interior of the domain and no two meet, else one
 * sentence on the first fault, naming the polygons, the hole if one is in the way, and `t` (NaN: no
 * t is named). The answer is exact (see PolygonValidity.h). Cost: n log n in the number of polygons
 * and pairs whose bounding boxes meet, and the outer loop once for each polygon unless it is a
 * rectangle.
 */
PEMESHFILTERSGENERATION_EXPORT std::string FindLayoutFault(
  const std::vector<PlacedPolygon>& polygons, const Domain& domain, double t);

} // namespace pemesh

#endif

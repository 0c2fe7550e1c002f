// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Many polygons at random places, none of which meet, whatever their deformation.
 *
 * A placed polygon of scale s has at every deformation and rotation a diameter of at most the
 * diagonal of its bounding box before turning, which is s / 2 (PolygonPlacement.h). Its bounding
 * box after turning, whose centre stays, therefore never leaves the square of side s / 2 about it.
 * These squares are kept apart: no deformation needs to be tried. Places are drawn one after the
 * other, the largest polygon first (random sequential addition, which covers up to about 56 % of
 * the plane with squares of one size).
 */
#ifndef pemesh_PolygonScatter_h
#define pemesh_PolygonScatter_h

#include "Domain.h"
#include "PolygonFamilies.h"
#include "PolygonPlacement.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

struct ScatterOptions
{
  int Count = 10;                    ///< at least 1
  std::uint64_t Seed = 0;            ///< another seed, other places
  std::vector<std::string> Families; ///< none: all that are not fixed
  bool DrawsFamilies = false;        ///< at random; else one after the other
  double SmallestScale = 0.2;        ///< more than 0
  double LargestScale = 0.2;         ///< not below the smallest; scales are drawn in between
  double LargestRotation = 360.0;    ///< degrees; rotations are drawn from 0 to here
  double Gap = 0.01;                 ///< least distance to each other and to the border, from 0
};

struct ScatteredPolygon
{
  const PolygonFamily* Family;
  PolygonPlace Place;
  double Rotation;    ///< degrees
  std::uint64_t Seed; ///< for families that take one: each polygon has its own, below 2^31
};

/**
 * Empty if all polygons found their place, else one sentence that says what is wrong or how many
 * fit, after 10000 tries for one that did not. `occupied` are the places of polygons that are
 * there already. The result is in the order of drawing.
 */
PEMESHFILTERSGENERATION_EXPORT std::string ScatterPolygons(const ScatterOptions& options,
  const Domain& domain, std::span<const PolygonPlace> occupied,
  std::vector<ScatteredPolygon>& scattered);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The parametric families of polygons, one table.
 *
 * A family deforms a harmless polygon (t = 0) into a bad one (t = 1). The families are those of
 * M. Attene, S. Biasotti, S. Bertoluzza, D. Cabiddu, M. Livesu, G. Patane, M. Pennacchio,
 * D. Prada, M. Spagnuolo: Benchmarking the geometrical robustness of a Virtual Element Poisson
 * solver, Mathematics and Computers in Simulation 190 (2021) 1392-1414,
 * doi:10.1016/j.matcom.2021.07.018. Every polygon is simple and counter-clockwise.
 *
 * Adding a family is adding one entry to the table in PolygonFamilies.cxx.
 */
#ifndef pemesh_PolygonFamilies_h
#define pemesh_PolygonFamilies_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <span>
#include <string_view>
#include <vector>

namespace pemesh
{

struct PolygonFamily
{
  const char* Name;        ///< "comb": the word of studies, tables and the command line
  const char* Label;       ///< "Comb": what a person reads
  const char* Description; ///< one sentence
  const char* CountName;   ///< "teeth", "sides", "spikes", or null if there is no count
  int DefaultCount;        ///< 0 if there is no count
  int MinimumCount;        ///< 0 if there is no count
  bool Stepped;            ///< the number of vertices grows with t, in steps
  const char* Reference;

  /**
   * The vertices at t in [0, 1]; `count` is ignored by families without one. t is clamped to
   * [0, 1], and to 1 - 1e-5 (Convexity, Isotropy: the area would be 0) or 1e-5 (U-like: the notch
   * would be a straight line) where the family ends in a degenerate polygon. Coordinates are the
   * family's own: vtkPEMPolygonLayout scales and places them.
   */
  std::vector<Point2> (*Vertices)(double t, int count);
};

/** Largest count that any family takes. */
inline constexpr int MaximumPolygonCount = 100000;

/** All families, in alphabetical order; the array `ElementFamily` holds positions in this table. */
PEMESHFILTERSGENERATION_EXPORT std::span<const PolygonFamily> PolygonFamilies();

/** The family of that name (upper and lower case are the same), or null. */
PEMESHFILTERSGENERATION_EXPORT const PolygonFamily* FindPolygonFamily(std::string_view name);

/** The position of a family in the table. */
PEMESHFILTERSGENERATION_EXPORT int PolygonFamilyIndex(const PolygonFamily* family);

} // namespace pemesh

#endif

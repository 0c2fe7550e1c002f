// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The families of polygons, one table.
 *
 * A family deforms a harmless polygon (t = 0) into a bad one (t = 1). The parametric families are
 * those of
 * M. Attene, S. Biasotti, S. Bertoluzza, D. Cabiddu, M. Livesu, G. Patane, M. Pennacchio,
 * D. Prada, M. Spagnuolo: Benchmarking the geometrical robustness of a Virtual Element Poisson
 * solver, Mathematics and Computers in Simulation 190 (2021) 1392-1414,
 * doi:10.1016/j.matcom.2021.07.018; random polygons are ours (RandomPolygon.h). All these are
 * simple and counter-clockwise. Polygons from files and polygons given by their points are families
 * of fixed polygons, which do not depend on t.
 *
 * Adding a family is adding one entry to the table in PolygonFamilies.cxx.
 */
#ifndef pemesh_PolygonFamilies_h
#define pemesh_PolygonFamilies_h

#include "Parameter.h"
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
  std::span<const Parameter> Parameters;
  bool Stepped; ///< the number of vertices grows with t, in steps
  const char* Reference;

  /**
   * The vertices at t in [0, 1], for values of the family's Parameters. t is clamped to
   * [0, 1], and to 1 - 1e-5 (Convexity, Isotropy: the area would be 0) or 1e-5 (U-like: the notch
   * would be a straight line) where the family ends in a degenerate polygon. Coordinates are the
   * family's own: vtkPEMPolygonLayout scales and places them. Null for fixed polygons, each of
   * which has its own vertices.
   */
  std::vector<Point2> (*Vertices)(double t, const ParameterValues& values);

  bool IsFixed() const { return !this->Vertices; }
};

///@{
/** The families of fixed polygons. */
inline constexpr const char* FileFamilyName = "file";
inline constexpr const char* PointsFamilyName = "points";
///@}

/** All families; the array `ElementFamily` holds positions in this table, which never change. */
PEMESHFILTERSGENERATION_EXPORT std::span<const PolygonFamily> PolygonFamilies();

/** The family of that name (upper and lower case are the same), or null. */
PEMESHFILTERSGENERATION_EXPORT const PolygonFamily* FindPolygonFamily(std::string_view name);

/** The position of a family in the table. */
PEMESHFILTERSGENERATION_EXPORT int PolygonFamilyIndex(const PolygonFamily* family);

} // namespace pemesh

#endif

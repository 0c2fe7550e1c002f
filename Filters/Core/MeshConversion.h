// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Between a mesh of the pipeline (vtkPolyData) and a mesh of the kernels (PolygonMesh).
 */
#ifndef pemesh_MeshConversion_h
#define pemesh_MeshConversion_h

#include "Domain.h"
#include "PolygonMesh.h"
#include "pemeshFiltersCoreModule.h" // For export macro

#include <string>
#include <vector>

class vtkPolyData;

namespace pemesh
{

///@{
/** Cell arrays of every generated mesh: of a placed polygon its family and its place in the layout,
 * -1 for other elements. */
inline constexpr const char* ElementFamilyArray = "ElementFamily";
inline constexpr const char* PolygonIdArray = "PolygonId";
///@}

/**
 * The points and polygons of a mesh in which ElementAccess::WhyUnusable finds no fault; z is left
 * out. Throws std::length_error if there are more than 2^31 - 1 points or sides.
 */
PEMESHFILTERSCORE_EXPORT PolygonMesh ToPolygonMesh(vtkPolyData* mesh);

/** Gives `output` the points, in double precision with z = 0, and the polygons of the mesh. */
PEMESHFILTERSCORE_EXPORT void SetPolygonMesh(vtkPolyData* output, const PolygonMesh& mesh);

/**
 * Adds the cell arrays ElementFamily and PolygonId. `sources` says of each element which cell of
 * `input` its values come from; -1, and an array that is not there, give -1.
 */
PEMESHFILTERSCORE_EXPORT void CopyProvenance(
  vtkPolyData* input, const std::vector<int>& sources, vtkPolyData* output);

/**
 * The domain whose loops are the polygons of `input`, in any order and orientation; null, or no
 * polygons, for the unit square. Empty if they make one, else one sentence (see MakeDomain).
 */
PEMESHFILTERSCORE_EXPORT std::string ToDomain(vtkPolyData* input, Domain& domain);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes with a number of elements, vertices or unknowns that the study holds fixed.
 */
#ifndef pemesh_StudyTargetSearch_h
#define pemesh_StudyTargetSearch_h

#include <functional>
#include <string>

class vtkPolyData;

namespace pemesh
{

struct StudyTarget;

/** Share of the target by which the number may miss it. */
inline constexpr double TargetTolerance = 0.02;

/**
 * What the target counts: elements, vertices, or the degrees of freedom of a virtual element
 * method of the target's order k in the interior of the domain, one a vertex, k - 1 an edge and
 * k (k - 1) / 2 an element (L. Beirao da Veiga et al., Basic principles of virtual element methods,
 * Math. Models Methods Appl. Sci. 23 (2013) 199-214, doi:10.1142/S0218202512500492).
 */
double CountOfTarget(vtkPolyData* mesh, const StudyTarget& target);

/**
 * Tries bounds on the area of triangles until the mesh that `makeMesh` makes with one has what the
 * target asks for; the last mesh made is then the one. `area` is that of the domain. `makeMesh`
 * answers with null where there is no mesh: the search ends. It ends as well where a finer mesh,
 * once its elements are merged, has no more of what is counted. Empty if the target is reached or
 * there was no mesh, else one sentence.
 */
std::string SearchTarget(
  const StudyTarget& target, double area, const std::function<vtkPolyData*(double)>& makeMesh);

} // namespace pemesh

#endif

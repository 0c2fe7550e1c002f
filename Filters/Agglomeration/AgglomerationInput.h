// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Which meshes can be agglomerated by combinatorics alone.
 */
#ifndef pemesh_AgglomerationInput_h
#define pemesh_AgglomerationInput_h

#include "PolygonMesh.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <string>

namespace pemesh
{

/**
 * Empty if the mesh is a conforming one of simple, counter-clockwise elements, else one sentence
 * that names the culprit. Exact.
 *
 * Checked are: every element simple and counter-clockwise; every side shared by at most two
 * elements, which run along it in opposite directions; the border a set of simple loops that do
 * not meet (so no hanging node that a neighbour does not know, no overlap along the border); and
 * no vertex about which the elements wind more than once. The last is seen from the sum over all
 * vertices: by the theorem of Gauss and Bonnet the loops of the border that run counter-clockwise,
 * less those that run clockwise, are V - E + F, and each further turn about a vertex adds one.
 * Each connected piece of such a mesh lies in the plane without overlap.
 * Cost: linear but for the loops of the border, O(n log n).
 */
PEMESHFILTERSAGGLOMERATION_EXPORT std::string WhyNotAgglomerable(
  const PolygonMesh& mesh, const MeshAdjacency& adjacency);

} // namespace pemesh

#endif

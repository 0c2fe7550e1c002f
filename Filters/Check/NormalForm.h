// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh as it would be after the repairs that are safe: what the checks of whole meshes look at.
 */
#ifndef pemesh_NormalForm_h
#define pemesh_NormalForm_h

#include "MeshChecks.h"

namespace pemesh
{

enum class ElementCondition : unsigned char
{
  Sound,     ///< simple and counter-clockwise
  Clockwise, ///< simple; turned round in the normal form
  Flat,      ///< fewer than three places, or all vertices on one line
  Crossing,  ///< not simple
  Unusable   ///< vertices out of range or not finite; it has no vertices in the normal form
};

inline bool IsSimple(ElementCondition condition)
{
  return condition == ElementCondition::Sound || condition == ElementCondition::Clockwise;
}

struct NormalForm
{
  /** The same points and elements; vertices replaced by the smallest equal one, none repeated in a
   * row, counter-clockwise where that has a meaning. */
  PolygonMesh Mesh;
  std::vector<ElementCondition> Conditions; ///< of each element
  std::vector<unsigned char> IsConvex;      ///< of each element; of simple ones only
  std::vector<int> Original;                ///< the smallest point equal to each used one, or -1
  std::vector<unsigned char> IsFinite;      ///< of each point
  std::vector<int> Stranded;                ///< usable vertices of unusable elements
  double Diagonal = 0.0;                    ///< of the bounding box of the points used
};

/** Geometry is decided exactly and in parallel. */
NormalForm MakeNormalForm(const PolygonMesh& mesh);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The degrees of freedom that elements share: first the vertices of the mesh, then k - 1 points an
 * edge. Those inside elements are eliminated element by element and have no number. Private to the
 * module.
 */
#ifndef pemesh_DegreesOfFreedom_h
#define pemesh_DegreesOfFreedom_h

#include "VirtualElementMethodMesh.h"

#include <span>
#include <vector>

namespace pemesh
{

class EllipticProblem;

struct DegreesOfFreedom
{
  int Order = 1;
  std::vector<Point2> Points;
  std::vector<vtkIdType> Offsets; ///< element e has Ids[Offsets[e]] … in ElementMatrices' order
  std::vector<vtkIdType> Ids;
  std::vector<char> Used;  ///< belongs to an element
  std::vector<char> Known; ///< on the part of the boundary where the solution is given

  vtkIdType Size() const { return static_cast<vtkIdType>(this->Points.size()); }
  std::span<const vtkIdType> OfElement(vtkIdType element) const
  {
    return { this->Ids.data() + this->Offsets[element],
      static_cast<std::size_t>(this->Offsets[element + 1] - this->Offsets[element]) };
  }
};

DegreesOfFreedom NumberDegreesOfFreedom(
  const VirtualElementMesh& mesh, const EllipticProblem& problem, int order);

} // namespace pemesh

#endif

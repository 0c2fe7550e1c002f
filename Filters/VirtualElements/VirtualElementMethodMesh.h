// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The mesh as the virtual element method wants it: flat arrays, the boundary known, every element
 * checked. The boundary is found from the topology (edges with one element), in linear time.
 */
#ifndef pemesh_VirtualElementMethodMesh_h
#define pemesh_VirtualElementMethodMesh_h

#include "Point2.h"
#include "pemeshFiltersVirtualElementsModule.h" // For export macro

#include <span>
#include <vector>

#include <vtkType.h> // For vtkIdType

class vtkPolyData;

namespace pemesh
{

struct VirtualElementMesh
{
  std::vector<Point2> Points;
  std::vector<vtkIdType> Offsets; ///< element e has the corners Offsets[e] … Offsets[e + 1] - 1
  std::vector<vtkIdType> Corners; ///< point ids, counter-clockwise
  std::vector<char> OnBoundary;   ///< of each point: end of an edge of one element
  std::vector<char> Used;         ///< of each point: belongs to an element

  ///@{
  /** The edge from each corner to the next one of its element, and whether no other element has it.
   */
  std::vector<vtkIdType> EdgeOf;
  std::vector<char> EdgeOnBoundary;
  ///@}

  ///@{
  /** The elements around each point, in ascending order, and the point's place in each. */
  std::vector<vtkIdType> FirstUse;
  std::vector<vtkIdType> UseElement;
  std::vector<vtkIdType> UsePlace;
  ///@}

  vtkIdType NumberOfElements() const { return static_cast<vtkIdType>(this->Offsets.size()) - 1; }
  vtkIdType NumberOfEdges() const { return static_cast<vtkIdType>(this->EdgeOnBoundary.size()); }
  vtkIdType NumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }
  std::span<const vtkIdType> Element(vtkIdType element) const
  {
    return { this->Corners.data() + this->Offsets[element],
      static_cast<std::size_t>(this->Offsets[element + 1] - this->Offsets[element]) };
  }
  void GetVertices(vtkIdType element, std::vector<Point2>& vertices) const;
};

/**
 * Throws std::runtime_error, one sentence with the culprit, where the mesh cannot carry a
 * problem: no elements, coordinates that are not finite, a clockwise or flat element, a vertex
 * repeated in an element, an edge of more than two elements or used twice in one direction
 * (elements overlap), a vertex on an edge of the boundary that it is no end of (a T-junction, whose
 * two sides would both count as boundary and get the exact solution).
 */
PEMESHFILTERSVIRTUALELEMENTS_EXPORT VirtualElementMesh MakeVirtualElementMesh(vtkPolyData* mesh);

} // namespace pemesh

#endif

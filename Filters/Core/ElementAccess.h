// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Reads the elements of a mesh (a vtkPolyData of polygons) as sequences of points.
 *
 * Safe to use from several threads at once, each with an ElementAccess of its own. Cell ids of the
 * mesh and element numbers are the same, because a mesh of PEMesh has polygons only.
 */
#ifndef pemesh_ElementAccess_h
#define pemesh_ElementAccess_h

#include "Point2.h"
#include "pemeshFiltersCoreModule.h" // For export macro

#include <string>
#include <vector>

#include <vtkType.h> // For vtkIdType

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

namespace pemesh
{

class PEMESHFILTERSCORE_EXPORT ElementAccess
{
public:
  explicit ElementAccess(vtkPolyData* mesh);

  /** Empty if the mesh can be used, else one sentence: lines or strips, no points, bad indices. */
  static std::string WhyUnusable(vtkPolyData* mesh);

  vtkIdType GetNumberOfElements() const;

  /** Without repeats of a point in a row, as metrics count. */
  vtkIdType CountVertices(vtkIdType element);

  /** Puts the vertices of an element into `vertices`, in the order stored. */
  void GetVertices(vtkIdType element, std::vector<Point2>& vertices);

  /** Puts the point ids of an element into `ids`, in the order stored. */
  void GetVertexIds(vtkIdType element, std::vector<vtkIdType>& ids);

private:
  vtkCellArray* Polygons;
  vtkPoints* Points;
  const double* Coordinates; // null unless the points are plain doubles
  std::vector<vtkIdType> Ids;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMTriangulate
 * @brief   A mesh of polygons as triangles, for what draws concave polygons wrongly.
 *
 * VTK's mappers, and with them ParaView, fill the notches of concave polygons; vtkTriangleFilter
 * loses elements that are nearly degenerate.
 *
 * Input port 0 : vtkPolyData, a mesh of simple polygons.
 * Output port 0: vtkPolyData, triangles that fill its elements exactly, in their order, on the same
 *   points; all arrays of the input, those of elements repeated for each triangle, and the cell
 *   array "OriginalElement" (vtkIdTypeArray), the element that a triangle is of. An element without
 *   area has no triangle.
 * A mesh that has failed already is passed on as it is; one with cells other than polygons fails
 *   with the status "unusable-mesh".
 * Time: passed through. The same bits on every run. Cost: linear but for elements with many reflex
 *   vertices.
 */
#ifndef vtkPEMTriangulate_h
#define vtkPEMTriangulate_h

#include "pemeshIOMeshModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class PEMESHIOMESH_EXPORT vtkPEMTriangulate : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMTriangulate* New();
  vtkTypeMacro(vtkPEMTriangulate, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPEMTriangulate() = default;
  ~vtkPEMTriangulate() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPEMTriangulate(const vtkPEMTriangulate&) = delete;
  void operator=(const vtkPEMTriangulate&) = delete;
};

#endif

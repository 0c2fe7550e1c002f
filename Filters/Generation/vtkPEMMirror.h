// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMirror
 * @brief   Makes a larger mesh of a mesh and its mirror images, in the same place.
 *
 * Input port 0 : vtkPolyData, a mesh of simple counter-clockwise polygons.
 * Output port 0: vtkPolyData: the mesh, reflected in x, in y and in both about the east and the
 * north side of its bounding box, the seams welded, and all of it scaled by 1/2 towards the lower
 * left corner of the box, which it fills again; NumberOfTimes times over, each time with four times
 * the elements. Elements stay counter-clockwise and simple, the four copies of an element follow
 * one another. Cell arrays
 *   "ElementFamily", "PolygonId" (vtkIntArray) as of the input: all copies of a polygon have its
 * id; other arrays of cells and points, such as metrics, would be out of date and are left out. The
 * field data is that of the input. With NumberOfTimes 0 the input is passed on as it is.
 *
 * Vertices are welded where their coordinates on the seam are equal, by no tolerance
 * (MeshRepetition.h); in the unit square the copies are exact but for digits beyond 2^-53.
 *
 * Failure of a case (see CaseStatus.h): "not-mirrorable" if the border has no segment on the east
 * or the north side of the bounding box, if an element is so thin that rounding would spoil its
 * copies, or if there would be more than MaximumNumberOfElements. A failed input is passed on.
 * Time: pass-through. The same bits on every run. Cost: linear in the result.
 *
 * @sa vtkPEMTile vtkPEMDomainMesher
 */
#ifndef vtkPEMMirror_h
#define vtkPEMMirror_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class PEMESHFILTERSGENERATION_EXPORT vtkPEMMirror : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMMirror* New();
  vtkTypeMacro(vtkPEMMirror, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How often. Valid range [0, 14]. Default 1. */
  vtkSetClampMacro(NumberOfTimes, int, 0, 14);
  vtkGetMacro(NumberOfTimes, int);
  ///@}

  ///@{
  /** A larger result is refused. Valid range [10, 1000000000]. Default 20000000. */
  vtkSetClampMacro(MaximumNumberOfElements, vtkIdType, 10, 1000000000);
  vtkGetMacro(MaximumNumberOfElements, vtkIdType);
  ///@}

protected:
  vtkPEMMirror() = default;
  ~vtkPEMMirror() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  int NumberOfTimes = 1;
  vtkIdType MaximumNumberOfElements = 20000000;

  vtkPEMMirror(const vtkPEMMirror&) = delete;
  void operator=(const vtkPEMMirror&) = delete;
};

#endif

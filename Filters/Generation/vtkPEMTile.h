// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMTile
 * @brief   Makes a larger mesh of translated copies of a mesh, in the same place.
 *
 * Input port 0 : vtkPolyData, a mesh of simple counter-clockwise polygons.
 * Output port 0: vtkPolyData: NumberOfColumns times NumberOfRows copies of the mesh side by side,
 * the seams welded, and all of it scaled by one over the larger of the two numbers towards the
 * lower left corner of the bounding box: it fills the box where both are equal, and else a part of
 * it. Where the vertices on both sides of a seam differ, the elements gain those of the other side
 * as straight vertices, exactly on the seam. Elements stay counter-clockwise and simple, the copies
 * of an element follow one another, row by row. Cell arrays "ElementFamily", "PolygonId"
 * (vtkIntArray) as of the input: all copies of a polygon have its id; other arrays of cells and
 * points, such as metrics, would be out of date and are left out. The field data is that of the
 * input. A single copy is the input as it is.
 *
 * Failure of a case (see CaseStatus.h): "not-tileable" if copies side by side would have no segment
 * in common, if an element is so thin that rounding would spoil its copies, or if there would be
 * more than MaximumNumberOfElements. A failed input is passed on. Time: pass-through. The same bits
 * on every run. Cost: linear in the result.
 *
 * @sa vtkPEMMirror vtkPEMDomainMesher
 */
#ifndef vtkPEMTile_h
#define vtkPEMTile_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class PEMESHFILTERSGENERATION_EXPORT vtkPEMTile : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMTile* New();
  vtkTypeMacro(vtkPEMTile, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Copies side by side. Valid range [1, 10000]. Default 2. */
  vtkSetClampMacro(NumberOfColumns, int, 1, 10000);
  vtkGetMacro(NumberOfColumns, int);
  ///@}

  ///@{
  /** Copies above each other. Valid range [1, 10000]. Default 2. */
  vtkSetClampMacro(NumberOfRows, int, 1, 10000);
  vtkGetMacro(NumberOfRows, int);
  ///@}

  ///@{
  /** A larger result is refused. Valid range [10, 1000000000]. Default 20000000. */
  vtkSetClampMacro(MaximumNumberOfElements, vtkIdType, 10, 1000000000);
  vtkGetMacro(MaximumNumberOfElements, vtkIdType);
  ///@}

protected:
  vtkPEMTile() = default;
  ~vtkPEMTile() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  int NumberOfColumns = 2;
  int NumberOfRows = 2;
  vtkIdType MaximumNumberOfElements = 20000000;

  vtkPEMTile(const vtkPEMTile&) = delete;
  void operator=(const vtkPEMTile&) = delete;
};

#endif

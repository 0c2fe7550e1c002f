// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMTessellation
 * @brief   Makes the polygonal meshes of the literature that need no placed polygons.
 *
 * Input port 0 : optional vtkPolyData, the domain: its polygons are the loops of the boundary, in
 * any order and orientation; the one that holds all others is the outer one, the others are holes.
 * No input, or no polygons: the unit square.
 * Output port 0: vtkPolyData, a conforming mesh of the domain of counter-clockwise, simple polygons
 * with shared vertices in double precision; cell arrays
 *   "ElementFamily" and "PolygonId" (vtkIntArray): -1, for there are no placed polygons;
 * the field data of the input, the field text
 *   "Tessellation" the kind, and a field number of the name of each of its parameters.
 *
 * The kinds, their parameters with defaults and ranges, and papers that use such meshes are the
 * table of Tessellations.h; `pemesh::Tessellations()`. Each covers every domain: vertices of the
 * domain are vertices of the mesh, other vertices on its boundary are exactly on axis-parallel
 * edges and up to rounding on others; a cell that the boundary cuts apart becomes several elements.
 *
 * Failures of one case (see CaseStatus.h): "invalid-domain" if the polygons of the input are no
 * domain; "too-many-elements"; "tessellation-failed" if the points find no place in the domain or
 * an element would not be simple in double precision. The message says which and the way out.
 * Time: pass-through. Threads: the same bits for any number. Cost: about linear in the number of
 * elements, times the iterations of a centroidal Voronoi mesh.
 *
 * @sa vtkPEMDomainMesher
 */
#ifndef vtkPEMTessellation_h
#define vtkPEMTessellation_h

#include "pemeshFiltersTessellationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names
#include <vector> // For lists

class PEMESHFILTERSTESSELLATION_EXPORT vtkPEMTessellation : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMTessellation* New();
  vtkTypeMacro(vtkPEMTessellation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The kind of mesh: "voronoi", "hexagons", ... Any other name is an error. Default "voronoi". */
  void SetKindByName(const std::string& name);
  std::string GetKindName() const;
  std::vector<std::string> GetKindNames() const;
  ///@}

  ///@{
  /**
   * The parameters of the kind; a name that it has not, or a value out of its range, is an error.
   * Each kind keeps its own values, so that choosing another one and back changes nothing.
   * GetParameter is NaN (and an error) if there is no such parameter.
   */
  void SetParameter(const std::string& name, double value);
  double GetParameter(const std::string& name);
  std::vector<std::string> GetParameterNames() const;
  ///@}

  ///@{
  /**
   * A case that needs more elements, or sixteen times as many sides, fails instead of filling the
   * memory (about 1000 bytes an element while it is made). Valid range [1, 1000000000]. Default
   * 20000000.
   */
  vtkSetClampMacro(MaximumNumberOfElements, vtkIdType, 1, 1000000000);
  vtkGetMacro(MaximumNumberOfElements, vtkIdType);
  ///@}

protected:
  vtkPEMTessellation();
  ~vtkPEMTessellation() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  struct ParametersOfKinds;

  int Kind = 0; ///< position in the table
  ParametersOfKinds* Parameters;
  vtkIdType MaximumNumberOfElements = 20000000;

  vtkPEMTessellation(const vtkPEMTessellation&) = delete;
  void operator=(const vtkPEMTessellation&) = delete;
};

#endif

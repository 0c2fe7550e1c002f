// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMDomain
 * @brief   The region that a mesh covers, as the closed loops of its boundary.
 *
 * A source without input.
 *
 * Output port 0: vtkPolyData, one polygon a loop, all counter-clockwise, points in double precision
 * and not shared: the outer loop first, then the holes, in the order of the file.
 *
 * The shapes are those of pemesh::DomainShapes() ("rectangle", "regular-polygon", "l-shape",
 * "disc"), with their parameters, and "file": a polygon with holes from a mesh file or a table of
 * points (see PolygonFile.h), in any order and orientation of its loops. Shapes of the table have
 * the lower left corner of their bounding box at (0, 0); loops of a file stay where they are.
 *
 * Failure of the case (see CaseStatus.h): "invalid-domain" if the file cannot be read or its loops
 * do not bound one piece: they cross, touch, or lie side by side.
 *
 * @sa vtkPEMDomainMesher
 */
#ifndef vtkPEMDomain_h
#define vtkPEMDomain_h

#include "Parameter.h"                     // For values of parameters
#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names

namespace pemesh
{
struct Domain;
}

class PEMESHFILTERSGENERATION_EXPORT vtkPEMDomain : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMDomain* New();
  vtkTypeMacro(vtkPEMDomain, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A name of the table of shapes, or "file"; any other is an error. A change of the shape sets
   * its parameters to their defaults. Default "rectangle", which is the unit square.
   */
  void SetShapeByName(const std::string& name);
  std::string GetShapeName() const;
  ///@}

  ///@{
  /**
   * The value of a parameter of the shape, in the range that the table gives: an error otherwise,
   * or if the shape has no such parameter (NaN).
   */
  void SetParameter(const std::string& name, double value);
  double GetParameter(const std::string& name) const;
  ///@}

  ///@{
  /** The file of the shape "file". Default empty. */
  void SetFileName(const std::string& path);
  std::string GetFileName() const { return this->FileName; }
  ///@}

protected:
  vtkPEMDomain();
  ~vtkPEMDomain() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /** Empty if there is a domain, else one sentence. */
  std::string FindDomain(pemesh::Domain& domain) const;

  std::string ShapeName;
  pemesh::ParameterValues Values;
  std::string FileName;

  vtkPEMDomain(const vtkPEMDomain&) = delete;
  void operator=(const vtkPEMDomain&) = delete;
};

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMPolygonFamily
 * @brief   One polygon of a family, as a function of time: a layout of one.
 *
 * A source without required input, output and time as of vtkPEMPolygonLayout. Where a layout is
 * edited by the indices of its polygons, this class has its polygon's properties for its own, as
 * programs want that set properties by name.
 *
 * @sa vtkPEMPolygonLayout
 */
#ifndef vtkPEMPolygonFamily_h
#define vtkPEMPolygonFamily_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPEMPolygonLayout.h"

#include <string> // For names

class PEMESHFILTERSGENERATION_EXPORT vtkPEMPolygonFamily : public vtkPEMPolygonLayout
{
public:
  static vtkPEMPolygonFamily* New();
  vtkTypeMacro(vtkPEMPolygonFamily, vtkPEMPolygonLayout);

  ///@{
  /**
   * A parametric family of pemesh::PolygonFamilies(); any other name is an error and changes
   * nothing. Another family has its own parameters, at first the defaults. Default "comb".
   */
  void SetFamily(const std::string& name);
  std::string GetFamily() const { return this->GetPolygonFamily(0); }
  ///@}

  ///@{
  /** Where the centre of the bounding box lies. Any finite values. Default (0.5, 0.5). */
  void SetCenter(double x, double y) { this->SetPolygonCenter(0, x, y); }
  double GetCenterX() const { return this->GetPolygonCenterX(0); }
  double GetCenterY() const { return this->GetPolygonCenterY(0); }
  ///@}

  ///@{
  /** Twice the diagonal of the bounding box before turning. Valid range (0, inf). Default 1. */
  void SetScale(double scale) { this->SetPolygonScale(0, scale); }
  double GetScale() const { return this->GetPolygonScale(0); }
  ///@}

  ///@{
  /** Counter-clockwise turn in degrees. Any finite value. Default 0. */
  void SetRotation(double degrees) { this->SetPolygonRotation(0, degrees); }
  double GetRotation() const { return this->GetPolygonRotation(0); }
  ///@}

  ///@{
  /** The deformations at time 0 and at time 1. Valid range [0, 1] each. Default 0 and 1. */
  void SetRange(double from, double to) { this->SetPolygonRange(0, from, to); }
  double GetFrom() const { return this->GetPolygonFrom(0); }
  double GetTo() const { return this->GetPolygonTo(0); }
  ///@}

  ///@{
  /** A number that the family is tuned by, as of vtkPEMPolygonLayout::SetPolygonParameter. */
  void SetParameter(const std::string& name, double value)
  {
    this->SetPolygonParameter(0, name, value);
  }
  double GetParameter(const std::string& name) const { return this->GetPolygonParameter(0, name); }
  ///@}

protected:
  vtkPEMPolygonFamily();
  ~vtkPEMPolygonFamily() override = default;

private:
  vtkPEMPolygonFamily(const vtkPEMPolygonFamily&) = delete;
  void operator=(const vtkPEMPolygonFamily&) = delete;
};

#endif

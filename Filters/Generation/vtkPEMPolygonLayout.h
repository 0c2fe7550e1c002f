// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMPolygonLayout
 * @brief   Places polygons of the parametric families in the unit square, as a function of time.
 *
 * A source without input. Time is the deformation t in [0, 1]: 0 is harmless, 1 is worst.
 *
 * Output port 0: vtkPolyData, one counter-clockwise polygon a cell, in the order they were added,
 * points in double precision and not shared between polygons, with the cell arrays
 *   "ElementFamily" (vtkIntArray) position of the family in pemesh::PolygonFamilies() |
 *   "PolygonId" (vtkIntArray) 0, 1, ... | "PolygonName" (vtkStringArray),
 * and the field number "t", listed in the field list "Parameters".
 *
 * Placement, the same at every t: the polygon is scaled so that the diagonal of its bounding box
 * is 0.5 times its scale, then turned about the average of its vertices, then moved so that the
 * centre of its bounding box (after turning) is at its centre. The layout is not judged here:
 * vtkPEMDomainMesher refuses polygons that overlap, touch or leave the domain, and FindFaults()
 * says so beforehand.
 *
 * Time: TIME_STEPS are NumberOfTimes equidistant values from FirstTime to LastTime (one only if no
 * polygon changes with time), TIME_RANGE their ends. Any time in [0, 1] may be asked for;
 * without UPDATE_TIME_STEP it is FirstTime. The time s of the pipeline gives each polygon the
 * deformation from + s (to - from) of its own range.
 * Wrong configuration (an error, no output): a centre, scale, rotation or range that is not a
 * finite number in its valid range; FirstTime beyond LastTime.
 *
 * @sa vtkPEMDomainMesher
 */
#ifndef vtkPEMPolygonLayout_h
#define vtkPEMPolygonLayout_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names
#include <vector> // For lists

class PEMESHFILTERSGENERATION_EXPORT vtkPEMPolygonLayout : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMPolygonLayout* New();
  vtkTypeMacro(vtkPEMPolygonLayout, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a polygon of a family ("comb", "convexity", "isotropy", "maze", "n-sided", "star",
   * "u-like", "zeta") and returns its index, or -1 (and an error) if there is no such family.
   * Its defaults: scale 1, rotation 0, the family's own count, the range 0 to 1, and the name
   * "polygon 1 (comb)", counted from 1.
   */
  int AddPolygon(const std::string& family, double centerX, double centerY);
  void RemoveAllPolygons();
  int GetNumberOfPolygons() const;

  ///@{
  /** Where the centre of the polygon's bounding box lies. Any finite values. */
  void SetPolygonCenter(int index, double centerX, double centerY);
  double GetPolygonCenterX(int index) const;
  double GetPolygonCenterY(int index) const;
  ///@}

  ///@{
  /** Twice the diagonal of the bounding box before turning. Valid range (0, 10]. Default 1. */
  void SetPolygonScale(int index, double scale);
  double GetPolygonScale(int index) const;
  ///@}

  ///@{
  /** Counter-clockwise turn in degrees. Any finite value. Default 0. */
  void SetPolygonRotation(int index, double degrees);
  double GetPolygonRotation(int index) const;
  ///@}

  ///@{
  /**
   * Number of teeth (comb), sides (n-sided) or spikes (star) at t = 1. Valid range: from the
   * family's minimum (1 tooth, 3 sides, 3 spikes) to 100000. An error for families without a
   * count. Default: the family's own (10, 40, 40; 0 where there is none).
   */
  void SetPolygonCount(int index, int count);
  int GetPolygonCount(int index) const;
  ///@}

  ///@{
  /**
   * The deformations at time 0 and at time 1. Valid range [0, 1] each, in either order; equal:
   * the polygon does not change. Default 0 and 1.
   */
  void SetPolygonRange(int index, double from, double to);
  double GetPolygonFrom(int index) const;
  double GetPolygonTo(int index) const;
  ///@}

  ///@{
  /** What messages call the polygon. Default "polygon 1 (comb)", counted from 1. */
  void SetPolygonName(int index, const std::string& name);
  std::string GetPolygonName(int index) const;
  ///@}

  /** The family of a polygon ("comb"), empty if there is no such polygon. */
  std::string GetPolygonFamily(int index) const;

  ///@{
  /** The first time step. Valid range [0, 1]. Default 0. */
  vtkSetClampMacro(FirstTime, double, 0.0, 1.0);
  vtkGetMacro(FirstTime, double);
  ///@}

  ///@{
  /** The last time step, not before the first. Valid range [0, 1]. Default 0.9. */
  vtkSetClampMacro(LastTime, double, 0.0, 1.0);
  vtkGetMacro(LastTime, double);
  ///@}

  ///@{
  /** Number of time steps; 1 means FirstTime alone. Valid range [1, 1000000]. Default 20. */
  vtkSetClampMacro(NumberOfTimes, int, 1, 1000000);
  vtkGetMacro(NumberOfTimes, int);
  ///@}

  /** The time steps, ascending and without repetition. */
  std::vector<double> GetTimes() const;

  /** Empty if the layout of that time can be meshed, else one sentence that names the fault. */
  std::string FindFault(double time) const;

  /** The faults of all time steps, one sentence each; empty if there is none. */
  std::vector<std::string> FindFaults() const;

protected:
  vtkPEMPolygonLayout();
  ~vtkPEMPolygonLayout() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  struct Placement;

  /** The polygon of that index, or null and an error. */
  Placement* FindPlacement(int index);
  const Placement* PeekPlacement(int index) const;
  /** Empty if everything is in its valid range. */
  std::string WhyMisconfigured() const;

  std::vector<Placement> Placements;
  double FirstTime = 0.0;
  double LastTime = 0.9;
  int NumberOfTimes = 20;

  vtkPEMPolygonLayout(const vtkPEMPolygonLayout&) = delete;
  void operator=(const vtkPEMPolygonLayout&) = delete;
};

#endif

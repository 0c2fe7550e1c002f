// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMPolygonLayout
 * @brief   Places polygons of the families in a domain, as a function of time.
 *
 * Time is the deformation t in [0, 1]: 0 is harmless, 1 is worst. Fixed polygons, from a file or
 * given by their points, do not depend on it.
 *
 * Input port 0 (optional): vtkPolyData, the domain: its outer loop and its holes as polygons in any
 * order and orientation; without it, the unit square. The output does not depend on it; it is what
 * FindFault judges by, and where polygons are scattered.
 * Output port 0: vtkPolyData, one counter-clockwise polygon a cell, in the order they were added,
 * points in double precision and not shared between polygons, with the cell arrays
 *   "ElementFamily" (vtkIntArray) position of the family in pemesh::PolygonFamilies() |
 *   "PolygonId" (vtkIntArray) 0, 1, ... | "PolygonName" (vtkStringArray),
 * and the field number "t", listed in the field list "Parameters".
 *
 * Placement, the same at every t: the polygon is scaled so that the diagonal of its bounding box
 * is 0.5 times its scale, then turned about the average of its vertices, then moved so that the
 * centre of its bounding box (after turning) is at its centre. Points whose centre, scale and
 * rotation are those they were given with come out bit by bit. The layout is not judged here:
 * vtkPEMDomainMesher refuses polygons that overlap, touch or leave the domain, and FindFaults()
 * says so beforehand.
 *
 * Time: TIME_STEPS are NumberOfTimes equidistant values from FirstTime to LastTime (one only if no
 * polygon changes with time), TIME_RANGE their ends. Any time in [0, 1] may be asked for;
 * without UPDATE_TIME_STEP it is FirstTime. The time s of the pipeline gives each polygon the
 * deformation from + s (to - from) of its own range.
 * Wrong configuration (an error, no output): a centre, scale, rotation or range that is not a
 * finite number in its valid range; FirstTime beyond LastTime. What is set to the value it has is
 * no modification.
 *
 * @sa vtkPEMDomainMesher
 */
#ifndef vtkPEMPolygonLayout_h
#define vtkPEMPolygonLayout_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names
#include <vector> // For lists

namespace pemesh
{
struct Domain;
struct LayoutPolygon;
struct PlacedPolygon;
struct Point2;
struct ScatterOptions;
}

class PEMESHFILTERSGENERATION_EXPORT vtkPEMPolygonLayout : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMPolygonLayout* New();
  vtkTypeMacro(vtkPEMPolygonLayout, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Adds a polygon of a parametric family ("comb", "convexity", "isotropy", "maze", "n-sided",
   * "star", "u-like", "zeta", "random") and returns its index, or -1 (and an error) if there is no
   * such family. Its defaults: scale 1, rotation 0, the family's own parameters, the range 0 to 1,
   * and the name "polygon 1 (comb)", counted from 1.
   */
  int AddPolygon(const std::string& family, double centerX, double centerY);
  int AddPolygon(
    const std::string& family, double centerX, double centerY, double scale, double rotation);
  ///@}

  /**
   * Adds the first polygon of a file (PolygonFile.h: OFF, OBJ, VTP, points as CSV and others),
   * which is read now and placed like those of the families. -1 and an error that names the file
   * and the line if there is none.
   */
  int AddPolygonFromFile(const std::string& file, double centerX, double centerY);

  ///@{
  /**
   * Adds the polygon of these points, x and y by turns, in either orientation; the last may repeat
   * the first. It stays as it stands, bit by bit: its centre and its scale are those that it has,
   * and changing them later moves it. With a centre it is placed like the others, at scale 1.
   * Returns its index, or -1 and an error if the points make no polygon; whether it is simple is
   * left to FindFault.
   */
  int AddPolygonFromPoints(const std::vector<double>& points);
  int AddPolygonFromPoints(const std::vector<double>& points, double centerX, double centerY);
  ///@}

  /**
   * Adds so many polygons at random places in the domain where nothing meets at any time, by random
   * sequential addition (PolygonScatter.h says how): families one after the other (none: all but
   * the fixed ones), scales between two bounds, any rotation, at least `gap` from each other, from
   * the polygons that are there and from the border. The seed is an integer of 0 to 2^53; those of
   * the family "random" get seeds of their own. Returns the index of the first, or -1 and an error
   * if something is wrong or they do not fit; nothing is added then.
   */
  int ScatterPolygons(int count, double seed, const std::vector<std::string>& families,
    double smallestScale, double largestScale, double gap);
#ifndef __VTK_WRAP__
  int ScatterPolygons(const pemesh::ScatterOptions& options);
#endif

  /** Adds a copy as the last polygon; returns its index, or -1 and an error. */
  int DuplicatePolygon(int index);

  ///@{
  /** The indices of the polygons behind change. */
  void RemovePolygon(int index);
  void RemoveAllPolygons();
  ///@}

  /** Takes a polygon out and puts it back in where it then has the index `to`. */
  void MovePolygon(int from, int to);

  int GetNumberOfPolygons() const;

  /** Makes the polygons those of another layout; no modification where they are equal already. */
  void CopyPolygons(vtkPEMPolygonLayout* other);

  ///@{
  /** Where the centre of the polygon's bounding box lies. Any finite values. */
  void SetPolygonCenter(int index, double centerX, double centerY);
  double GetPolygonCenterX(int index) const;
  double GetPolygonCenterY(int index) const;
  ///@}

  ///@{
  /** Twice the diagonal of the bounding box before turning. Valid range (0, inf). Default 1. */
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
   * A number that the family is tuned by: teeth, sides or spikes at t = 1; seed, vertices,
   * irregularity, spikiness and tangle of a random polygon (the table in PolygonFamilies.cxx has
   * defaults and ranges). An error for a name that the family does not know and a value out of
   * range; NaN if there is no such polygon or parameter.
   */
  void SetPolygonParameter(int index, const std::string& name, double value);
  double GetPolygonParameter(int index, const std::string& name) const;
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
  /**
   * What messages call the polygon. Default "polygon 1 (comb)", after its place counted from 1 and
   * its family; an empty name brings that back.
   */
  void SetPolygonName(int index, const std::string& name);
  std::string GetPolygonName(int index) const;
  ///@}

  /** The family of a polygon ("comb"), empty if there is no such polygon. */
  std::string GetPolygonFamily(int index) const;

  /** The file that a polygon was read from, empty if from none. */
  std::string GetPolygonFile(int index) const;

  /** The points of a fixed polygon before it was placed, x and y by turns; none of other polygons.
   */
  std::vector<double> GetPolygonPoints(int index) const;

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

  /** Empty if the layout of that time can be meshed, else one sentence that names the fault. The
   * input is brought up to date. */
  std::string FindFault(double time);

  /** The faults of all time steps, one sentence each; empty if there is none. */
  std::vector<std::string> FindFaults();

protected:
  vtkPEMPolygonLayout();
  ~vtkPEMPolygonLayout() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /** The polygon of that index, or null and an error. */
  pemesh::LayoutPolygon* FindPolygon(int index);
  const pemesh::LayoutPolygon* PeekPolygon(int index) const;
  int Append(pemesh::LayoutPolygon polygon);
  /** Of fixed polygons; -1 and an error that begins with `source` if they are none. */
  int AppendFixed(
    const char* family, const std::string& source, std::vector<pemesh::Point2> points);
  std::vector<pemesh::PlacedPolygon> PolygonsAt(double time) const;
  /** Empty, or one sentence on why the input is no domain. */
  std::string UpdateDomain(pemesh::Domain& domain);
  /** Empty, or one sentence on a wrong setting or domain. */
  std::string WhyNoLayout(pemesh::Domain& domain);
  std::string FindFaultIn(const pemesh::Domain& domain, double time) const;
  /** Empty if everything is in its valid range. */
  std::string WhyMisconfigured() const;

  std::vector<pemesh::LayoutPolygon> Polygons;
  double FirstTime = 0.0;
  double LastTime = 0.9;
  int NumberOfTimes = 20;

  vtkPEMPolygonLayout(const vtkPEMPolygonLayout&) = delete;
  void operator=(const vtkPEMPolygonLayout&) = delete;
};

#endif

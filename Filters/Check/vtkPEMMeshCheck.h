// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMeshCheck
 * @brief   Says what is wrong with a mesh, and where; repairs what is safe.
 *
 * Input port 0 : vtkPolyData of polygons, however broken: orientation, coordinates and vertex
 *   numbers may be anything.
 * Input port 1 : optional; vtkPolyData whose polygons are the loops of the domain that the mesh
 *   should cover, as of vtkPEMDomain. Without it, holes are warnings and the border is taken as it
 *   is.
 * Output port 0: the mesh, repaired if asked for, with the cell array
 *   "Faults" (vtkIntArray) the number of findings that name the element.
 * Output port 1: vtkPolyData, the elements with faults, with the cell arrays
 *   "Element" (vtkIdTypeArray) the cell of output port 0 | "Faults" as above |
 *   "Check" (vtkStringArray) names of the checks, with blanks. Vertices that cannot be used are
 *   left out.
 * Output port 2: vtkTable, one row a finding, the first MaximumNumberOfExamples of each check:
 *   "Check" name | "Severity" "error", "warning" or "repaired" | "Element" the first one at fault,
 *   -1 if it is none | "Vertex" the same | "x", "y" the place | "Message" one sentence.
 *   Rows of what was repaired come first and number the mesh as it was; the others are about
 *   output port 0.
 * The table of checks is in MeshChecks.h, `pemesh list checks` prints it.
 *
 * A mesh that has failed already is passed on as it is; one without polygons or with other cells
 *   fails with the status "unusable-mesh".
 * Wrong configuration: a polygons of input port 1 that make no domain, an option that is NaN.
 * Time: passed through.  Threads: the same for any number.
 * Cost: about linear in the number of sides. Geometry is decided exactly.
 */
#ifndef vtkPEMMeshCheck_h
#define vtkPEMMeshCheck_h

#include "pemeshFiltersCheckModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For arguments
#include <vector> // For arguments

namespace pemesh
{
struct CheckOptions;
struct MeshReport;
}

class PEMESHFILTERSCHECK_EXPORT vtkPEMMeshCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMMeshCheck* New();
  vtkTypeMacro(vtkPEMMeshCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The checks to make, and to repair, by name. Default: all. A name that is unknown is an error
   * that tells the nearest known one, and changes nothing.
   */
  void SetChecks(const std::vector<std::string>& names);
  void SelectAllChecks();
  std::vector<std::string> GetChecks() const;
  ///@}

  /** The names that can be chosen from, in the order of the table. */
  static std::vector<std::string> GetAvailableChecks();

  ///@{
  /**
   * Whether to repair what is safe: clockwise elements are turned round, vertices with equal
   * coordinates merged, vertices repeated in a row dropped, unused points removed. No coordinate
   * changes and no element is removed; arrays are carried along. Default false.
   */
  vtkSetMacro(Repair, bool);
  vtkGetMacro(Repair, bool);
  vtkBooleanMacro(Repair, bool);
  ///@}

  ///@{
  /** An element is a sliver if twice its area is less than this times its diameter squared. Range
   * [0, 1]. Default 1e-6. */
  vtkSetClampMacro(SliverThickness, double, 0.0, 1.0);
  vtkGetMacro(SliverThickness, double);
  ///@}

  ///@{
  /** The distance, relative to the diagonal of the bounding box of the mesh, that counts as
   * rounding: for near-vertices, t-junctions, and the border of the domain. Range [0, 1]. Default
   * 1e-12. */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** How far the area of the mesh may be from that of the domain, relative. Range [0, 1]. Default
   * 1e-9. */
  vtkSetClampMacro(AreaTolerance, double, 0.0, 1.0);
  vtkGetMacro(AreaTolerance, double);
  ///@}

  ///@{
  /** Findings listed for each check; all are counted. At least 0. Default 100. */
  vtkSetClampMacro(MaximumNumberOfExamples, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfExamples, int);
  ///@}

  ///@{
  /** After an update: how many findings the mesh of output port 0 has, listed or not. */
  vtkGetMacro(NumberOfErrors, vtkIdType);
  vtkGetMacro(NumberOfWarnings, vtkIdType);
  vtkIdType GetNumberOfFindings(const std::string& check) const;
  ///@}

  ///@{
  /** After an update: how many repairs were made, by check and in all. */
  vtkGetMacro(NumberOfRepairs, vtkIdType);
  vtkIdType GetNumberOfRepairs(const std::string& check) const;
  ///@}

  ///@{
  /** After an update: pieces of elements joined by sides, and holes in them; -1 if no check needed
   * to know. */
  vtkGetMacro(NumberOfComponents, int);
  vtkGetMacro(NumberOfHoles, int);
  ///@}

protected:
  vtkPEMMeshCheck();
  ~vtkPEMMeshCheck() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPEMMeshCheck(const vtkPEMMeshCheck&) = delete;
  void operator=(const vtkPEMMeshCheck&) = delete;

  /** Empty, or one sentence on what is wrong with the configuration. */
  std::string GetOptions(vtkPolyData* domain, pemesh::CheckOptions& options);
  void ForgetResults();
  void KeepResults(const pemesh::MeshReport& report);

  std::vector<std::string> Checks;
  bool Repair = false;
  double SliverThickness = 1e-6;
  double Tolerance = 1e-12;
  double AreaTolerance = 1e-9;
  int MaximumNumberOfExamples = 100;

  vtkIdType NumberOfErrors = 0;
  vtkIdType NumberOfWarnings = 0;
  vtkIdType NumberOfRepairs = 0;
  int NumberOfComponents = -1;
  int NumberOfHoles = -1;
  std::vector<vtkIdType> FindingCounts;
  std::vector<vtkIdType> RepairCounts;
};

#endif

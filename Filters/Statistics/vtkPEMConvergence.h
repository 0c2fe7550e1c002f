// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMConvergence
 * @brief   Observed orders of convergence of the errors in a table of meshes.
 *
 * Input port 0 : vtkTable, one row a mesh (of vtkPEMSeriesTable, or a results table read back).
 * Output port 0: vtkTable, one row a mesh, from the coarsest to the finest: the size and, for each
 *   error, "<error>" and "<error>_order", p in error = C size^p between a mesh and the one before.
 *   Undefined is NaN.
 * Output port 1: vtkTable, one row an error: "Error" its name, "Order" the slope of the line of
 *   least squares through the logarithms, "StandardError" of the slope.
 *
 * Wrong configuration (an error, and 0 returned): a column that the table does not have.
 * @sa Convergence.h
 */
#ifndef vtkPEMConvergence_h
#define vtkPEMConvergence_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For column names
#include <vector> // For column names

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMConvergence : public vtkTableAlgorithm
{
public:
  static vtkPEMConvergence* New();
  vtkTypeMacro(vtkPEMConvergence, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The column with the size of the mesh. Default "MeshSize". */
  void SetSizeColumn(const std::string& name);
  std::string GetSizeColumn() const;
  ///@}

  ///@{
  /**
   * Whether the column counts something, unknowns or elements: the size is then 1 / sqrt(count).
   * Default off.
   */
  vtkSetMacro(SizeIsCount, bool);
  vtkGetMacro(SizeIsCount, bool);
  vtkBooleanMacro(SizeIsCount, bool);
  ///@}

  ///@{
  /** The columns with errors. Default none named: all numeric ones with "error" in their name. */
  void SetErrorColumns(const std::vector<std::string>& names);
  std::vector<std::string> GetErrorColumns() const;
  ///@}

  ///@{
  /** The table as text: "csv", "markdown" or "latex"; empty before the first update. */
  std::string FormatOutput(const std::string& format);
  static std::vector<std::string> GetAvailableFormats();
  ///@}

protected:
  vtkPEMConvergence();
  ~vtkPEMConvergence() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMConvergence(const vtkPEMConvergence&) = delete;
  void operator=(const vtkPEMConvergence&) = delete;

  std::string SizeColumn = "MeshSize";
  bool SizeIsCount = false;
  std::vector<std::string> ErrorColumns;
  std::vector<std::string> Texts; // in the order of the table of formats
};

#endif

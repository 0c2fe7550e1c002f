// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMReport
 * @brief   One HTML page about the results of a study.
 *
 * The page holds everything: it needs no other file and no network, and opens in any browser. What
 * was run, the first, middle and last mesh, metrics, performances, findings in words with charts,
 * convergence where the mesh size varies, failures, the table, and the words explained. It reads
 * what vtkPEMRunner left in its folder; the same results give the same bytes.
 *
 * @sa vtkPEMRunner vtkPEMFindings
 */
#ifndef vtkPEMReport_h
#define vtkPEMReport_h

#include "pemeshReportModule.h" // For export macro

#include <string> // For paths
#include <vector> // For remarks

#include <vtkObject.h>

class PEMESHREPORT_EXPORT vtkPEMReport : public vtkObject
{
public:
  static vtkPEMReport* New();
  vtkTypeMacro(vtkPEMReport, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The folder of a study's results. */
  void SetFolder(const std::string& folder);
  std::string GetFolder() const;
  ///@}

  ///@{
  /** The page to write. Default empty: report.html in the folder. */
  void SetFileName(const std::string& file);
  std::string GetFileName() const;
  ///@}

  /** Writes the page whole or not at all. False with GetErrorMessage() where it could not be. */
  bool Write();
  std::string GetErrorMessage() const;

  /** After Write(): sentences on what the page does not show, and why. Often none. */
  std::vector<std::string> GetRemarks() const;

protected:
  vtkPEMReport() = default;
  ~vtkPEMReport() override = default;

private:
  vtkPEMReport(const vtkPEMReport&) = delete;
  void operator=(const vtkPEMReport&) = delete;

  std::string Folder;
  std::string FileName;
  std::string ErrorMessage;
  std::vector<std::string> Remarks;
};

#endif

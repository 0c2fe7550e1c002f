// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMStudySource
 * @brief   The meshes of a study document as time steps, made when they are asked for.
 *
 * A source without input.
 * Output port 0: vtkPolyData, the mesh of one case with its metrics, as a run of the study would
 *   have it, but for its solvers: sweeps over their options are left out, and so are the results.
 * Time: TIME_STEPS are t where it alone is swept, else 0, 1, ... for the cases, as in the file
 *   series.pvd of a run; another time takes the nearest step; without a time asked for, the first.
 * Failure of a case: as of the filters of the study, in `Status` and `StatusMessage`.
 * Wrong configuration (an error, and 0 returned): no file name, a document that cannot be read, a
 *   setting that is wrong for every case.
 * The document is read again when its name is set again.
 *
 * @sa vtkPEMRunner
 */
#ifndef vtkPEMStudySource_h
#define vtkPEMStudySource_h

#include "pemeshRunnerModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For the file name

class PEMESHRUNNER_EXPORT vtkPEMStudySource : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMStudySource* New();
  vtkTypeMacro(vtkPEMStudySource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The study document, JSON. Default empty, which is an error. */
  void SetFileName(const std::string& path);
  std::string GetFileName() const { return this->FileName; }
  ///@}

protected:
  vtkPEMStudySource();
  ~vtkPEMStudySource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPEMStudySource(const vtkPEMStudySource&) = delete;
  void operator=(const vtkPEMStudySource&) = delete;

  /** Calls a function that may throw; 0 and an error if it did. */
  template <typename Function>
  int Try(const Function& function);

  class Cases;
  std::unique_ptr<Cases> Contents; ///< null until the document is read
  std::string FileName;
};

#endif

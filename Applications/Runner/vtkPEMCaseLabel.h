// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMCaseLabel
 * @brief   Passes a mesh on with the name and the parameters of its case as field data.
 *
 * Input port 0 and output port 0: vtkPolyData. Field text `Mesh` is the name; every parameter is a
 * field number or text listed in `Parameters`.
 */
#ifndef vtkPEMCaseLabel_h
#define vtkPEMCaseLabel_h

#include "pemeshRunnerModule.h" // For export macro

#include <string>  // For arguments
#include <utility> // For the parameters
#include <variant> // For the parameters
#include <vector>  // For the parameters

#include <vtkPolyDataAlgorithm.h>

class PEMESHRUNNER_EXPORT vtkPEMCaseLabel : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMCaseLabel* New();
  vtkTypeMacro(vtkPEMCaseLabel, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the mesh; empty leaves the name that the input has. Default empty. */
  void SetMeshName(const std::string& name);
  std::string GetMeshName() const { return this->MeshName; }
  ///@}

  ///@{
  /** Sets a parameter, or changes its value, a number or a text. Default none. */
  void SetParameter(const std::string& name, double value);
  void SetTextParameter(const std::string& name, const std::string& value);
  void RemoveAllParameters();
  ///@}

  ///@{
  /** Marks a mesh that has not failed already as failed; an empty status does not. Default empty.
   */
  void SetFailure(const std::string& status, const std::string& message);
  std::string GetFailure() const { return this->FailureMessage; }
  ///@}

protected:
  vtkPEMCaseLabel() = default;
  ~vtkPEMCaseLabel() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPEMCaseLabel(const vtkPEMCaseLabel&) = delete;
  void operator=(const vtkPEMCaseLabel&) = delete;

  using ParameterValue = std::variant<double, std::string>;
  void ChangeParameter(const std::string& name, const ParameterValue& value);

  std::string MeshName;
  std::string FailureStatus;
  std::string FailureMessage;
  std::vector<std::pair<std::string, ParameterValue>> Parameters;
};

#endif

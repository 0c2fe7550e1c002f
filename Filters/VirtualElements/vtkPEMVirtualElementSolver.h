// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMVirtualElementSolver
 * @brief   Solves a PDE on a mesh with the virtual element method, in this process.
 *
 * The same method as the program pemesh-vem, for
 *   -div(kappa grad u) + beta . grad u + c u = f
 * with a test problem of the table or formulas of x and y (see EllipticProblem.h).
 *
 * Input port 0 : vtkPolyData, a mesh of polygons.
 * Output port 0: the same and, with `<run>` the name of the run,
 *   point arrays "<run>_Solution" and, where the solution is known, "<run>_GroundTruth" and
 *     "<run>_Error" (= solution - ground truth);
 *   cell arrays "<run>_ErrorL2" and "<run>_ErrorH1" (absolute, of the projection against the exact
 *     solution), and with Details "<run>_ProjectionCondition";
 *   field number "<run>_<performance>" for each performance, NaN where undefined or the run failed;
 *     the names of those that depend on the machine are in the field list "Measured";
 *   field texts "<run>_Status" ("ok", "no-mesh", "not-solved", "cancelled") and
 *     "<run>_StatusMessage".
 * With an empty run name the prefix "<run>_" is left out, and the two texts are "SolverStatus" and
 * "SolverStatusMessage".
 *
 * Wrong configuration (an error, and 0 returned): a name that is in no table, a formula that cannot
 * be read. Progress is reported between the parts of a run, where AbortExecute ends it.
 */
#ifndef vtkPEMVirtualElementSolver_h
#define vtkPEMVirtualElementSolver_h

#include "pemeshFiltersVirtualElementsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For names and formulas
#include <vector> // For lists of names

class PEMESHFILTERSVIRTUALELEMENTS_EXPORT vtkPEMVirtualElementSolver : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMVirtualElementSolver* New();
  vtkTypeMacro(vtkPEMVirtualElementSolver, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The order of the method, 1 … 6. Default 1. */
  vtkSetClampMacro(Order, int, 1, 6);
  vtkGetMacro(Order, int);
  ///@}

  ///@{
  /**
   * A choice by name: "problem" (default franke), "basis" (orthonormal), "stabilisation"
   * (dofi-dofi), "p0" (boundary), "load" (pi0), "solver" (auto); or a formula: "solution",
   * "diffusion", "diffusion-xy", "diffusion-yy", "advection-x", "advection-y", "reaction",
   * "source", "dirichlet", "neumann", "flux" (all empty). A solution or a source takes the place of
   * the test problem. The same names as the options of pemesh-vem.
   */
  void SetOption(const std::string& name, const std::string& value);
  /** Empty for an option that there is not. */
  std::string GetOption(const std::string& name) const;
  static std::vector<std::string> GetOptionNames();
  static std::vector<std::string> GetProblemNames();
  ///@}

  ///@{
  /** Also what may cost more than solving; see VirtualElementOptions.h. Default off. */
  vtkSetMacro(Details, bool);
  vtkGetMacro(Details, bool);
  vtkBooleanMacro(Details, bool);
  ///@}

  ///@{
  /** Leads the names of all arrays. Default empty. */
  void SetRunName(const std::string& name);
  std::string GetRunName() const;
  ///@}

protected:
  vtkPEMVirtualElementSolver();
  ~vtkPEMVirtualElementSolver() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPEMVirtualElementSolver(const vtkPEMVirtualElementSolver&) = delete;
  void operator=(const vtkPEMVirtualElementSolver&) = delete;

  class Internals;
  std::unique_ptr<Internals> Implementation;
  int Order = 1;
  bool Details = false;
  std::string RunName;
};

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMExternalSolver
 * @brief   Solves a PDE on a mesh by running an external program.
 *
 * Input port 0 : vtkPolyData, a mesh of polygons.
 * Output port 0: the same and, with `<run>` the name of the run,
 *   point arrays "<run>_Solution" and, where the solver knows, "<run>_GroundTruth" and
 *     "<run>_Error" (= solution - ground truth);
 *   cell array "<run>_<array>" for each array of the elements that the solver has written;
 *   field number "<run>_<performance>" for each performance, NaN where the run failed or it is
 * undefined; the names of those that depend on the machine are in the field list "Measured"; field
 * texts "<run>_Status" and "<run>_StatusMessage". With an empty run name the prefix "<run>_" is
 * left out, and the two texts are "SolverStatus" and "SolverStatusMessage", because "Status" is
 * that of the mesh, which a failed run does not change.
 *
 * Status words of a run: ok; not-found (no such program, or it cannot be executed); crashed (ended
 * by a signal); exit-status (not 0); time-out, cpu-limit, memory-limit, disk-limit (stopped);
 * bad-output (a file missing, numbers missing, too many, or not finite), partial where some files
 * are good, which are kept; cancelled; no-mesh (the input has failed before); not-written (the work
 * folder cannot be written).
 *
 * Files: each execution makes the folder `WorkDirectory/<mesh>`, where `<mesh>` is the field text
 * "Mesh" of the input or "mesh", writes the mesh there and runs the command in it. What the solver
 * writes stays, and so do stdout.log, stderr.log, command.txt and, after a good run, solved.txt.
 * The contract with the solver is in SolverDescription.h.
 *
 * Wrong configuration (an error, and 0 returned): no command, an unknown placeholder, option or
 * mesh format, an option value that is not of its type.
 *
 * Progress: reported ten times a second while the program runs; AbortExecute ends it, and all
 * that it has started, within a second. Any number of these filters may run at once, each in a
 * thread of its own; two must not share a folder.
 */
#ifndef vtkPEMExternalSolver_h
#define vtkPEMExternalSolver_h

#include "pemeshFiltersSolversModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For names and options
#include <vector> // For the command

namespace pemesh
{
class MemoryBudget;
class SolverQueue;
struct SolverDescription;
struct SolverOutcome;
}

class PEMESHFILTERSSOLVERS_EXPORT vtkPEMExternalSolver : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMExternalSolver* New();
  vtkTypeMacro(vtkPEMExternalSolver, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  ///@{
  /**
   * All about the solver at once, its time limit included; values given to SetOption stay.
   * The default description is empty.
   */
  void SetDescription(const pemesh::SolverDescription& description);
  const pemesh::SolverDescription& GetDescription() const;
  ///@}

  /**
   * What this and other solvers that run at the same time may take of the memory together; they
   * wait for each other. It must outlive the filter. Default none.
   */
  void SetMemoryBudget(pemesh::MemoryBudget* budget)
  {
    this->Budget = budget;
  }

  /**
   * Where a solver that takes a list of meshes meets those of other filters, each run by a worker
   * of the queue in a thread of its own. It must outlive the filter. Default none: lists of one.
   */
  void SetQueue(pemesh::SolverQueue* queue)
  {
    this->Queue = queue;
  }
#endif

  ///@{
  /** The same piece by piece. See SolverDescription.h for what each means. */
  void SetCommand(const std::vector<std::string>& command);
  std::vector<std::string> GetCommand() const;
  /** A name of pemesh::MeshFormats() that keeps the vertices (not stl). Default "off". */
  void SetMeshFormat(const std::string& format);
  std::string GetMeshFormat() const;
  /** Declares an option; `type` is string, integer or number. */
  void AddOption(const std::string& name, const std::string& type, const std::string& defaultValue);
  void RemoveAllOptions();
  /**
   * Declares a performance; `measured` where it depends on the machine, `mayBeUndefined` where nan
   * is no fault.
   */
  void AddPerformance(const std::string& name, bool measured = false, bool mayBeUndefined = false);
  void RemoveAllPerformances();
  /** Declares an array with one number an element, which the solver may write. */
  void AddElementArray(const std::string& name);
  void RemoveAllElementArrays();
  /** Where a program named by a relative path with a slash begins. Default: current folder. */
  void SetFolder(const std::string& folder);
  std::string GetFolder() const;
  ///@}

  ///@{
  /** The value of an option for this run, as text; else its default. */
  void SetOption(const std::string& name, const std::string& value);
  /** Empty for an option that is not declared. */
  std::string GetOption(const std::string& name) const;
  /** Back to the defaults. */
  void ResetOptions();
  ///@}

  ///@{
  /** Leads the names of all arrays. Default empty. */
  void SetRunName(const std::string& name);
  std::string GetRunName() const;
  ///@}

  ///@{
  /** Default empty: a temporary folder, removed after the run. */
  void SetWorkDirectory(const std::string& folder);
  std::string GetWorkDirectory() const;
  ///@}

  ///@{
  /** In seconds, 0 = none. Default 0. A number that is not finite or negative counts as 0. */
  void SetTimeLimit(double seconds);
  double GetTimeLimit() const;
  ///@}

  ///@{
  /**
   * How many threads the solver may use: {threads} in the command, and the environment variables
   * OMP_NUM_THREADS, OPENBLAS_NUM_THREADS and MKL_NUM_THREADS. At least 1. Default 1.
   */
  vtkSetClampMacro(Threads, int, 1, VTK_INT_MAX);
  vtkGetMacro(Threads, int);
  ///@}

  ///@{
  /**
   * How often a mesh is tried again after a run that was not ok, though it might have been: that
   * crashed, ran out of a limit, or left a bad answer. Default 0.
   */
  vtkSetClampMacro(Retries, int, 0, VTK_INT_MAX);
  vtkGetMacro(Retries, int);
  ///@}

  ///@{
  /**
   * Whether an answer that lies in the folder of the run is taken, and nothing run, where it was
   * given to the same question: same bytes of the mesh file, description, options, program and
   * version. A file solved.txt in the folder says so. Default false.
   */
  vtkSetMacro(ReuseAnswers, bool);
  vtkGetMacro(ReuseAnswers, bool);
  vtkBooleanMacro(ReuseAnswers, bool);
  ///@}

  ///@{
  /** What the solver says of its version: part of the question above. Default empty. */
  void SetVersion(const std::string& version);
  std::string GetVersion() const;
  ///@}

  ///@{
  /** The names of the two texts: "<run>_Status", "<run>_StatusMessage". */
  std::string GetStatusName() const;
  std::string GetStatusMessageName() const;
  ///@}

protected:
  vtkPEMExternalSolver();
  ~vtkPEMExternalSolver() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPEMExternalSolver(const vtkPEMExternalSolver&) = delete;
  void operator=(const vtkPEMExternalSolver&) = delete;

  void StoreOutcome(const pemesh::SolverOutcome& outcome, vtkPolyData* output);

  class Internals;
  std::unique_ptr<Internals> Implementation;
  std::string RunName;
  std::string WorkDirectory;
  std::string Version;
  int Threads = 1;
  int Retries = 0;
  pemesh::MemoryBudget* Budget = nullptr;
  pemesh::SolverQueue* Queue = nullptr;
  bool ReuseAnswers = false;
};

#endif

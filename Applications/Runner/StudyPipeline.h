// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One worker's pipeline: from a case to its mesh with all arrays and its row of the table.
 *
 *     generation (StudyGeneration.h) -> metrics -> case label -> solver, … -> metric summary
 *
 * The pipeline is kept from case to case: only what the case changes executes again, so that
 * sweeping the order of a solver never makes a mesh twice.
 */
#ifndef pemesh_StudyPipeline_h
#define pemesh_StudyPipeline_h

#include "pemeshRunnerModule.h" // For export macro

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace pemesh
{

class MemoryBudget;
class SolverQueue;
struct SolverDescription;
struct Study;
struct StudyCase;

class PEMESHRUNNER_EXPORT StudyPipeline
{
public:
  struct Options
  {
    /** The raw files of the solvers go to a folder for each run in here. */
    std::filesystem::path SolverFolder;
    /** Threads that a solver may use. */
    int Threads = 1;
    /** See vtkPEMExternalSolver. */
    bool ReusesAnswers = false;
    int Retries = 0;
    MemoryBudget* Budget = nullptr;
    SolverQueue* Queue = nullptr;
  };

  /** `solvers` holds the description of every run of the study. `stop` is read at every progress.
   */
  StudyPipeline(const Study& study, const std::vector<SolverDescription>& solvers,
    const Options& options, const std::atomic<bool>& stop);
  ~StudyPipeline();

  /**
   * Executes the pipeline for a case. The failure of the case itself is in the status of the mesh
   * and in the row. Throws std::runtime_error with the filter's message when the configuration is
   * wrong, which will be so for every case.
   */
  void Execute(const StudyCase& studyCase);

  ///@{
  /** Of the last case executed; null before. */
  vtkPolyData* GetMesh();
  vtkTable* GetRow();
  ///@}

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

} // namespace pemesh

#endif

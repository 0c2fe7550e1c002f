// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The workers of this process: threads with a pipeline each, for the cases of a board.
 */
#ifndef pemesh_CaseWorkers_h
#define pemesh_CaseWorkers_h

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

class vtkPolyData;

namespace pemesh
{

class CaseBoard;
class CaseGate;
class MemoryBudget;
class SolverQueue;
class StudyPipeline;
struct SolverDescription;
struct Study;
struct StudyCase;

/** How many threads may this process use, by what it is bound to? At least 1. */
int AvailableCores();

class CaseWorkers
{
public:
  struct Options
  {
    std::filesystem::path Folder;
    std::filesystem::path MeshFolder;
    int Workers = 0; // 0: one a core
    bool Resume = false;
    int Retries = 0;
    /** MiB that all solvers at work may take, and as much the meshes at work here; 0: any. */
    double SolverMemory = 0.0;
  };

  /** All arguments must outlive the workers; `stop` is read at every progress. */
  CaseWorkers(const Study& study, const std::vector<SolverDescription>& solvers,
    const std::vector<StudyCase>& cases, const Options& options, CaseBoard& board,
    std::atomic<bool>& stop);

  /** Waits for them: until the cases are done, or soon after the stop. */
  ~CaseWorkers();

  /**
   * Starts them, no more than there are cases to do, and answers with their number: so many will
   * leave the board.
   */
  std::size_t Start(std::size_t casesToDo);

private:
  int MeshesAtOnce(int atWork, std::size_t casesToDo) const;
  void Work(int threads);
  bool DoNextCase(StudyPipeline& pipeline);
  void DoCase(StudyPipeline& pipeline, const StudyCase& studyCase);
  void WriteMeshes(const StudyCase& studyCase, vtkPolyData* mesh) const;

  const Study& TheStudy;
  const std::vector<SolverDescription>& Solvers;
  const std::vector<StudyCase>& Cases;
  const Options Chosen;
  CaseBoard& Board;
  std::atomic<bool>& Stop;
  std::vector<std::filesystem::path> MeshFiles;
  std::unique_ptr<MemoryBudget> Budget;
  std::unique_ptr<CaseGate> Gate;
  std::unique_ptr<SolverQueue> Queue; // where a solver takes lists
  std::atomic<int> Busy{ 0 };         // workers with a case
  std::vector<std::jthread> Threads;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The cases of a study, done by workers: threads with a pipeline each.
 */
#ifndef pemesh_StudyExecution_h
#define pemesh_StudyExecution_h

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

class vtkPolyData;

namespace pemesh
{

class MemoryBudget;
class SolverQueue;
class StudyFigures;
class StudyJournal;
class StudyPipeline;
class StudyResults;
struct SolverDescription;
struct Study;
struct StudyCase;

class StudyExecution
{
public:
  using Report = std::function<void(double fraction, const std::vector<std::string>& lines)>;

  struct Options
  {
    std::filesystem::path Folder;
    std::filesystem::path MeshFolder;
    int Workers = 0; // 0: one a core
    bool Resume = false;
    int Retries = 0;
    double SolverMemory = 0.0; // MiB, of all solvers at work; 0: any
    bool WritesTables = true;  // while it runs, besides the index
  };

  /** All arguments must outlive the execution; `stop` is read at every progress. */
  StudyExecution(const Study& study, const std::vector<SolverDescription>& solvers,
    const std::vector<StudyCase>& cases, const Options& options, StudyJournal& journal,
    std::atomic<bool>& stop);
  ~StudyExecution();

  /**
   * Does all cases, or those until the stop. Answers with a sentence where the study could not go
   * on, empty otherwise. Throws std::runtime_error where it is wrong for every case. `report` is
   * called in this thread, with what a log should say of each case done since the last call.
   */
  std::string Run(StudyResults& results, StudyFigures& figures, const Report& report);

  int GetNumberOfReusedCases() const { return this->CasesReused; }

private:
  int MeshesAtOnce(int atWork) const;
  void Work(int threads);
  void DoCase(StudyPipeline& pipeline, const StudyCase& studyCase);
  bool ReuseCase(const StudyCase& studyCase, const std::string& key);
  void ExecuteCase(StudyPipeline& pipeline, const StudyCase& studyCase, const std::string& key);
  void WriteMeshes(const StudyCase& studyCase, vtkPolyData* mesh);
  void WaitForWorkers(std::size_t workers, const Report& report);
  void SaveProgress();

  const Study& TheStudy;
  const std::vector<SolverDescription>& Solvers;
  const std::vector<StudyCase>& Cases;
  const Options Chosen;
  StudyJournal& Journal;
  std::atomic<bool>& Stop;
  std::vector<std::filesystem::path> MeshFiles;
  std::unique_ptr<MemoryBudget> Budget;
  std::unique_ptr<SolverQueue> Queue; // where a solver takes lists
  StudyResults* Results = nullptr;
  StudyFigures* Figures = nullptr;
  std::chrono::steady_clock::time_point NextSave;

  // What the workers share.
  std::atomic<std::size_t> NextCase{ 0 };
  std::atomic<int> CasesReused{ 0 };
  std::mutex Mutex;
  std::condition_variable Changed;
  std::size_t CasesDone = 0;
  std::size_t WorkersDone = 0;
  std::vector<std::string> Lines; // of the log, not yet told
  std::string WrongConfiguration;
  std::string Interruption; // why the study cannot go on, though it is not wrong
};

} // namespace pemesh

#endif

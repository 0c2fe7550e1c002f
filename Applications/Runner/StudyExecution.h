// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The cases of a study, in the process that has its journal: dealt to the workers here and, over a
 * desk, to those of other processes; their rows to the journal, the tables from time to time.
 */
#ifndef pemesh_StudyExecution_h
#define pemesh_StudyExecution_h

#include "CaseBoard.h"
#include "CaseWorkers.h"
#include "RankChannel.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace pemesh
{

class RankDesk;
class StudyFigures;
class StudyJournal;
class StudyResults;
struct SolverDescription;
struct Study;
struct StudyCase;

class StudyExecution : public CaseBoard
{
public:
  using Report = std::function<void(double fraction, const std::vector<std::string>& lines)>;

  /**
   * All arguments must outlive the execution; `stop` is read at every progress. Of all cases those
   * of `toDo` are done. Without a `desk` this process is alone. `writesTables`: while it runs,
   * besides the index.
   */
  StudyExecution(const Study& study, const std::vector<SolverDescription>& solvers,
    const std::vector<StudyCase>& cases, const std::vector<int>& toDo,
    const CaseWorkers::Options& options, bool writesTables, StudyJournal& journal, RankDesk* desk,
    std::atomic<bool>& stop);
  ~StudyExecution() override;

  /**
   * Does all cases, or those until the stop. Answers with a sentence where the study could not go
   * on, empty otherwise. Throws std::runtime_error where it is wrong for every case. `report` is
   * called in this thread, with what a log should say of each case done since the last call.
   */
  std::string Run(StudyResults& results, StudyFigures& figures, const Report& report);

  int GetNumberOfReusedCases() const { return this->CasesReused; }

  std::optional<int> Take() override;
  bool Reuse(int index, const std::string& key) override;
  void Bring(const CaseAnswer& answer) override;
  void Refuse(const std::string& sentence) override;
  void Leave() override;

private:
  void CaseIsDone(const std::string& line);
  void ServeDesk();
  bool IsOver(std::size_t workers) const;
  void WaitForWorkers(std::size_t workers, const Report& report);
  void SaveProgress();

  const Study& TheStudy;
  const std::vector<SolverDescription>& Solvers;
  const std::vector<StudyCase>& Cases;
  const std::vector<int>& ToDo;
  const CaseWorkers::Options Chosen;
  const bool WritesTables;
  StudyJournal& Journal;
  RankDesk* Desk;
  std::atomic<bool>& Stop;
  StudyResults* Results = nullptr;
  StudyFigures* Figures = nullptr;
  std::chrono::steady_clock::time_point NextSave;
  RankPace Pace;

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

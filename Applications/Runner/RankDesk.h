// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The first process of a run over several: it has the journal, and deals the cases to the others.
 *
 * Messages are lines of fields (RowText.h), the first of which says what it is. To the first
 * process, which answers those with a number by `reply NUMBER VALUE`:
 *
 *   hello PLACE                    who is there: its machine and the cores that it is bound to
 *   take NUMBER                    a case, please; the value is its index, or nothing
 *   reuse NUMBER INDEX KEY         is it there from an earlier run? 1 or 0
 *   bring INDEX KEY NOT-WRITTEN MESH COLUMNS COLUMN… VALUE…
 *   refuse SENTENCE                wrong for every case
 *   leave                          all its workers have left
 *
 * and from it: `study` with the fields of StudyTask.h, `stop`, and `end`, also in place of a study.
 */
#ifndef pemesh_RankDesk_h
#define pemesh_RankDesk_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pemesh
{

class CaseBoard;
class RankChannel;
struct StudyTask;

class RankDesk
{
public:
  /** The channel must outlive the desk. */
  explicit RankDesk(RankChannel& channel);

  /** Stops the others, if need be, and waits until they have left. */
  ~RankDesk();
  RankDesk(const RankDesk&) = delete;
  RankDesk& operator=(const RankDesk&) = delete;

  /**
   * Waits until all are there, hands them the study, and changes the task to the share of this
   * process: workers, where none are asked for, are one a core, and the memory of the solvers is
   * that of a machine; both are shared by the processes that are bound to the same.
   */
  void Begin(StudyTask& task);

  /** Answers all that has been asked; whether it was anything. */
  bool Serve(CaseBoard& board);

  bool HaveAllLeft() const;

  /** Tells the others to stop, once. */
  void Stop();

private:
  void Tell(const std::string& text);
  void Answer(int rank, const std::vector<std::string>& fields, CaseBoard& board);

  RankChannel& Channel;
  std::map<int, std::string> Places; // of the others, as they are there
  std::size_t Working = 0;           // of the others, those who have a study and have not left
  bool HasStopped = false;
};

} // namespace pemesh

#endif

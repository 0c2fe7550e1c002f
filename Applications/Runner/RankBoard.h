// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the other processes of a run do: their workers take cases from the first one.
 */
#ifndef pemesh_RankBoard_h
#define pemesh_RankBoard_h

#include "CaseBoard.h"
#include "pemeshRunnerModule.h" // For export macro

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace pemesh
{

class RankChannel;

/**
 * Works for the first process of the channel until that has no more cases; to be called in all the
 * others. What goes wrong is told there.
 */
PEMESHRUNNER_EXPORT void WorkForFirstRank(RankChannel& channel);

/** Passes all that workers ask and bring to the first process. */
class RankBoard : public CaseBoard
{
public:
  /** Whether a mesh is wanted there: it is for the figures. */
  using IsWanted = std::function<bool(int index)>;

  RankBoard(RankChannel& channel, IsWanted isWanted, std::atomic<bool>& stop);

  std::optional<int> Take() override;
  bool Reuse(int index, const std::string& key) override;
  void Bring(const CaseAnswer& answer) override;
  void Refuse(const std::string& sentence) override;
  void Leave() override;

  /** Carries messages, in the thread of the channel, until so many workers have left. */
  void Serve(std::size_t workers);

private:
  void Post(const std::string& text);
  std::string Ask(std::vector<std::string> fields);
  void SendPosted();
  void TakeMessage(const std::vector<std::string>& fields);

  RankChannel& Channel;
  IsWanted Wanted;
  std::atomic<bool>& Stop;

  // What the workers share.
  std::mutex Mutex;
  std::condition_variable Changed;
  std::size_t WorkersGone = 0;
  std::deque<std::string> Posted;
  std::map<std::string, std::promise<std::string>> Questions; // by their number
  std::size_t NextQuestion = 0;
};

} // namespace pemesh

#endif

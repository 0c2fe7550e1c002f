// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Messages between the processes of one run, whatever carries them: MPI (Applications/Ranks), or
 * threads in a test.
 */
#ifndef pemesh_RankChannel_h
#define pemesh_RankChannel_h

#include "pemeshRunnerModule.h" // For export macro

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

namespace pemesh
{

struct RankMessage
{
  int Rank = 0; // of the sender
  std::string Text;
};

/** Used by one thread of each process. Messages of one rank to another keep their order. */
class PEMESHRUNNER_EXPORT RankChannel
{
public:
  virtual ~RankChannel();

  /** The number of this process, from 0, and how many there are. */
  virtual int GetRank() const = 0;
  virtual int GetSize() const = 0;

  /** May wait until the other one receives. */
  virtual void Send(int rank, const std::string& text) = 0;

  /** A message that has come; none if there is none. Does not wait. */
  virtual std::optional<RankMessage> Receive() = 0;
};

/**
 * How long to sleep between two looks for messages: a twentieth of the time since the last one
 * came. So nobody burns a core by looking, as MPI does where it waits, and no more than a twentieth
 * of the time is lost.
 */
class RankPace
{
public:
  using Clock = std::chrono::steady_clock;

  void SomethingCame() { this->Last = Clock::now(); }

  Clock::duration Pause() const
  {
    constexpr int part = 20;
    constexpr std::chrono::microseconds least{ 50 };
    constexpr std::chrono::microseconds most{ 5000 };
    return std::clamp<Clock::duration>((Clock::now() - this->Last) / part, least, most);
  }

private:
  Clock::time_point Last = Clock::now();
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Keeps solvers that run at the same time within the memory of the machine.
 */
#ifndef pemesh_MemoryBudget_h
#define pemesh_MemoryBudget_h

#include "pemeshFiltersSolversModule.h" // For export macro

#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <string>

namespace pemesh
{

/**
 * A solver asks before it starts and waits until there is room, first come, first served. What it
 * needs is its memory limit; where it has none, what it took at most so far and a quarter more;
 * and the first time, when nobody knows, all: it runs alone. One whose need is larger than the
 * budget runs alone as well. All functions may be called from any thread.
 */
class PEMESHFILTERSSOLVERS_EXPORT MemoryBudget
{
public:
  explicit MemoryBudget(double bytes);

  /**
   * Waits for room and answers with the bytes taken, to be given back; negative where `goOn`, asked
   * ten times a second, says no.
   */
  double Take(const std::string& solver, double limit, const std::function<bool()>& goOn);

  /** `peak` is what the solver took at most; 0 where nobody knows, from which nothing is learnt. */
  void GiveBack(const std::string& solver, double taken, double peak);

private:
  double NeedOf(const std::string& solver, double limit) const;

  const double Bytes;
  double Used = 0.0;
  std::map<std::string, double> Peaks;
  std::list<std::string> Waiting; // solvers, first come, first served
  std::mutex Mutex;
  std::condition_variable Changed;
};

} // namespace pemesh

#endif

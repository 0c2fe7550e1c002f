// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MemoryBudget.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pemesh
{

namespace
{

/** A place in the queue, left on every way out: those behind must not wait for one who is gone. */
class Turn
{
public:
  Turn(std::list<std::string>& queue, const std::string& solver, std::condition_variable& changed)
    : Queue(queue)
    , Place(queue.insert(queue.end(), solver))
    , Changed(changed)
  {
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn()
  {
    this->Queue.erase(this->Place);
    this->Changed.notify_all();
  }
  bool HasCome() const { return this->Queue.begin() == this->Place; }

private:
  std::list<std::string>& Queue;
  std::list<std::string>::iterator Place;
  std::condition_variable& Changed;
};

/** A lock that is open for a moment. */
class Unlocked
{
public:
  explicit Unlocked(std::unique_lock<std::mutex>& lock)
    : Lock(lock)
  {
    this->Lock.unlock();
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked() { this->Lock.lock(); }

private:
  std::unique_lock<std::mutex>& Lock;
};

} // namespace

MemoryBudget::MemoryBudget(double bytes)
  : Bytes(bytes)
{
}

double MemoryBudget::NeedOf(const std::string& solver, double limit) const
{
  const auto peak = this->Peaks.find(solver);
  constexpr double more = 1.25; // the next mesh may be larger
  const double need = limit > 0.0 ? limit
    : peak == this->Peaks.end()   ? this->Bytes
                                  : more * peak->second;
  return std::min(std::ceil(need), this->Bytes); // whole numbers add up exactly
}

double MemoryBudget::Take(
  const std::string& solver, double limit, const std::function<bool()>& goOn)
{
  std::unique_lock lock(this->Mutex);
  const Turn turn(this->Waiting, solver, this->Changed);
  double need = this->NeedOf(solver, limit);
  while (!turn.HasCome() || this->Used + need > this->Bytes)
  {
    constexpr std::chrono::milliseconds longest{ 100 };
    this->Changed.wait_for(lock, longest);
    need = this->NeedOf(solver, limit); // more is known now, perhaps
    const Unlocked unlocked(lock);
    if (!goOn())
    {
      return -1.0;
    }
  }
  this->Used += need;
  return need;
}

void MemoryBudget::GiveBack(const std::string& solver, double taken, double peak)
{
  const std::scoped_lock lock(this->Mutex);
  this->Used = std::max(0.0, this->Used - taken);
  if (peak > 0.0) // else nothing was measured, and nothing is learnt
  {
    double& largest = this->Peaks[solver];
    largest = std::max(largest, peak);
  }
  this->Changed.notify_all();
}

} // namespace pemesh

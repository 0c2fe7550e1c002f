// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MemoryBudget.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pemesh
{

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
  const int number = this->NextNumber++;
  this->Waiting.push_back(number);
  double need = this->NeedOf(solver, limit);
  bool isWanted = true;
  while (isWanted && (this->Waiting.front() != number || this->Used + need > this->Bytes))
  {
    constexpr std::chrono::milliseconds longest{ 100 };
    this->Changed.wait_for(lock, longest);
    need = this->NeedOf(solver, limit); // more is known now, perhaps
    lock.unlock();
    isWanted = goOn();
    lock.lock();
  }
  this->Waiting.remove(number);
  this->Used += isWanted ? need : 0.0;
  this->Changed.notify_all();
  return isWanted ? need : -1.0;
}

void MemoryBudget::GiveBack(const std::string& solver, double taken, double peak)
{
  const std::scoped_lock lock(this->Mutex);
  this->Used = std::max(0.0, this->Used - taken);
  double& largest = this->Peaks[solver];
  largest = std::max(largest, peak);
  this->Changed.notify_all();
}

} // namespace pemesh

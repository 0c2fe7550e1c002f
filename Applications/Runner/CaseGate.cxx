// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseGate.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <sys/resource.h>

namespace pemesh
{

double PeakMemory()
{
  constexpr double kibiByte = 1024.0;
  rusage usage = {};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? kibiByte * static_cast<double>(usage.ru_maxrss)
                                             : 0.0;
}

CaseGate::CaseGate(double bytes, std::function<double()> peak)
  : Bytes(bytes)
  , Peak(std::move(peak))
  , Base(this->Peak())
{
}

int CaseGate::Most() const
{
  if (this->Bytes <= 0.0)
  {
    return std::numeric_limits<int>::max();
  }
  constexpr double many = 1e6;
  const double fitting =
    this->Need > 0.0 ? (this->Bytes - this->Base) / this->Need : (this->MostInside > 0 ? many : 1);
  return static_cast<int>(std::clamp(fitting, 1.0, many));
}

int CaseGate::GetMost()
{
  const std::scoped_lock lock(this->Mutex);
  return this->Most();
}

void CaseGate::Enter()
{
  std::unique_lock lock(this->Mutex);
  this->Changed.wait(lock, [this] { return this->Inside < this->Most(); });
  ++this->Inside;
}

void CaseGate::Leave()
{
  const std::scoped_lock lock(this->Mutex);
  this->MostInside = std::max(this->MostInside, this->Inside);
  this->Need = std::max(this->Need, (this->Peak() - this->Base) / this->MostInside);
  --this->Inside;
  this->Changed.notify_all();
}

} // namespace pemesh

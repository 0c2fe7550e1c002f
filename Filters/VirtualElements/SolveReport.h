// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the stages of a solution report, and how they learn that nobody wants it any more. Private
 * to the module.
 */
#ifndef pemesh_SolveReport_h
#define pemesh_SolveReport_h

#include "VirtualElementMethod.h"

#include <chrono>

namespace pemesh
{

/** Used in one thread, that of the caller. */
class SolveReport
{
public:
  explicit SolveReport(const SolveProgress& progress)
    : Progress(progress)
  {
  }

  /** So much is done. Throws SolveAborted. */
  void Tell(double fraction)
  {
    this->Fraction = fraction;
    const bool goesOn = !this->Progress || this->Progress(fraction);
    this->Last = Clock::now();
    if (!goesOn)
    {
      throw SolveAborted();
    }
  }

  /** In the middle of a stage, as often as one likes: it asks ten times a second. */
  void Check()
  {
    constexpr std::chrono::milliseconds interval{ 100 };
    if (Clock::now() - this->Last > interval)
    {
      this->Tell(this->Fraction);
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  const SolveProgress& Progress;
  double Fraction = 0.0;
  Clock::time_point Last = Clock::now();
};

} // namespace pemesh

#endif

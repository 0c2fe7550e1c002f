// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Keeps the meshes that are worked on at the same time within the memory of the machine.
 */
#ifndef pemesh_CaseGate_h
#define pemesh_CaseGate_h

#include "pemeshRunnerModule.h" // For export macro

#include <condition_variable>
#include <functional>
#include <mutex>

namespace pemesh
{

/** The most memory that this process has had, in bytes; 0 where the system does not say. */
double PeakMemory();

/**
 * As many cases are let in as fit into the budget, one at least. What one takes is learnt: the
 * first is alone, and from then on it is the growth of the peak memory by the cases that were in at
 * the same time. May be called from any thread.
 */
class PEMESHRUNNER_EXPORT CaseGate
{
public:
  /** `bytes` for this process, 0: any; `peak` answers with the most memory that it has had. */
  CaseGate(double bytes, std::function<double()> peak);

  void Enter();
  void Leave();

  /** From Enter to Leave, also where something is thrown; of no gate, nothing. */
  class Visit
  {
  public:
    explicit Visit(CaseGate* gate)
      : Gate(gate)
    {
      if (gate)
      {
        gate->Enter();
      }
    }
    ~Visit()
    {
      if (this->Gate)
      {
        this->Gate->Leave();
      }
    }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

  private:
    CaseGate* Gate;
  };

  /** How many may be in at the same time, by what is known. */
  int GetMost();

private:
  int Most() const;

  const double Bytes;
  const std::function<double()> Peak;
  double Base;       // what the process takes without cases
  double Need = 0.0; // of one case; 0: nobody knows
  int Inside = 0;
  int MostInside = 0;
  std::mutex Mutex;
  std::condition_variable Changed;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a rule works on.
 */
#ifndef pemesh_AgglomerationState_h
#define pemesh_AgglomerationState_h

#include "ElementMerger.h"
#include "Parameter.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pemesh
{

struct Metric;

/** Elements are numbered along a Hilbert curve (MeshOrder.h), whatever the order of the input. */
struct AgglomerationState
{
  ElementMerger& Merger;
  const std::vector<bool>& Placed; ///< an element each: of a placed polygon
  bool KeepPlaced;
  int Target;     ///< stop at this number of groups; at least 1
  bool HasTarget; ///< false: the target is 1 because none was set
  const pemesh::Metric* Metric;
  const ParameterValues& Parameters;
  const std::function<bool(double)>& Progress;
  std::string Problem; ///< why the rule cannot work on this mesh; empty if it can

  bool IsKept(int group) const { return this->KeepPlaced && this->Placed[group]; }
  bool IsDone() const { return this->Merger.GetNumberOfGroups() <= this->Target; }

  /** To be asked often: reports now and then; false once the caller wants to stop. */
  bool GoesOn()
  {
    constexpr int Every = 1024;
    if (++this->Calls % Every != 0 || !this->Progress)
    {
      return true;
    }
    const double all = this->Merger.GetMesh().NumberOfElements();
    const double merged = all - this->Merger.GetNumberOfGroups();
    return this->Progress(all > this->Target ? merged / (all - this->Target) : 1.0);
  }

  std::uint64_t Calls = 0;
};

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The errors of a virtual element solution whose exact solution is known. Private to the module.
 */
#ifndef pemesh_VirtualElementMethodErrors_h
#define pemesh_VirtualElementMethodErrors_h

#include "VirtualElementMethodSystem.h"

namespace pemesh
{

/** Fills the relative errors of `result` from its Solution and GroundTruth. */
void ComputeErrors(const VirtualElementMesh& mesh, const VirtualElementParts& parts,
  const TestProblem& problem, const VirtualElementOptions& options, VirtualElementResult& result);

} // namespace pemesh

#endif

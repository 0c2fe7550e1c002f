// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The functions of the table of rules, each in a source of its own. All answer false if they were
 * stopped, and merge until the target of the state is reached or nothing more can be merged.
 */
#ifndef pemesh_RuleFunctions_h
#define pemesh_RuleFunctions_h

namespace pemesh
{

struct AgglomerationState;

bool MergeByDiameter(AgglomerationState& state);
bool MergeAtRandom(AgglomerationState& state);
bool MergeByQuality(AgglomerationState& state);
bool MergeByMetis(AgglomerationState& state);
bool MergeByCurve(AgglomerationState& state);

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * From a partition of the elements, as any partitioner makes it, to groups that are simple
 * polygons.
 */
#ifndef pemesh_PartMerger_h
#define pemesh_PartMerger_h

#include "AgglomerationState.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <vector>

namespace pemesh
{

/**
 * Repairs a partition that may have empty parts, parts in pieces, with holes and with pinches:
 *
 * 1. An empty part takes half of the part with the most elements.
 * 2. Each part is grown element by element as far as it stays a simple polygon; what is left of it
 *    is grown again, as a fragment. A part that is a disc already is grown whole, in whatever
 * order, because every shelling of a disc can be continued (G. Danaraj, V. Klee, A representation
 * of 2-dimensional pseudomanifolds and its use in the design of a linear-time shelling algorithm,
 *    Annals of Discrete Mathematics 2 (1978) 53-63).
 * 3. While there are too many groups, the lightest fragment, or where there is none the lightest
 *    group, joins the neighbour with which it has the most sides in common.
 *
 * `part` says of each element its part, -1 of those that stay as they are; `weights`, an element
 * each, what is to be even. The number of groups wanted is that of the state; it is met exactly
 * unless the rest cannot be merged (an element that would close a ring around a kept one).
 * False if it was stopped.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT bool MergeParts(
  AgglomerationState& state, std::vector<int>& part, int parts, const std::vector<int>& weights);

} // namespace pemesh

#endif

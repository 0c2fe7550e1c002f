// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Which elements are neighbours, as a graph in the form of METIS, and its partition by METIS.
 */
#ifndef pemesh_DualGraph_h
#define pemesh_DualGraph_h

#include "ElementMerger.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <vector>

namespace pemesh
{

struct DualGraph
{
  std::vector<std::int32_t> Offsets = { 0 }; ///< one more than nodes
  std::vector<std::int32_t> Neighbors;       ///< node after node, each neighbour once
  std::vector<std::int32_t> Weights;         ///< a node each; empty: all alike
  std::vector<int> Elements;                 ///< a node each: which element it is

  int NumberOfNodes() const { return static_cast<int>(this->Offsets.size()) - 1; }
};

/** The graph of the elements that are not left out, before any was merged. */
PEMESHFILTERSAGGLOMERATION_EXPORT DualGraph MakeDualGraph(
  ElementMerger& merger, const std::function<bool(int)>& isLeftOut);

/** The number of edges whose ends are in different parts. */
PEMESHFILTERSAGGLOMERATION_EXPORT long CountCutEdges(
  const DualGraph& graph, const std::vector<int>& parts);

/**
 * Parts of about equal weight by one call of METIS_PartGraphKway. The same for the same seed.
 *
 * METIS draws from rand() of the C library, which all threads share: one call at a time is let
 * through.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT std::vector<int> PartitionPlainly(
  const DualGraph& graph, int parts, int seed);

/**
 * The same in three steps: blocks of some hundred parts each by METIS_PartGraphKway, blocks of so
 * few parts that a set of their nodes is a machine word by METIS_PartGraphRecursive, and the parts
 * of those by PartitionSmallGraph: where parts have but a few nodes, most of the time of METIS goes
 * into its last bisections. Faster, and cuts fewer edges. `progress` gets the fraction done; if it
 * says to stop, the result is empty.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT std::vector<int> PartitionByBlocks(
  const DualGraph& graph, int parts, int seed, const std::function<bool(double)>& progress = {});

} // namespace pemesh

#endif

// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Partitions of graphs so small that a set of nodes is one machine word.
 *
 * By recursive bisection: halves are grown from nodes that are far from each other, each is
 * improved by moving nodes to and fro, and the one that cuts fewest edges is taken. For some tens
 * of nodes this needs no coarsening, and no memory: METIS takes several times as long.
 *
 * References: B. W. Kernighan, S. Lin, An efficient heuristic procedure for partitioning graphs,
 * Bell Syst. Tech. J. 49 (1970) 291-307, doi:10.1002/j.1538-7305.1970.tb01770.x;
 * C. M. Fiduccia, R. M. Mattheyses, A linear-time heuristic for improving network partitions, Proc.
 * 19th Design Automation Conference (1982) 175-181, doi:10.1109/DAC.1982.1585498.
 */
#ifndef pemesh_SmallPartition_h
#define pemesh_SmallPartition_h

#include "DualGraph.h"

#include <vector>

namespace pemesh
{

constexpr int SmallGraphNodes = 64; ///< at most

/**
 * Parts of about equal weight with few edges between them: a node each, the part it is in. Where
 * that can be reached, the sides of a bisection differ from their shares by at most the heaviest
 * node, and by at most half the smaller share. With fewer nodes than parts some parts are empty.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT std::vector<int> PartitionSmallGraph(
  const DualGraph& graph, int parts);

} // namespace pemesh

#endif

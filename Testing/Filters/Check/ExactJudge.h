// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * An independent judge of the mesh checks: brute force over all pairs, in rational arithmetic. It
 * shares no code with them.
 */
#ifndef pemesh_ExactJudge_h
#define pemesh_ExactJudge_h

#include "PolygonMesh.h"

#include <set>
#include <utility>
#include <vector>

struct ExactVerdict
{
  std::set<int> Flat;      ///< fewer than three places, or no two sides span an area
  std::set<int> Crossing;  ///< not simple, by CGAL
  std::set<int> Clockwise; ///< simple and of negative area
  std::set<std::pair<int, int>> Duplicates; ///< the smallest equal point, the copy
  std::set<std::pair<int, int>> Overlaps;   ///< the intersection has an area
  /** Below: all elements as counter-clockwise cycles of places. */
  std::set<std::pair<int, int>> ConflictingSides; ///< in one direction by two simple elements
  std::set<std::pair<int, int>> Junctions;        ///< an element, a border vertex inside its side
  std::set<int> Pinched;                          ///< the elements around it fall into several fans
  int Components = 0;                             ///< joined by sides
  int Holes = 0;                                  ///< components less Euler's characteristic
};

/** All vertex numbers must be in range and all coordinates finite. */
ExactVerdict JudgeExactly(const pemesh::PolygonMesh& mesh);

#endif

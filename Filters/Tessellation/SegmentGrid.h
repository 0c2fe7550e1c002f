// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Finds the segments that come near another segment, by a grid of buckets.
 */
#ifndef pemesh_SegmentGrid_h
#define pemesh_SegmentGrid_h

#include "Point2.h"

#include <functional>
#include <vector>

namespace pemesh
{

struct Segment
{
  Point2 From;
  Point2 To;
};

class SegmentGrid
{
public:
  /** About `buckets` buckets over the bounding box of the segments, grown by `margin`. */
  SegmentGrid(const std::vector<Segment>& segments, double margin, double buckets);

  /**
   * The numbers, ascending, of all segments that come within the margin of this one, and of others.
   * Not from two threads at once.
   */
  const std::vector<int>& FindNear(const Segment& segment);

private:
  /** Calls for each bucket that comes within a distance of the segment. */
  template <typename Visitor>
  void ForBuckets(const Segment& segment, double distance, const Visitor& visit) const;

  Point2 Low;
  double Side = 1.0;
  int Columns = 1;
  int Rows = 1;
  std::vector<int> First; ///< the first entry of each bucket in Entries, and the end
  std::vector<int> Entries;
  std::vector<int> Found;
};

} // namespace pemesh

#endif

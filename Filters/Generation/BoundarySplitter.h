// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Splits the segments of a triangulation under refinement: which, where, and in what order.
 *
 * A segment is encroached, and has to be split, if a vertex lies inside its diametral circle. It
 * is split in the middle; but from an input vertex where the domain's angle is below 90 degrees at
 * a power of two, so that the pieces of both its segments match (Ruppert's concentric shells).
 *
 * Where the domain's angle is below 60 degrees, splitting one segment makes a vertex that
 * encroaches on the other, for ever nearer to the corner. Such a corner is opened when one of its
 * segments is first to be split: from then on both are equally long and split together, and the
 * isosceles triangle they span is not parted. For the sake of a flat triangle they are split only
 * if that makes no edge shorter than the shortest edge of that triangle; so angles alone never
 * shorten the shortest edge around a small corner. (Compare the rule of Miller, Pav and Walkington
 * 2005, who leave flat triangles next to such corners; here only the isosceles one stays.)
 */
#ifndef pemesh_BoundarySplitter_h
#define pemesh_BoundarySplitter_h

#include "DomainTriangulation.h"
#include "RefinableTriangulation.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace pemesh
{

class BoundarySplitter
{
public:
  /**
   * `preserved` says of each input segment that it must not be split; it is the same for all
   * segments of a loop. `afterInsertion` is called whenever the triangulation has a new star.
   */
  BoundarySplitter(RefinableTriangulation& mesh, const DomainBoundary& boundary,
    const std::vector<bool>& preserved, std::function<void()> afterInsertion);

  /** False for preserved segments and for those too short to be split. */
  bool CanSplit(int segment) const;

  /** Whether the vertex is an end of preserved segments. */
  bool IsPreservedVertex(int vertex) const;

  /**
   * Whether a vertex lies inside the segment's diametral circle. At an open corner any vertex that
   * parts the isosceles triangle counts as well.
   */
  bool IsEncroached(int segment) const;

  bool IsOpenCorner(int vertex) const;

  /** Whether the open corner of a segment may be split for a triangle with that shortest edge. */
  bool CornerMayShrink(int segment, double squaredShortest) const;

  ///@{
  /**
   * Segments wait in a queue to be split: if still encroached then, or, if forced, in any case.
   * NumberWaiting and ForgetSince take back what was added since.
   */
  void Enqueue(int segment, bool forced);
  std::size_t NumberWaiting() const { return this->Waiting.size(); }
  void ForgetSince(std::size_t numberWaiting);
  ///@}

  /** Splits until none is waiting, or `proceed`, called after each, says no: then false. */
  bool SplitWaiting(const std::function<bool()>& proceed);

  /**
   * Segments are not split, and triangles should not be refined for their angles, where edges are
   * far below the smallest feature of the input: the square of that length.
   */
  double GetSquaredSmallestEdge() const { return this->SquaredSmallestEdge; }

private:
  struct WaitingSegment
  {
    int Segment;
    int From;
    int To;
    bool Forced;
  };

  void ClassifyCorners();
  double SquaredSmallestFeature() const;
  bool IsInputVertex(int vertex) const
  {
    return vertex < static_cast<int>(this->Boundary.Points.size());
  }
  bool IsAcuteCorner(int vertex) const;
  bool MayOpen(int vertex) const;

  std::array<int, 2> EndsOf(int segment) const;
  double LengthOf(int segment) const;
  int CornerOf(int segment) const;
  std::array<int, 2> CornerSegments(int corner) const;

  Point2 PointAt(double distance, int end, int otherEnd) const;
  void OpenCorner(int corner);
  void SplitCorner(int corner, double radius);
  void SplitSegment(int segment);
  void SplitAt(int segment, const Point2& point);

  RefinableTriangulation& Mesh;
  const DomainBoundary& Boundary;
  const std::vector<bool>& Preserved;
  std::function<void()> AfterInsertion;
  std::vector<bool> IsAcute;     ///< an input vertex each: an angle below 90 degrees
  std::vector<bool> IsSmall;     ///< an input vertex each: an angle below 60 degrees
  std::vector<bool> IsOpen;      ///< an input vertex each: see OpenCorner
  std::vector<int> EndingAt;     ///< an input vertex each: the segment that ends there
  std::vector<bool> CannotSplit; ///< a segment each: too short
  std::vector<WaitingSegment> Waiting;
  double SquaredSmallestEdge = 0.0;
};

} // namespace pemesh

#endif

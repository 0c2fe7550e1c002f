// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the refinement knows of the input: where its angles are small, and how segments are split.
 */
#ifndef pemesh_InputCorners_h
#define pemesh_InputCorners_h

#include "DomainTriangulation.h"
#include "RefinableTriangulation.h"

#include <vector>

namespace pemesh
{

class InputCorners
{
public:
  InputCorners(const RefinableTriangulation& mesh, const DomainBoundary& boundary);

  /** Whether the domain has an angle below 60 degrees at the vertex. */
  bool IsSmallCorner(int vertex) const
  {
    return this->IsInputVertex(vertex) && this->IsSmall[vertex];
  }

  /**
   * Where the segment from-to is split: in the middle, but at a power of two from an end that is
   * the vertex of an acute input angle, so that both of its segments are split alike.
   */
  Point2 SplitPoint(int from, int to) const;

  /** The power of two that is nearest (as a ratio) to half the length. */
  static double ShellRadius(double length);

  /** The point at that distance from one end of a segment. */
  Point2 PointAt(double distance, int end, int otherEnd) const;

  /**
   * The square of the shortest distance between two vertices, or of a vertex from a segment, that
   * see each other in the triangulation as it is now.
   */
  double SquaredSmallestFeature() const;

private:
  bool IsInputVertex(int vertex) const
  {
    return vertex < static_cast<int>(this->Boundary.Points.size());
  }

  const RefinableTriangulation& Mesh;
  const DomainBoundary& Boundary;
  std::vector<bool> IsAcute; ///< an input vertex each: an angle below 90 degrees
  std::vector<bool> IsSmall; ///< an input vertex each: an angle below 60 degrees
};

} // namespace pemesh

#endif
